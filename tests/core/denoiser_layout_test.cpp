// Input layouts: whatever the strides, the same values give the same picture, bit for bit.
#include <catch2/catch.hpp>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 2;
// 37 pixels: two full groups of sixteen and a rest.
constexpr Size kSize{37, 21};

// The layouts are dealt to the images in turn.
ImageSetup withInputs(const std::vector<ImageLayout>& layouts, bool roundToHalf = false) {
  ImageSetup setup;
  setup.size = kSize;
  std::size_t next = 0;
  for (ImageLayout* image :
       {&setup.radiance, &setup.normalWorld, &setup.positionWorld, &setup.albedo, &setup.emission})
    *image = layouts[next++ % layouts.size()];
  setup.roundToHalf = roundToHalf;
  return setup;
}

Picture denoised(const ImageSetup& setup) { return SmallDenoiser(setup).run(0, kLastFrame); }

// All inputs of a frame in one buffer, as structs of this many floats with padded rows.
class StructBuffer {
 public:
  StructBuffer(const OpenDevice& device, FrameBuffers& buffers) : m_buffers(buffers) {
    m_floats.assign(kHeader + kPitch * std::size_t(kSize.height), 12345.0f);
    m_memory = cl::Buffer(device.context, CL_MEM_READ_ONLY, m_floats.size() * sizeof(float));
  }

  // Points the frame's images into the struct, which takes over their values.
  Frame takeOver(const cl::CommandQueue& queue) {
    Frame frame = m_buffers.frame;
    std::size_t first = 1;  // a member that Quell does not read
    for (const auto input : m_inputs) {
      const io::Image image = decodeImage(m_buffers.bytes(frame.*input), frame.*input, kSize);
      for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
          for (int c = 0; c < 3; ++c)
            m_floats[kHeader + kPitch * std::size_t(y) + kStride * std::size_t(x) + first + std::size_t(c)] =
                image.at(x, y, c);
      ImageView& view = frame.*input;
      view.memory = m_memory();
      view.offsetBytes = (kHeader + first) * sizeof(float);
      view.pixelStrideBytes = kStride * sizeof(float);
      view.rowPitchBytes = kPitch * sizeof(float);
      first += 3;
    }
    queue.enqueueWriteBuffer(m_memory, CL_TRUE, 0, m_floats.size() * sizeof(float), m_floats.data());
    return frame;
  }

 private:
  static constexpr std::size_t kStride = 17, kPitch = 17 * 37 + 9, kHeader = 4;

  FrameBuffers& m_buffers;
  const std::vector<ImageView Frame::*> m_inputs{&Frame::radiance, &Frame::normalWorld, &Frame::positionWorld,
                                                 &Frame::albedo, &Frame::emission};
  std::vector<float> m_floats;
  cl::Buffer m_memory;
};

}  // namespace

TEST_CASE("float inputs of every layout give the same picture", "[core]") {
  const Picture expected = denoised(withInputs({packed(3)}));
  CHECK(denoised(withInputs({packed(4), interleaved(3)})) == expected);
}

TEST_CASE("half inputs give what floats of the same values give", "[core]") {
  constexpr ComponentFormat kHalf = ComponentFormat::Float16;
  const Picture exact = denoised(withInputs({packed(3)}));
  const Picture expected = denoised(withInputs({packed(3)}, true));
  CHECK_FALSE(expected == exact);
  CHECK(denoised(withInputs({packedHalf(4), interleaved(3, kHalf), packedHalf(3)})) == expected);
}

TEST_CASE("all inputs may lie in one buffer of structs", "[core]") {
  SmallDenoiser separate;
  SmallDenoiser together;
  StructBuffer structs(together.device, together.buffers);
  together.denoiser.prepare(structs.takeOver(together.device.queue), together.buffers.output);
  for (int number = 0; number <= kLastFrame; ++number) {
    separate.run(number);
    together.buffers.upload(number);
    const Frame frame = structs.takeOver(together.device.queue);
    together.denoiser.denoise(frame, together.buffers.output).wait();
  }
  CHECK(together.buffers.download() == separate.buffers.download());
}

TEST_CASE("the offset may change from frame to frame", "[core]") {
  SmallDenoiser small;
  const Picture expected = small.run(0);
  small.denoiser.resetHistory();
  Frame moved = small.buffers.frame;
  const std::size_t bytes = moved.radiance.requiredBytes(kSize);
  const cl::Buffer larger(small.device.context, CL_MEM_READ_WRITE, bytes + 20);
  small.device.queue.enqueueCopyBuffer(cl::Buffer(moved.radiance.memory, true), larger, 0, 20, bytes);
  moved.radiance.memory = larger();
  moved.radiance.offsetBytes = 20;
  small.denoiser.denoise(moved, small.buffers.output).wait();
  CHECK(small.buffers.download() == expected);
}

}  // namespace quell::tests
