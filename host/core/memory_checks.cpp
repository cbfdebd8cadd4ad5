#include "host/core/memory_checks.hpp"

#include <algorithm>
#include <string>

#include "host/core/cl_error.hpp"
#include "host/core/named_views.hpp"
#include "host/core/overlap.hpp"
#include "host/core/render_rectangle.hpp"

namespace quell {
namespace {

template <class Value>
Value memoryInfo(const char* function, const NamedView& named, cl_mem_info what) {
  Value value{};
  const cl_int status = clGetMemObjectInfo(named.view->memory, what, sizeof(value), &value, nullptr);
  if (status != CL_SUCCESS)
    refuse(function, ErrorCode::InvalidArgument, named.name, "a valid memory object", clErrorName(status));
  return value;
}

template <class Value>
Value imageInfo(cl_mem image, cl_image_info what) {
  Value value{};
  const cl_int status = clGetImageInfo(image, what, sizeof(value), &value, nullptr);
  if (status != CL_SUCCESS) throw translateClError(status, "clGetImageInfo", "denoise");
  return value;
}

/// Components that texels of this order have; 0: none that stand for the first components of a pixel.
int orderChannels(cl_channel_order order) {
  switch (order) {
    case CL_R:
      return 1;
    case CL_RG:
      return 2;
    case CL_RGB:
      return 3;
    case CL_RGBA:
    case CL_BGRA:
      return 4;
    default:
      return 0;
  }
}

bool standsForFloats(cl_channel_type type) {
  constexpr cl_channel_type kTypes[] = {CL_FLOAT,      CL_HALF_FLOAT,  CL_UNORM_INT8,
                                        CL_SNORM_INT8, CL_UNORM_INT16, CL_SNORM_INT16};
  return std::find(std::begin(kTypes), std::end(kTypes), type) != std::end(kTypes);
}

bool isInteger(cl_channel_type type) {
  constexpr cl_channel_type kTypes[] = {CL_SIGNED_INT8,   CL_SIGNED_INT16,   CL_SIGNED_INT32,
                                        CL_UNSIGNED_INT8, CL_UNSIGNED_INT16, CL_UNSIGNED_INT32};
  return std::find(std::begin(kTypes), std::end(kTypes), type) != std::end(kTypes);
}

std::string hex(cl_uint value) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "0x";
  for (int shift = 12; shift >= 0; shift -= 4) text += kDigits[value >> shift & 15];
  return text;
}

void checkTexels(const char* function, const NamedView& named, Size size) {
  const cl_mem image = named.view->memory;
  const auto width = imageInfo<std::size_t>(image, CL_IMAGE_WIDTH);
  const auto height = imageInfo<std::size_t>(image, CL_IMAGE_HEIGHT);
  if (width < static_cast<std::size_t>(size.width) || height < static_cast<std::size_t>(size.height))
    refuse(function, ErrorCode::InvalidArgument, named.name, "an image of at least " + sizeText(size),
           std::to_string(width) + "x" + std::to_string(height));
  const auto format = imageInfo<cl_image_format>(image, CL_IMAGE_FORMAT);
  const bool identifiers = named.facts->identifiers();
  if (!standsForFloats(format.image_channel_data_type) &&
      !(identifiers && isInteger(format.image_channel_data_type)))
    refuse(function, ErrorCode::InvalidArgument, named.name,
           std::string("texels of floats, halves or normalised 8- or 16-bit integers") +
               (identifiers ? ", or of integers" : ""),
           "channel data type " + hex(format.image_channel_data_type));
  if (orderChannels(format.image_channel_order) < named.view->channels)
    refuse(function, ErrorCode::InvalidArgument, named.name,
           "texels of " + std::to_string(named.view->channels) +
               " or more of CL_R, CL_RG, CL_RGB, CL_RGBA or CL_BGRA",
           "channel order " + hex(format.image_channel_order));
}

void checkKind(const char* function, const NamedView& named) {
  const auto type = memoryInfo<cl_mem_object_type>(function, named, CL_MEM_TYPE);
  const bool wantsImage = named.view->isImageObject();
  if (type == (wantsImage ? CL_MEM_OBJECT_IMAGE2D : CL_MEM_OBJECT_BUFFER)) return;
  const char* got = type == CL_MEM_OBJECT_BUFFER    ? "a buffer object"
                    : type == CL_MEM_OBJECT_IMAGE2D ? "an image object of two dimensions"
                                                    : "another kind of memory object";
  refuse(function, ErrorCode::InvalidArgument, named.name,
         wantsImage ? "an image object of two dimensions, as the view's format says"
                    : "a buffer object (image objects need the format ImageObject)",
         got);
}

void checkBytes(const char* function, const NamedView& named, Size size) {
  const auto bytes = memoryInfo<std::size_t>(function, named, CL_MEM_SIZE);
  if (bytes < named.view->requiredBytes(size))
    refuse(function, ErrorCode::InvalidArgument, named.name,
           "at least " + std::to_string(named.view->requiredBytes(size)) + " bytes for " + sizeText(size),
           std::to_string(bytes) + " bytes");
}

void checkMemoryOf(const char* function, const NamedView& named, Size size, cl_context context) {
  if (named.view->memory == nullptr)
    refuse(function, ErrorCode::InvalidArgument, named.name,
           named.view->isImageObject() ? "an image object" : "a buffer object", "null");
  checkKind(function, named);
  if (memoryInfo<cl_context>(function, named, CL_MEM_CONTEXT) != context)
    refuse(function, ErrorCode::WrongContext, named.name, "memory of the denoiser's context",
           "that of another context");
  const cl_mem_flags unusable = named.output ? CL_MEM_READ_ONLY : CL_MEM_WRITE_ONLY;
  if ((memoryInfo<cl_mem_flags>(function, named, CL_MEM_FLAGS) & unusable) != 0) {
    refuse(function, ErrorCode::InvalidArgument, named.name,
           named.output ? "writable memory" : "readable memory",
           named.output ? "CL_MEM_READ_ONLY" : "CL_MEM_WRITE_ONLY");
  }
  if (named.view->isImageObject()) return checkTexels(function, named, size);
  checkBytes(function, named, size);
}

}  // namespace

