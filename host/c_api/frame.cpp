#include "host/c_api/frame.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "host/c_api/boundary.hpp"
#include "host/core/image_schema.hpp"

namespace quell::c_api {
namespace {

[[noreturn]] void refuseEnumerator(const char* function, const std::string& field, const char* expected,
                                   std::int32_t got) {
  throw Error(ErrorCode::InvalidArgument, {function, field, expected, std::to_string(got)});
}

Sum toSum(quell_sum sum, const char* function, const char* name) {
  switch (sum) {
    case QUELL_NO_SUM:
      return Sum::None;
    case QUELL_COUNT_IN_FOURTH:
      return Sum::CountInFourth;
    case QUELL_OVER_SAMPLE_COUNT:
      return Sum::OverSampleCount;
  }
  refuseEnumerator(function, std::string(name) + ".sum",
                   "QUELL_NO_SUM, QUELL_COUNT_IN_FOURTH or QUELL_OVER_SAMPLE_COUNT", sum);
}

DepthKind toDepthKind(quell_depth_kind kind, const char* function) {
  switch (kind) {
    case QUELL_DEPTH_VIEW:
      return DepthKind::View;
    case QUELL_DEPTH_NEGATIVE_VIEW:
      return DepthKind::NegativeView;
    case QUELL_DEPTH_RAY:
      return DepthKind::Ray;
    case QUELL_DEPTH_HYPERBOLIC:
      return DepthKind::Hyperbolic;
    case QUELL_DEPTH_REVERSED:
      return DepthKind::Reversed;
  }
  refuseEnumerator(function, "depthKind", "QUELL_DEPTH_VIEW, _NEGATIVE_VIEW, _RAY, _HYPERBOLIC or _REVERSED",
                   kind);
}

/// Numbers for which 0 stands for a default of another value.
void readNumbers(const quell_frame& read, Frame& frame) {
  frame.depthNear = read.depthNear;
  if (read.depthFar != 0.0) frame.depthFar = read.depthFar;
  if (read.motionScale[0] != 0.0 || read.motionScale[1] != 0.0)
    frame.motionScale = {read.motionScale[0], read.motionScale[1]};
  if (read.sampleCount != 0.0) frame.sampleCount = read.sampleCount;
}

ImageView toView(const quell_image_view& given, const char* function, const char* name) {
  ImageView view;
  view.memory = given.memory;
  switch (given.format) {
    case QUELL_FLOAT32:
      view.format = ComponentFormat::Float32;
      break;
    case QUELL_FLOAT16:
      view.format = ComponentFormat::Float16;
      break;
    case QUELL_UINT32:
      view.format = ComponentFormat::UInt32;
      break;
    case QUELL_IMAGE_OBJECT:
      view.format = ComponentFormat::ImageObject;
      break;
    default:
      refuseEnumerator(function, std::string(name) + ".format",
                       "QUELL_FLOAT32, QUELL_FLOAT16, QUELL_UINT32 or QUELL_IMAGE_OBJECT", given.format);
  }
  view.sum = toSum(given.sum, function, name);
  view.channels = given.channels;
  view.offsetBytes = given.offsetBytes;
  view.pixelStrideBytes = given.pixelStrideBytes;
  view.rowPitchBytes = given.rowPitchBytes;
  return view;
}

Camera toCamera(const quell_camera& given) {
  Camera camera;
  std::copy(std::begin(given.worldToClip), std::end(given.worldToClip), camera.worldToClip.begin());
  std::copy(std::begin(given.worldToClipPrev), std::end(given.worldToClipPrev),
            camera.worldToClipPrev.begin());
  camera.jitterPx = {given.jitterPx[0], given.jitterPx[1]};
  return camera;
}

TimerMode toTimerMode(quell_timer_mode mode, const char* function) {
  switch (mode) {
    case QUELL_TIMERS_OFF:
      return TimerMode::Off;
    case QUELL_TIMERS_DEVICE:
      return TimerMode::Device;
    case QUELL_TIMERS_HOST:
      return TimerMode::Host;
  }
  refuseEnumerator(function, "options.timers", "QUELL_TIMERS_OFF, QUELL_TIMERS_DEVICE or QUELL_TIMERS_HOST",
                   mode);
}

Mapping toMapping(quell_mapping mapping, const char* function) {
  switch (mapping) {
    case QUELL_MAPPING_AUTOMATIC:
      return Mapping::Automatic;
    case QUELL_MAPPING_NARROW:
      return Mapping::Narrow;
    case QUELL_MAPPING_WIDE:
      return Mapping::Wide;
    case QUELL_MAPPING_WIDE_4:
      return Mapping::Wide4;
    case QUELL_MAPPING_WIDE_8:
      return Mapping::Wide8;
    case QUELL_MAPPING_WIDE_16:
      return Mapping::Wide16;
  }
  refuseEnumerator(function, "options.mapping",
                   "QUELL_MAPPING_AUTOMATIC, _NARROW, _WIDE, _WIDE_4, _WIDE_8 or _WIDE_16", mapping);
}

std::vector<std::string> splitAtCommas(const char* text) {
  std::vector<std::string> parts;
  if (text == nullptr) return parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

}  // namespace

Frame toFrame(const quell_frame* given, const char* function) {
  const quell_frame read = readStruct(given, function, "frame");
  Frame frame;
  frame.size = {read.width, read.height};
  frame.renderSize = {read.renderWidth, read.renderHeight};
  frame.camera = toCamera(read.camera);
  frame.demodulated = read.demodulated != 0;
  frame.depthKind = toDepthKind(read.depthKind, function);
  readNumbers(read, frame);
  forEachInput(read, frame, [&](const ImageFacts& facts, const quell_image_view& image, ImageView& view) {
    view = toView(image, function, facts.name);
  });
  return frame;
}

Output toOutput(const quell_output* given, const char* function) {
  const quell_output read = readStruct(given, function, "output");
  Output output;
  for (std::size_t i = 0; i < std::size(kOutputs<Output>); ++i)
    output.*kOutputs<Output>[i].member =
        toView(read.*kOutputs<quell_output>[i].member, function, kOutputs<Output>[i].name);
  return output;
}

Options toOptions(const quell_options* given, const char* function) {
  Options options;
  if (given == nullptr) return options;
  const quell_options read = readStruct(given, function, "options");
  options.timers = toTimerMode(read.timers, function);
  options.mapping = toMapping(read.mapping, function);
  options.workGroup = {read.workGroup[0], read.workGroup[1]};
  options.fitGroup = read.fitGroup;
  if (read.cacheDirectory != nullptr) options.cacheDirectory = read.cacheDirectory;
  options.keptBuffers = splitAtCommas(read.keptBuffers);
  if (read.captureDirectory != nullptr) options.captureDirectory = read.captureDirectory;
  if (read.captureFrames != 0) options.captureFrames = read.captureFrames;
  options.captureSkip = read.captureSkip;
  return options;
}

}  // namespace quell::c_api
