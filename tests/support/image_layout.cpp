#include "tests/support/image_layout.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <cstring>

namespace quell::tests {
namespace {

// Fills what belongs to no component: no sensible float or half has these bits.
constexpr unsigned char kGap = 0xA5;

std::size_t componentOffset(const ImageView& view, int width, int x, int y, int channel) {
  return std::size_t(std::ptrdiff_t(view.offsetBytes) + y * view.rowPitch(width)) +
         std::size_t(x) * view.pixelStride() + std::size_t(channel) * view.componentBytes();
}

void storeComponent(unsigned char* where, ComponentFormat format, float value) {
  if (format == ComponentFormat::Float32) {
    std::memcpy(where, &value, sizeof(value));
  } else if (format == ComponentFormat::UInt32) {
    const auto word = static_cast<std::uint32_t>(value);
    std::memcpy(where, &word, sizeof(word));
  } else {
    const Eigen::half half(value);
    std::memcpy(where, &half, sizeof(half));
  }
}

float loadComponent(const unsigned char* where, ComponentFormat format) {
  float value;
  std::uint32_t word;
  Eigen::half half;
  if (format == ComponentFormat::Float32) {
    std::memcpy(&value, where, sizeof(value));
  } else if (format == ComponentFormat::UInt32) {
    std::memcpy(&word, where, sizeof(word));
    value = static_cast<float>(word);
  } else {
    std::memcpy(&half, where, sizeof(half));
    value = static_cast<float>(half);
  }
  return value;
}

template <class Work>
void forEachComponent(const ImageView& view, Size size, Work&& work) {
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (int c = 0; c < view.channels; ++c) work(x, y, c, componentOffset(view, size.width, x, y, c));
}

}  // namespace

std::string describe(const ImageLayout& layout) {
  constexpr const char* kFormats[] = {"float", "half", "uint"};
  std::string text = kFormats[static_cast<int>(layout.format)] + std::to_string(layout.channels);
  if (layout.pixelStride != 0) text += "." + std::to_string(layout.pixelStride);
  if (layout.rowPadding != 0) text += "+" + std::to_string(layout.rowPadding);
  if (layout.offset != 0) text += "@" + std::to_string(layout.offset);
  return text;
}

ImageView makeView(const ImageLayout& layout, Size size) {
  ImageView view = packedImage(nullptr, layout.channels, layout.format);
  const std::size_t component = view.componentBytes();
  view.offsetBytes = std::size_t(layout.offset) * component;
  view.pixelStrideBytes = std::size_t(layout.pixelStride) * component;
  if (layout.rowPadding != 0)
    view.rowPitchBytes = std::ptrdiff_t(view.pixelStride() * std::size_t(size.width) +
                                        std::size_t(layout.rowPadding) * component);
  return view;
}

std::vector<unsigned char> encodeImage(const io::Image& image, const ImageView& view, Size size) {
  std::vector<unsigned char> bytes(view.requiredBytes(size), kGap);
  forEachComponent(view, size, [&](int x, int y, int c, std::size_t offset) {
    storeComponent(&bytes[offset], view.format, c < image.channels ? image.at(x, y, c) : 0.0f);
  });
  return bytes;
}

io::Image decodeImage(const std::vector<unsigned char>& bytes, const ImageView& view, Size size) {
  io::Image image(size.width, size.height, view.channels);
  forEachComponent(view, size, [&](int x, int y, int c, std::size_t offset) {
    image.at(x, y, c) = loadComponent(&bytes[offset], view.format);
  });
  return image;
}

bool gapsUntouched(const std::vector<unsigned char>& bytes, const ImageView& view, Size size) {
  std::vector<unsigned char> rest = bytes;
  forEachComponent(view, size, [&](int, int, int, std::size_t offset) {
    std::memset(&rest[offset], kGap, view.componentBytes());
  });
  for (const unsigned char byte : rest)
    if (byte != kGap) return false;
  return true;
}

io::Image asStored(const io::Image& image, const ImageView& view) {
  const Size size{image.width, image.height};
  return decodeImage(encodeImage(image, view, size), view, size);
}

}  // namespace quell::tests
