#include "host/api/frame_checker.hpp"

#include <iterator>
#include <utility>

#include "host/api/host_image.hpp"
#include "host/check/checks.hpp"
#include "host/core/image_schema.hpp"

namespace quell {

/// A frame's images as floats, and what looks at them.
struct HostFrame {
  check::Frame view;
  std::vector<std::vector<float>> pixels;
};

namespace {

std::unique_ptr<HostFrame> readFrame(const cl::CommandQueue& queue, const Frame& frame,
                                     const std::vector<cl::Event>& waitFor) {
  auto host = std::make_unique<HostFrame>();
  host->view.camera = frame.camera;
  host->view.demodulated = frame.demodulated;
  for (std::size_t i = 0; i < std::size(kInputs<Frame>); ++i) {
    const auto input = kInputs<Frame>[i].member;
    if (!(frame.*input).present()) continue;
    HostImage image = readImage(queue, frame, input, waitFor);
    host->pixels.push_back(std::move(image.values));
    host->view.*kInputs<check::Frame>[i].member = {host->pixels.back().data(), frame.size.width,
                                                   frame.size.height, image.channels};
  }
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
  Camera& camera = now->view.camera;
  if (camera.worldToClipPrev == Matrix4{})
    camera.worldToClipPrev = m_last ? m_last->view.camera.worldToClip : camera.worldToClip;
  check::Result result = check::checkFrame(now->view, m_last ? &m_last->view : nullptr);
  m_last = std::move(now);
  FrameCheck all{std::move(result.figures), {}};
  for (check::MappedFinding& found : result.findings) all.findings.push_back(std::move(found.finding));
  return all;
}

}  // namespace quell
