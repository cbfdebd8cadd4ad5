// Outputs that share memory with an input or with each other are refused; what only lies between each other is not.
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr std::size_t kPixel = 3 * sizeof(float);

void checkOverlap(SmallDenoiser& small, const Output& output, const char* which, const char* other) {
  checkRefused({ErrorCode::InvalidArgument, "denoise", which, "no other image", other},
               [&] { small.denoiser.denoise(small.buffers.frame, output); });
}

// A view of the same shape elsewhere.
ImageView at(ImageView view, cl_mem memory, std::size_t offset) {
  view.memory = memory;
  view.offsetBytes = offset;
  return view;
}

}  // namespace

TEST_CASE("an output over an input or another output is refused", "[errors]") {
  SmallDenoiser small;
  const Frame& frame = small.buffers.frame;
  Output output = small.buffers.output;
  output.linear.memory = frame.normalWorld.memory;
  checkOverlap(small, output, "output.linear", "normalWorld");
  output = small.buffers.output;
  output.display.memory = frame.radiance.memory;
  checkOverlap(small, output, "output.display", "radiance");
  output = small.buffers.output;
  output.display.memory = output.linear.memory;
  checkOverlap(small, output, "output.display", "output.linear");
  checkStillWorks(small);
}

TEST_CASE("parts of one buffer overlap by their ranges", "[errors]") {
  SmallDenoiser small;
  const std::size_t bytes = small.buffers.output.linear.requiredBytes(small.buffers.frame.size);
  const cl::Buffer whole(small.device.context, CL_MEM_READ_WRITE, 4 * bytes);
  Output output = small.buffers.output;
  output.linear = at(output.linear, whole(), bytes);
  output.display = at(output.display, whole(), 2 * bytes);
  CHECK_NOTHROW(small.denoiser.denoise(small.buffers.frame, output).wait());
  output.display = at(output.display, whole(), 2 * bytes - 4);
  checkOverlap(small, output, "output.display", "output.linear");
  // A buffer made of a part of it.
  cl_buffer_region region{0, 2 * bytes};
  cl::Buffer parent = whole;
  const cl::Buffer part = parent.createSubBuffer(CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region);
  output.display = at(output.display, part(), 0);
  CHECK_NOTHROW(small.denoiser.denoise(small.buffers.frame, output).wait());
  output.display = at(output.display, part(), 4);
  checkOverlap(small, output, "output.display", "output.linear");
  checkStillWorks(small);
}

TEST_CASE("outputs may lie between inputs, as members of structs or side by side", "[errors]") {
  SmallDenoiser small;
  Frame frame = small.buffers.frame;
  Output output = small.buffers.output;
  const std::size_t pixels = std::size_t(frame.size.width) * std::size_t(frame.size.height);
  const cl::Buffer structs(small.device.context, CL_MEM_READ_WRITE, 2 * kPixel * pixels);
  small.device.queue.enqueueFillBuffer(structs, 0.5f, 0, 2 * kPixel * pixels);
  frame.albedo.memory = output.linear.memory = structs();
  SECTION("structs") {
    frame.albedo.pixelStrideBytes = output.linear.pixelStrideBytes = 2 * kPixel;
    output.linear.offsetBytes = kPixel;
  }
  SECTION("side by side") {
    const auto row = std::ptrdiff_t(kPixel) * frame.size.width;
    frame.albedo.rowPitchBytes = output.linear.rowPitchBytes = 2 * row;
    output.linear.offsetBytes = std::size_t(row);
  }
  small.denoiser.prepare(frame, output);
  CHECK_NOTHROW(small.denoiser.denoise(frame, output).wait());
  output.linear.offsetBytes -= 4;
  checkRefused({ErrorCode::InvalidArgument, "denoise", "output.linear", "no other image", "albedo"},
               [&] { small.denoiser.denoise(frame, output); });
}

TEST_CASE("linear radiance in place needs one layout", "[errors]") {
  SmallDenoiser small;
  const Picture expected = small.run(0);
  small.buffers.upload(0);
  Output output = small.buffers.output;
  output.linear.memory = small.buffers.frame.radiance.memory;
  small.denoiser.resetHistory();
  small.denoiser.denoise(small.buffers.frame, output).wait();
  CHECK(small.buffers.download().display.pixels == expected.display.pixels);
  const cl::Buffer larger(small.device.context, CL_MEM_READ_WRITE,
                          4 + output.linear.requiredBytes(small.buffers.frame.size));
  Frame frame = small.buffers.frame;
  frame.radiance.memory = output.linear.memory = larger();
  output.linear.offsetBytes = 4;
  checkRefused({ErrorCode::InvalidArgument, "denoise", "output.linear", "same layout", "radiance"},
               [&] { small.denoiser.denoise(frame, output); });
}

}  // namespace quell::tests
