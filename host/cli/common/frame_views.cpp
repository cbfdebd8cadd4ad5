#include "host/cli/common/frame_views.hpp"

#include "host/io/camera_file.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::cli {
namespace {

/// What findings about cameras are about.
constexpr char kCamera[] = "camera";

}  // namespace

check::Image viewOf(const io::Image& image) {
  if (image.empty()) return {};
  return {image.pixels.data(), image.width, image.height, image.channels};
}

check::Frame viewOf(const io::FrameData& frame) {
  check::Frame view;
  view.number = frame.number;
  view.camera = frame.camera;
  view.demodulated = frame.demodulated;
  for (const io::FrameWarning& warning : frame.warnings)
    if (warning.kind == io::FrameWarning::Kind::Camera) view.cameraKnown = false;
  forEachInput(frame, view, [](const ImageFacts&, const io::Image& image, check::Image& target) {
    target = viewOf(image);
  });
  return view;
}

std::string kindOf(const io::FrameWarning& warning) {
  switch (warning.kind) {
    case io::FrameWarning::Kind::CameraConvention:
      return "camera-convention";
    case io::FrameWarning::Kind::MissingFrames:
      return "frames-missing";
    case io::FrameWarning::Kind::Windows:
      return "windows-differ";
    case io::FrameWarning::Kind::Camera:
      break;
  }
  return "camera-unknown";
}

std::string fileOfImage(const io::FrameSequence& sequence, int frame, const std::string& image) {
  for (const auto& facts : kInputs<io::FrameData>)
    if (image == facts.name) return sequence.fileOf(frame, facts.files);
  if (image == kCamera && io::hasFile(sequence.name(), io::kCyclesCameraFile))
    return io::joinPath(sequence.name(), io::kCyclesCameraFile);
  return sequence.name();
}

}  // namespace quell::cli
