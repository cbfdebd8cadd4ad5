#include "host/core/validation.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <quell/error.hpp>
#include <string>
#include <vector>

#include "host/core/cl_error.hpp"
#include "host/core/image_schema.hpp"
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

struct NamedView {
  std::string name;
  const ImageView* view;
  const ImageFacts* facts;
  bool output;
};

std::vector<NamedView> namedViews(const Frame& frame, const Output& output) {
  std::vector<NamedView> views;
  for (const auto& image : kInputs<Frame>)
    views.push_back({image.name, &(frame.*image.member), &image, false});
  for (const auto& image : kOutputs<Output>)
    views.push_back({std::string("output.") + image.name, &(output.*image.member), &image, true});
  return views;
}

[[noreturn]] void refuse(const char* function, ErrorCode code, const std::string& buffer,
                         const std::string& expected, const std::string& got) {
  throw Error(code, {function, buffer, expected, got});
}

std::string sizeText(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

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
  return format == ComponentFormat::Float32 ? "floats" : "halves";
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
  const std::size_t component = view.componentBytes();
  // Far above what fits below, and low enough that no sum or product here overflows.
  const std::size_t most = kMostComponents * component;
  for (const std::size_t bytes : {view.offsetBytes, view.pixelStrideBytes, view.rowPitchBytes})
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
  const std::size_t rowBytes = view.pixelStride() * static_cast<std::size_t>(size.width - 1) + pixelBytes;
  if (view.rowPitch(size.width) % component != 0 || view.rowPitch(size.width) < rowBytes) {
    invalid("a row pitch of at least " + std::to_string(rowBytes) + " bytes in multiples of " +
                std::to_string(component),
            std::to_string(view.rowPitch(size.width)));
  }
  if (view.requiredBytes(size) / component > kMostComponents)
    invalid("fewer than 2^31 components up to the last pixel",
            std::to_string(view.requiredBytes(size) / component));
}

bool sameLayout(const ImageView& a, const ImageView& b, int width) {
  if (a.present() != b.present()) return false;
  return !a.present() || (a.format == b.format && a.channels == b.channels &&
                          a.pixelStride() == b.pixelStride() && a.rowPitch(width) == b.rowPitch(width));
}

std::string layoutText(const ImageView& view, int width) {
  if (!view.present()) return "absent";
  return std::to_string(view.channels) + " " + formatText(view.format) + " per pixel, pixel stride " +
         std::to_string(view.pixelStride()) + ", row pitch " + std::to_string(view.rowPitch(width)) +
         " bytes";
}

template <class Value>
Value memoryInfo(const char* function, const NamedView& named, cl_mem_info what) {
  Value value{};
  const cl_int status = clGetMemObjectInfo(named.view->memory, what, sizeof(value), &value, nullptr);
  if (status != CL_SUCCESS)
    refuse(function, ErrorCode::InvalidArgument, named.name, "a valid buffer object", clErrorName(status));
  return value;
}

void checkMemory(const char* function, const NamedView& named, Size size, cl_context context) {
  if (named.view->memory == nullptr)
    refuse(function, ErrorCode::InvalidArgument, named.name, "a buffer object", "null");
  if (memoryInfo<cl_mem_object_type>(function, named, CL_MEM_TYPE) != CL_MEM_OBJECT_BUFFER)
    refuse(function, ErrorCode::InvalidArgument, named.name, "a buffer object",
           "another kind of memory object");
  if (memoryInfo<cl_context>(function, named, CL_MEM_CONTEXT) != context)
    refuse(function, ErrorCode::WrongContext, named.name, "a buffer of the denoiser's context",
           "one of another context");
  const cl_mem_flags unusable = named.output ? CL_MEM_READ_ONLY : CL_MEM_WRITE_ONLY;
  if ((memoryInfo<cl_mem_flags>(function, named, CL_MEM_FLAGS) & unusable) != 0) {
    refuse(function, ErrorCode::InvalidArgument, named.name,
           named.output ? "a writable buffer" : "a readable buffer",
           named.output ? "CL_MEM_READ_ONLY" : "CL_MEM_WRITE_ONLY");
  }
  const std::size_t bytes = memoryInfo<std::size_t>(function, named, CL_MEM_SIZE);
  if (bytes < named.view->requiredBytes(size)) {
    refuse(function, ErrorCode::InvalidArgument, named.name,
           "at least " + std::to_string(named.view->requiredBytes(size)) + " bytes for " + sizeText(size),
           std::to_string(bytes) + " bytes");
  }
}

void checkLayouts(const char* function, const Frame& frame, const std::vector<NamedView>& views) {
  checkSize(function, frame.size);
  for (const NamedView& named : views) checkView(function, named, frame.size);
  for (const NamedView& named : views)
    if (named.facts->required() && !named.view->present())
      refuse(function, ErrorCode::InvalidArgument, named.name, "an image", "none");
  if (frame.positionWorld.present() == frame.viewDepth.present()) {
    refuse(function, ErrorCode::InvalidArgument, "positionWorld", "either positionWorld or viewDepth",
           frame.positionWorld.present() ? "both" : "none");
  }
}

}  // namespace

void checkLayout(const Frame& frame, const Output& output) {
  checkLayouts(kPrepare, frame, namedViews(frame, output));
  if (!output.linear.present() && !output.display.present())
    refuse(kPrepare, ErrorCode::InvalidArgument, "output", "a linear or a display image", "none");
}

void checkSameLayout(const Frame& prepared, const Output& preparedOutput, const Frame& frame,
                     const Output& output) {
  if (frame.size != prepared.size)
    refuse(kDenoise, ErrorCode::NotPrepared, "size", sizeText(prepared.size) + ", as prepared",
           sizeText(frame.size));
  if (frame.demodulated != prepared.demodulated) {
    refuse(kDenoise, ErrorCode::NotPrepared, "demodulated",
           prepared.demodulated ? "true, as prepared" : "false, as prepared",
           frame.demodulated ? "true" : "false");
  }
  const auto before = namedViews(prepared, preparedOutput);
  const auto now = namedViews(frame, output);
  for (std::size_t i = 0; i < now.size(); ++i) {
    checkView(kDenoise, now[i], frame.size);
    if (!sameLayout(*before[i].view, *now[i].view, frame.size.width)) {
      refuse(kDenoise, ErrorCode::NotPrepared, now[i].name,
             layoutText(*before[i].view, frame.size.width) + ", as prepared",
             layoutText(*now[i].view, frame.size.width));
    }
  }
}

void checkMemory(const Frame& frame, const Output& output, cl_context context) {
  for (const NamedView& named : namedViews(frame, output))
    if (named.view->present()) checkMemory(kDenoise, named, frame.size, context);
}

void checkInputs(const char* function, const Frame& frame, cl_context context) {
  const Output none;
  const std::vector<NamedView> views = namedViews(frame, none);
  checkLayouts(function, frame, views);
  for (const NamedView& named : views)
    if (named.view->present()) checkMemory(function, named, frame.size, context);
}

void checkHalfPositions(const Frame& frame) {
  if (!frame.positionWorld.present() || frame.positionWorld.format != ComponentFormat::Float16) return;
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
