#include "host/core/validation.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <quell/error.hpp>
#include <string>
#include <vector>

#include "host/core/depth.hpp"
#include "host/core/memory_checks.hpp"
#include "host/core/named_views.hpp"
#include "host/core/render_rectangle.hpp"
#include "host/core/reprojection.hpp"

namespace quell {
namespace {

// The functions that the caller called.
constexpr char kPrepare[] = "prepare";
constexpr char kDenoise[] = "denoise";
// Largest width or height in pixels, and most pixels: indices of eight planes must stay below 2^31.
constexpr int kMostExtent = 32768;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 27;
// Kernels count the components of a caller's image in 32 bits.
constexpr std::size_t kMostComponents = std::numeric_limits<std::int32_t>::max();

void checkSize(const char* function, Size size) {
  if (size.width < 1 || size.height < 1 || size.width > kMostExtent || size.height > kMostExtent ||
      std::int64_t{size.width} * size.height > kMostPixels) {
    refuse(function, ErrorCode::InvalidArgument, "size",
           "1x1 to " + std::to_string(kMostExtent) + "x" + std::to_string(kMostExtent) + " and at most " +
               std::to_string(kMostPixels) + " pixels",
           sizeText(size));
  }
}

std::string formatText(ComponentFormat format) {
  if (format == ComponentFormat::UInt32) return "32-bit unsigned integers";
  if (format == ComponentFormat::ImageObject) return "components of an image object";
  return format == ComponentFormat::Float32 ? "floats" : "halves";
}

using Invalid = std::function<void(const std::string& expected, const std::string& got)>;

std::string bytesText(std::ptrdiff_t bytes) { return std::to_string(bytes); }

void checkImageObject(const ImageView& view, const Invalid& invalid) {
  if (view.offsetBytes != 0 || view.pixelStrideBytes != 0 || view.rowPitchBytes > 0)
    invalid(
        "no offset, pixel stride or row pitch of an image object, but a negative pitch for rows bottom-up",
        "offset " + std::to_string(view.offsetBytes) + ", stride " + std::to_string(view.pixelStrideBytes) +
            ", pitch " + bytesText(view.rowPitchBytes));
}

void checkStrides(const ImageView& view, Size size, const Invalid& invalid) {
  const std::size_t component = view.componentBytes();
  // Far above what fits below, and low enough that no sum or product here overflows.
  const std::size_t most = kMostComponents * component;
  const auto pitchBytes =
      static_cast<std::size_t>(view.rowPitchBytes < 0 ? 0 - static_cast<std::size_t>(view.rowPitchBytes)
                                                      : static_cast<std::size_t>(view.rowPitchBytes));
  for (const std::size_t bytes : {view.offsetBytes, view.pixelStrideBytes, pitchBytes})
    if (bytes > most)
      invalid("offset, pixel stride and row pitch up to " + std::to_string(most) + " bytes",
              std::to_string(bytes));
  const std::size_t pixelBytes = component * static_cast<std::size_t>(view.channels);
  if (view.offsetBytes % component != 0)
    invalid("an offset in multiples of " + std::to_string(component) + " bytes",
            std::to_string(view.offsetBytes));
  if (view.pixelStride() % component != 0 || view.pixelStride() < pixelBytes) {
    invalid("a pixel stride of at least " + std::to_string(pixelBytes) + " bytes in multiples of " +
                std::to_string(component),
            std::to_string(view.pixelStride()));
  }
  const std::ptrdiff_t pitch = view.rowPitch(size.width);
  const auto distance = static_cast<std::size_t>(std::abs(pitch));
  if (distance % component != 0 || distance < view.rowBytes(size.width)) {
    invalid("a row pitch of at least " + std::to_string(view.rowBytes(size.width)) +
                " bytes, up or down, in multiples of " + std::to_string(component),
            bytesText(pitch));
  }
  const std::size_t below = static_cast<std::size_t>(size.height - 1) * distance;
  if (pitch < 0 && view.offsetBytes < below)
    invalid("an offset of at least " + std::to_string(below) +
                " bytes, where the last of the memory's rows begins (bottomUp() sets it)",
            std::to_string(view.offsetBytes));
  if (view.requiredBytes(size) / component > kMostComponents)
    invalid("fewer than 2^31 components up to the last pixel",
            std::to_string(view.requiredBytes(size) / component));
}

void checkView(const char* function, const NamedView& named, Size size) {
  const ImageView& view = *named.view;
  if (!view.present()) return;
  const auto invalid = [&](const std::string& expected, const std::string& got) {
    refuse(function, ErrorCode::InvalidArgument, named.name, expected, got);
  };
  const ImageFacts& facts = *named.facts;
  if (view.channels < facts.leastChannels || view.channels > facts.mostChannels) {
    invalid(std::to_string(facts.leastChannels) + " to " + std::to_string(facts.mostChannels) + " channels",
            std::to_string(view.channels));
  }
  if (view.format == ComponentFormat::UInt32 && !facts.identifiers())
    invalid("floats or halves", formatText(view.format));
  if (view.sum != Sum::None && (named.output || facts.identifiers())) invalid("values", "sums");
  if (view.sum == Sum::CountInFourth && view.channels != 4)
    invalid("4 channels, of which the fourth counts", std::to_string(view.channels));
  if (view.isImageObject()) {
    checkImageObject(view, invalid);
  } else {
    checkStrides(view, size, invalid);
  }
}

std::string layoutText(const ImageView& view, int width) {
  if (!view.present()) return "absent";
  const std::string sums = view.sum == Sum::None            ? ""
                           : view.sum == Sum::CountInFourth ? ", sums with a count in the fourth"
                                                            : ", sums over sampleCount";
  if (view.isImageObject())
    return std::to_string(view.channels) + " " + formatText(view.format) + sums +
           (view.rowPitchBytes < 0 ? ", bottom-up" : "");
  return std::to_string(view.channels) + " " + formatText(view.format) + " per pixel, pixel stride " +
         std::to_string(view.pixelStride()) + ", row pitch " + bytesText(view.rowPitch(width)) + " bytes" +
         sums;
}

void checkLayouts(const char* function, const Frame& frame, const NamedViews& views) {
  for (const NamedView& named : views) checkView(function, named, frame.size);
  for (const NamedView& named : views)
    if (named.facts->required() && !named.view->present())
      refuse(function, ErrorCode::InvalidArgument, named.name, "an image", "none");
  if (frame.positionWorld.present() == frame.viewDepth.present()) {
    refuse(function, ErrorCode::InvalidArgument, "positionWorld", "either positionWorld or viewDepth",
           frame.positionWorld.present() ? "both" : "none");
  }
}

std::string kindText(DepthKind kind) {
  constexpr const char* kNames[] = {"View", "NegativeView", "Ray", "Hyperbolic", "Reversed"};
  const auto index = static_cast<std::size_t>(kind);
  return index < std::size(kNames) ? kNames[index] : std::to_string(index);
}

}  // namespace

void checkSizes(const char* function, const Frame& frame) {
  checkSize(function, frame.size);
  const Size part = renderedSize(frame);
  if (part.width < 1 || part.height < 1 || part.width > frame.size.width || part.height > frame.size.height)
    refuse(function, ErrorCode::InvalidArgument, "renderSize",
           "1x1 to the frame's size of " + sizeText(frame.size) + ", or 0x0 for all of it", sizeText(part));
}

void checkLayout(const Frame& frame, const Output& output) {
  checkSizes(kPrepare, frame);
  const Frame part = renderedPart(frame);
  const Output outputPart = renderedPart(output, frame);
  checkLayouts(kPrepare, part, namedViews(part, outputPart));
  if (!output.linear.present() && !output.display.present())
    refuse(kPrepare, ErrorCode::InvalidArgument, "output", "a linear or a display image", "none");
}

void checkSameSize(const Frame& prepared, const Frame& frame) {
  if (frame.size != prepared.size)
    refuse(kDenoise, ErrorCode::NotPrepared, "size", sizeText(prepared.size) + ", as prepared",
           sizeText(frame.size));
  if (!hasRenderSize(frame)) return;
  checkSizes(kDenoise, frame);
  if (!hasRenderSize(prepared))
    refuse(kDenoise, ErrorCode::NotPrepared, "renderSize",
           "none, or a prepare() with any, which makes ready for other sizes", sizeText(frame.renderSize));
}

void checkSameLayout(const Frame& prepared, const Output& preparedOutput, const Frame& frame,
                     const Output& output) {
  if (frame.demodulated != prepared.demodulated) {
    refuse(kDenoise, ErrorCode::NotPrepared, "demodulated",
           prepared.demodulated ? "true, as prepared" : "false, as prepared",
           frame.demodulated ? "true" : "false");
  }
  if (frame.depthKind != prepared.depthKind)
    refuse(kDenoise, ErrorCode::NotPrepared, "depthKind", kindText(prepared.depthKind) + ", as prepared",
           kindText(frame.depthKind));
  const auto before = namedViews(prepared, preparedOutput);
  const auto now = namedViews(frame, output);
  for (std::size_t i = 0; i < now.size(); ++i) {
    checkView(kDenoise, now[i], frame.size);
    const bool same = hasRenderSize(frame) ? samePixels(*before[i].view, *now[i].view)
                                           : sameLayout(*before[i].view, *now[i].view, frame.size.width);
    if (!same) {
      refuse(kDenoise, ErrorCode::NotPrepared, now[i].name,
             layoutText(*before[i].view, frame.size.width) + ", as prepared",
             layoutText(*now[i].view, frame.size.width));
    }
  }
}

void checkNumbers(const char* function, const Frame& frame) {
  const auto invalid = [&](const char* name, const std::string& expected, double got) {
    refuse(function, ErrorCode::InvalidArgument, name, expected, std::to_string(got));
  };
  for (const double scale : frame.motionScale)
    if (!std::isfinite(scale) || scale == 0.0) invalid("motionScale", "finite factors other than 0", scale);
  if (!(frame.sampleCount > 0.0) || !std::isfinite(frame.sampleCount))
    invalid("sampleCount", "a number above 0", frame.sampleCount);
  if (!frame.viewDepth.present() || !isDepthBuffer(frame.depthKind)) return;
  if (!(frame.depthNear > 0.0) || !std::isfinite(frame.depthNear))
    invalid("depthNear", "the near plane of the depth buffer, above 0", frame.depthNear);
  const bool mayBeInfinite = frame.depthKind == DepthKind::Reversed;
  if (!(frame.depthFar > frame.depthNear) || (!mayBeInfinite && std::isinf(frame.depthFar)))
    invalid("depthFar",
            std::string("the far plane of the depth buffer, beyond depthNear") +
                (mayBeInfinite ? "" : ", finite"),
            frame.depthFar);
}

void checkInputs(const char* function, const Frame& frame, cl_context context) {
  const Output none;
  checkLayouts(function, frame, namedViews(frame, none));
  checkNumbers(function, frame);
  checkMemory(function, frame, none, context);
}

void checkPerspective(const char* function, const Frame& frame) {
  if (frame.viewDepth.present() && isOrthographic(frame.camera.worldToClip))
    refuse(function, ErrorCode::InvalidArgument, "viewDepth", "a perspective camera", "an orthographic one");
}

void checkHalfPositions(const Frame& frame) {
  if (!frame.positionWorld.present() || !isNarrow(frame.positionWorld)) return;
  for (const double coordinate : cameraPositionWorld(frame.camera.worldToClip, "worldToClip")) {
    if (std::abs(coordinate) > kHalfPositionRange) {
      refuse(kDenoise, ErrorCode::OutOfRange, "positionWorld",
             "float positions, or a camera within " + std::to_string(kHalfPositionRange) +
                 " units of the world origin for half positions",
             "a camera coordinate of " + std::to_string(coordinate));
    }
  }
}

}  // namespace quell
