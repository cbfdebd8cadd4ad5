#include "host/api/host_image.hpp"

#include <CL/cl_half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "host/core/depth.hpp"
#include "host/core/view_rays.hpp"

namespace quell {
namespace {

template <class Value>
Value valueAt(const unsigned char* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

float componentAt(const unsigned char* bytes, ComponentFormat format) {
  if (format == ComponentFormat::Float16) return cl_half_to_float(valueAt<cl_half>(bytes));
  if (format == ComponentFormat::UInt32) return static_cast<float>(valueAt<std::uint32_t>(bytes));
  return valueAt<float>(bytes);
}

/// As read_imagef has them (OpenCL 1.2, section 8.3.1), and integers as their value.
float texelComponentAt(const unsigned char* bytes, cl_channel_type type) {
  switch (type) {
    case CL_UNORM_INT8:
      return static_cast<float>(*bytes) / 255.0f;
    case CL_SNORM_INT8:
      return std::max(static_cast<float>(valueAt<std::int8_t>(bytes)) / 127.0f, -1.0f);
    case CL_UNORM_INT16:
      return static_cast<float>(valueAt<std::uint16_t>(bytes)) / 65535.0f;
    case CL_SNORM_INT16:
      return std::max(static_cast<float>(valueAt<std::int16_t>(bytes)) / 32767.0f, -1.0f);
    case CL_SIGNED_INT8:
      return static_cast<float>(valueAt<std::int8_t>(bytes));
    case CL_SIGNED_INT16:
      return static_cast<float>(valueAt<std::int16_t>(bytes));
    case CL_SIGNED_INT32:
      return static_cast<float>(valueAt<std::int32_t>(bytes));
    case CL_UNSIGNED_INT8:
      return static_cast<float>(*bytes);
    case CL_UNSIGNED_INT16:
      return static_cast<float>(valueAt<std::uint16_t>(bytes));
    case CL_UNSIGNED_INT32:
      return static_cast<float>(valueAt<std::uint32_t>(bytes));
    case CL_HALF_FLOAT:
      return cl_half_to_float(valueAt<cl_half>(bytes));
    default:
      return valueAt<float>(bytes);
  }
}

std::size_t typeBytes(cl_channel_type type) {
  switch (type) {
    case CL_UNORM_INT8:
    case CL_SNORM_INT8:
    case CL_SIGNED_INT8:
    case CL_UNSIGNED_INT8:
      return 1;
    case CL_FLOAT:
    case CL_SIGNED_INT32:
    case CL_UNSIGNED_INT32:
      return 4;
    default:
      return 2;
  }
}

std::vector<float> readTexels(const cl::CommandQueue& queue, const ImageView& view, Size size,
                              const std::vector<cl::Event>& waitFor) {
  const cl::Image2D image(view.memory, true);
  const auto format = image.getImageInfo<CL_IMAGE_FORMAT>();
  const auto texel = image.getImageInfo<CL_IMAGE_ELEMENT_SIZE>();
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  std::vector<unsigned char> bytes(width * height * texel);
  queue.enqueueReadImage(image, CL_TRUE, {0, 0, 0}, {width, height, 1}, 0, 0, bytes.data(), &waitFor);
  const bool redAndBlueSwapped = format.image_channel_order == CL_BGRA;
  std::vector<float> values;
  for (std::size_t y = 0; y < height; ++y) {
    const std::size_t row = view.rowPitchBytes < 0 ? height - 1 - y : y;
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < static_cast<std::size_t>(view.channels); ++c) {
        const std::size_t place = redAndBlueSwapped && c < 3 ? 2 - c : c;
        values.push_back(texelComponentAt(
            &bytes[(row * width + x) * texel + place * typeBytes(format.image_channel_data_type)],
            format.image_channel_data_type));
      }
  }
  return values;
}

std::vector<float> readBuffer(const cl::CommandQueue& queue, const ImageView& view, Size size,
                              const std::vector<cl::Event>& waitFor) {
  const std::ptrdiff_t pitch = view.rowPitch(size.width);
  const std::size_t above = pitch < 0 ? std::size_t(size.height - 1) * static_cast<std::size_t>(-pitch) : 0;
  const std::size_t begin = view.offsetBytes - above;  // of the lowest row in memory
  std::vector<unsigned char> bytes(view.requiredBytes(size) - begin);
  queue.enqueueReadBuffer(cl::Buffer(view.memory, true), CL_TRUE, begin, bytes.size(), bytes.data(),
                          &waitFor);
  std::vector<float> values;
  values.reserve(std::size_t(size.width) * std::size_t(size.height) * std::size_t(view.channels));
  for (int y = 0; y < size.height; ++y) {
    const unsigned char* row = bytes.data() + static_cast<std::ptrdiff_t>(above) + std::ptrdiff_t{y} * pitch;
    for (int x = 0; x < size.width; ++x)
      for (int c = 0; c < view.channels; ++c)
        values.push_back(componentAt(
            row + std::size_t(x) * view.pixelStride() + std::size_t(c) * view.componentBytes(), view.format));
  }
  return values;
}

void divideSums(HostImage& image, Sum sum, double sampleCount) {
  if (sum == Sum::OverSampleCount)
    for (float& value : image.values) value /= static_cast<float>(sampleCount);
  if (sum != Sum::CountInFourth) return;
  HostImage means{{}, 3};
  for (std::size_t i = 0; i < image.values.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) means.values.push_back(image.values[i + c] / image.values[i + 3]);
  image = std::move(means);
}

void toViewDepth(std::vector<float>& values, const Frame& frame) {
  if (frame.depthKind == DepthKind::NegativeView)
    for (float& value : values) value = -value;
  if (isDepthBuffer(frame.depthKind)) {
    const ReciprocalDepth depth = reciprocalDepth(frame.depthKind, frame.depthNear, frame.depthFar);
    for (float& value : values)
      value = static_cast<float>(1.0 / (depth.constant + depth.slope * double{value}));
  }
  if (frame.depthKind != DepthKind::Ray) return;
  const ViewRays rays = viewRays(frame.camera.worldToClip, frame.camera.jitterPx, frame.size);
  for (int y = 0; y < frame.size.height; ++y)
    for (int x = 0; x < frame.size.width; ++x) {
      const std::array<double, 3> ray = rays.at(x, y);
      values[std::size_t(y) * std::size_t(frame.size.width) + std::size_t(x)] /=
          static_cast<float>(std::hypot(ray[0], ray[1], ray[2]));
    }
}

}  // namespace

HostImage readImage(const cl::CommandQueue& queue, const Frame& frame, const ImageView Frame::*input,
                    const std::vector<cl::Event>& waitFor) {
  const ImageView& view = frame.*input;
  HostImage image{view.isImageObject() ? readTexels(queue, view, frame.size, waitFor)
                                       : readBuffer(queue, view, frame.size, waitFor),
                  view.channels};
  divideSums(image, view.sum, frame.sampleCount);
  if (input == &Frame::viewDepth) toViewDepth(image.values, frame);
  if (input == &Frame::motion)
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      const std::size_t channel = i % static_cast<std::size_t>(image.channels);
      if (channel < 2) image.values[i] *= static_cast<float>(frame.motionScale[channel]);
    }
  return image;
}

}  // namespace quell
