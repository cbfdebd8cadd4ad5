#include "host/api/frame_checker.hpp"

#include <CL/cl_half.h>

#include <cstring>
#include <utility>

#include "host/check/checks.hpp"
#include "host/core/image_schema.hpp"

namespace quell {

/// A frame's images as floats, and what looks at them.
struct HostFrame {
  check::Frame view;
  std::vector<std::vector<float>> pixels;
};

namespace {

float componentAt(const unsigned char* bytes, ComponentFormat format) {
  if (format == ComponentFormat::Float16) {
    cl_half half;
    std::memcpy(&half, bytes, sizeof(half));
    return cl_half_to_float(half);
  }
  if (format == ComponentFormat::UInt32) {
    std::uint32_t number;
    std::memcpy(&number, bytes, sizeof(number));
    return static_cast<float>(number);
  }
  float value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

std::vector<float> readImage(const cl::CommandQueue& queue, const ImageView& image, Size size,
                             const std::vector<cl::Event>& waitFor) {
  std::vector<unsigned char> bytes(image.requiredBytes(size) - image.offsetBytes);
  queue.enqueueReadBuffer(cl::Buffer(image.memory, true), CL_TRUE, image.offsetBytes, bytes.size(),
                          bytes.data(), &waitFor);
  std::vector<float> values;
  values.reserve(std::size_t(size.width) * std::size_t(size.height) * std::size_t(image.channels));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (int c = 0; c < image.channels; ++c)
        values.push_back(componentAt(
            &bytes[std::size_t(y) * image.rowPitch(size.width) + std::size_t(x) * image.pixelStride() +
                   std::size_t(c) * image.componentBytes()],
            image.format));
  return values;
}

std::unique_ptr<HostFrame> readFrame(const cl::CommandQueue& queue, const Frame& frame,
                                     const std::vector<cl::Event>& waitFor) {
  auto host = std::make_unique<HostFrame>();
  host->view.camera = frame.camera;
  host->view.demodulated = frame.demodulated;
  forEachInput(frame, host->view, [&](const ImageFacts&, const ImageView& image, check::Image& target) {
    if (!image.present()) return;
    host->pixels.push_back(readImage(queue, image, frame.size, waitFor));
    target = {host->pixels.back().data(), frame.size.width, frame.size.height, image.channels};
  });
  return host;
}

}  // namespace

FrameChecker::FrameChecker() = default;
FrameChecker::~FrameChecker() = default;

void FrameChecker::forget() { m_last.reset(); }

FrameCheck FrameChecker::check(const cl::CommandQueue& queue, const Frame& frame,
                               const std::vector<cl::Event>& waitFor) {
  std::unique_ptr<HostFrame> now = readFrame(queue, frame, waitFor);
  if (m_last) now->view.number = m_last->view.number + 1;
  check::Result result = check::checkFrame(now->view, m_last ? &m_last->view : nullptr);
  m_last = std::move(now);
  FrameCheck all{std::move(result.figures), {}};
  for (check::MappedFinding& found : result.findings) all.findings.push_back(std::move(found.finding));
  return all;
}

}  // namespace quell
