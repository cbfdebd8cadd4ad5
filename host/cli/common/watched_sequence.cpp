#include "host/cli/common/watched_sequence.hpp"

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "host/check/checks.hpp"
#include "host/check/noise.hpp"
#include "host/check/projection.hpp"
#include "host/cli/common/frame_views.hpp"
#include "host/cli/common/progress.hpp"

namespace quell::cli {
namespace {

/// Frames that are looked at, the first that are read: three pairs for what takes two.
constexpr int kCheckedFrames = 4;

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
  void requireReadable(const std::vector<int>& frames) const override { m_sequence->requireReadable(frames); }
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
    for (const io::FrameWarning& warning : data.warnings)
      tell(kindOf(warning), warning.file, warning.expected, warning.got, warning.remedy);
    if (m_checked < kCheckedFrames) check(data);
    data.repeatsNoise = m_frozen && check::isStill(viewOf(data));
    return data;
  }

 private:
  bool showsJitter() const {
    return check::rayOffsetPx(viewOf(m_sequence->read(m_sequence->frames().front()))) > check::kCentredRaysPx;
  }

  void check(const io::FrameData& data) const {
    check::Frame before;
    if (m_last) before = viewOf(*m_last);
    const check::Result result = check::checkFrame(viewOf(data), m_last ? &before : nullptr);
    for (const check::MappedFinding& found : result.findings) {
      const Finding& finding = found.finding;
      m_frozen = m_frozen || finding.kind == check::kFrozenNoiseKind;
      if (finding.severity > Severity::Note)
        tell(finding.kind, fileOfImage(*m_sequence, data.number, finding.image), finding.expected,
             gotText(finding), finding.cure);
    }
    ++m_checked;
    m_last = m_checked < kCheckedFrames ? std::optional<io::FrameData>(data) : std::nullopt;
  }

  void tell(const std::string& kind, const std::string& file, const std::string& expected,
            const std::string& got, const std::string& remedy) const {
    if (m_told.insert(kind).second) warn(file, expected, got, remedy);
  }

  std::unique_ptr<io::FrameSequence> m_sequence;
  // Found on first use: it takes a frame.
  mutable std::optional<bool> m_jittered;
  // Reading changes what was seen and said, not what is read.
  mutable std::optional<io::FrameData> m_last;
  mutable int m_checked = 0;
  mutable bool m_frozen = false;
  mutable std::set<std::string> m_told;  // kinds
};

}  // namespace

std::unique_ptr<io::FrameSequence> openWatched(const std::string& path, const io::SequenceOptions& options) {
  return std::make_unique<WatchedSequence>(io::openSequence(path, options));
}

}  // namespace quell::cli
