#include "host/cli/denoise/further_outputs.hpp"

#include <utility>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/io/image_sources.hpp"
#include "host/io/plain_image.hpp"

namespace quell::cli {
namespace {

constexpr char kMethod[] = "quell";
constexpr char kDenoised[] = "Denoised", kAccumulated[] = "Accumulated";
constexpr ImageFiles kColor = factsOf(&io::FrameData::radiance).files;
constexpr ImageFiles kNormal = factsOf(&io::FrameData::normalWorld).files;

std::vector<std::string> lettersOf(const std::string& letters) {
  std::vector<std::string> names;
  for (const char letter : letters) names.emplace_back(1, letter);
  return names;
}

/// The images of a frame that has a file for each.
std::vector<io::NamedPass> passesOf(const io::FrameData& frame, int signals) {
  std::vector<io::NamedPass> passes;
  for (const io::ImageSource& source : io::imageSources(signals)) {
    const io::Image& image = frame.*source.image;
    const std::vector<std::string> letters = lettersOf(source.files.channels);
    if (image.channels == int(letters.size()) && source.files.stem[0] != '\0')
      passes.push_back({source.files.stem, letters, image, io::exrTypeOf(source.files.samples)});
  }
  return passes;
}

}  // namespace

Settings accumulationSettings(const Settings& settings, const io::FrameSequence& sequence) {
  Settings accumulation = settings.method() == kMethod ? settings : defaultSettings(kMethod, sequence);
  accumulation.set("iterations", 0);
  accumulation.set("taa", "off");
  return accumulation;
}

FurtherOutputWriter::FurtherOutputWriter(FurtherOutputs outputs, const OutputFiles& files,
                                         const io::FrameSequence& sequence, int signals,
                                         std::unique_ptr<DenoiseSession> accumulation)
    : m_outputs(outputs),
      m_files(files),
      m_sequence(sequence),
      m_signals(signals),
      m_accumulation(std::move(accumulation)) {}

void FurtherOutputWriter::write(const io::FrameData& frame, const DenoisedFrame& denoised) {
  if (m_outputs.pfm) io::writePfm(m_files.path("denoised", frame.number, "pfm"), denoised.linear);
  io::Image accumulated;
  if (m_accumulation) accumulated = m_accumulation->denoise(frame).linear;
  if (m_outputs.accumulated) m_files.writeLinear("accumulated", frame, accumulated);
  if (m_outputs.multilayer) writeMultilayer(frame, denoised, accumulated);
}

void FurtherOutputWriter::preroll(const io::FrameData& frame) {
  if (m_accumulation) m_accumulation->denoise(frame);
}

void FurtherOutputWriter::writeMultilayer(const io::FrameData& frame, const DenoisedFrame& denoised,
                                          const io::Image& accumulated) const {
  const std::string color = m_sequence.fileOf(frame.number, kColor);
  const bool oneFile = color == m_sequence.fileOf(frame.number, kNormal);
  // Without one file to go by, the denoised picture is what programs show that know no passes.
  const std::string base = oneFile ? color : m_files.path("denoised", frame.number, "exr");
  const std::vector<std::string> channels = io::readExrHeader(base).channels;
  std::vector<io::NamedPass> passes;
  if (!oneFile) passes = passesOf(frame, m_signals);
  if (oneFile)
    passes.push_back(
        {io::passBeside(channels, kDenoised), lettersOf("RGB"), denoised.linear, m_files.samples()});
  if (!accumulated.empty())
    passes.push_back(
        {io::passBeside(channels, kAccumulated), lettersOf("RGB"), accumulated, m_files.samples()});
  io::writeWithPasses(base, m_files.path("multilayer", frame.number, "exr"), passes);
}

}  // namespace quell::cli