void checkMemory(const char* function, const Frame& frame, const Output& output, cl_context context) {
  const NamedViews views = namedViews(frame, output);
  for (const NamedView& named : views)
    if (named.view->present()) checkMemoryOf(function, named, frame.size, context);
  checkOverlaps(function, frame, output);
}

void checkKinds(const char* function, const Frame& frame, const Output& output, const cl::Device& device,
                cl_context context) {
  for (const NamedView& named : namedViews(frame, output)) {
    if (!named.view->present()) continue;
    const bool isObject = named.view->isImageObject();
    if (isObject && device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() == 0)
      refuse(function, ErrorCode::InvalidArgument, named.name, "a buffer, since the device has no images",
             "an image object");
    if (named.view->memory == nullptr) continue;
    if (isObject) {
      checkMemoryOf(function, named, renderedSize(frame), context);
    } else {
      checkKind(function, named);
      checkBytes(function, named, renderedSize(frame));
    }
  }
}

bool isNarrow(const ImageView& view) {
  if (!view.isImageObject()) return view.format == ComponentFormat::Float16;
  return imageInfo<cl_image_format>(view.memory, CL_IMAGE_FORMAT).image_channel_data_type != CL_FLOAT;
}

void resolveImageObjects(Frame& frame, Output& output) {
  const auto resolve = [](ImageView& view) {
    if (view.present() && view.isImageObject() && view.memory != nullptr)
      view.pixelStrideBytes = imageInfo<std::size_t>(view.memory, CL_IMAGE_ELEMENT_SIZE);
  };
  for (const auto& image : kInputs<Frame>) resolve(frame.*image.member);
  for (const auto& image : kOutputs<Output>) resolve(output.*image.member);
}

}  // namespace quell
