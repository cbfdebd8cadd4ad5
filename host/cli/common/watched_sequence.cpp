#include "host/cli/common/watched_sequence.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>

#include "host/cli/common/noise_watch.hpp"
#include "host/cli/common/normal_check.hpp"
#include "host/cli/common/progress.hpp"
#include "host/cli/common/ray_jitter.hpp"

namespace quell::cli {
namespace {

using Kind = io::FrameWarning::Kind;

io::FrameWarning frozenNoise(const std::string& file, double correlation) {
  return {Kind::FrozenNoise, file, "noise of its own in every frame",
          fmt::format("noise like that of the frame before (correlation {:.2f})", correlation),
          "goes on without history where the view is still; render with another seed for every frame "
          "(Blender: the "
          "clock beside Sampling > Advanced > Seed)"};
}

class WatchedSequence final : public io::FrameSequence {
 public:
  explicit WatchedSequence(std::unique_ptr<io::FrameSequence> sequence) : m_sequence(std::move(sequence)) {}

  std::string name() const override { return m_sequence->name(); }
  int width() const override { return m_sequence->width(); }
  int height() const override { return m_sequence->height(); }
  std::vector<int> frames() const override { return m_sequence->frames(); }
  std::string fileOf(int frame, const ImageFiles& files) const override {
    return m_sequence->fileOf(frame, files);
  }
  bool hasReference(int frame, io::ReferenceKind kind) const override {
    return m_sequence->hasReference(frame, kind);
  }
  io::Reference reference(int frame, io::ReferenceKind kind) const override {
    return m_sequence->reference(frame, kind);
  }
  bool jittered() const override {
    if (!m_jittered) m_jittered = m_sequence->jittered() || showsJitter();
    return *m_jittered;
  }
  std::vector<std::string> describeChannels() const override { return m_sequence->describeChannels(); }
  std::optional<io::HistoryLimits> historyLimits() const override { return m_sequence->historyLimits(); }

  io::FrameData read(int frame) const override {
    io::FrameData data = m_sequence->read(frame);
    constexpr ImageFiles kNormal = factsOf(&io::FrameData::normalWorld).files;
    constexpr ImageFiles kRadiance = factsOf(&io::FrameData::radiance).files;
    if (auto warning = checkNormals(data, fileOf(frame, kNormal)))
      data.warnings.push_back(std::move(*warning));
    const NoiseWatch::Result noise = m_noise.add(data);
    data.repeatsNoise = noise.repeats;
    if (noise.frozen) data.warnings.push_back(frozenNoise(fileOf(frame, kRadiance), noise.correlation));
    for (const io::FrameWarning& warning : data.warnings)
      if (m_told.insert(warning.kind).second) warn(warning);
    return data;
  }

 private:
  bool showsJitter() const {
    return rayOffsetPx(m_sequence->read(m_sequence->frames().front())) > kCentredRaysPx;
  }

  std::unique_ptr<io::FrameSequence> m_sequence;
  // Found on first use: it takes a frame.
  mutable std::optional<bool> m_jittered;
  // Reading changes what was seen and said, not what is read.
  mutable NoiseWatch m_noise;
  mutable std::set<Kind> m_told;
};

}  // namespace

std::unique_ptr<io::FrameSequence> openWatched(const std::string& path, const io::SequenceOptions& options) {
  return std::make_unique<WatchedSequence>(io::openSequence(path, options));
}

}  // namespace quell::cli
