// Buffers that denoise() refuses, before anything is enqueued.
#include <functional>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

struct Image {
  const char* name;
  ImageView Frame::*input;
  ImageView Output::*output;

  ImageView& of(Frame& frame, Output& out) const { return input != nullptr ? frame.*input : out.*output; }
};

const Image kImages[] = {
    {"radiance", &Frame::radiance, nullptr},           {"normalWorld", &Frame::normalWorld, nullptr},
    {"positionWorld", &Frame::positionWorld, nullptr}, {"albedo", &Frame::albedo, nullptr},
    {"emission", &Frame::emission, nullptr},           {"output.linear", nullptr, &Output::linear},
    {"output.display", nullptr, &Output::display},
};

// Denoises with one image's memory replaced.
void denoiseWith(SmallDenoiser& small, const Image& image, cl_mem memory) {
  Frame frame = small.buffers.frame;
  Output output = small.buffers.output;
  image.of(frame, output).memory = memory;
  small.denoiser.denoise(frame, output);
}

std::size_t bytesOf(SmallDenoiser& small, const Image& image) {
  return image.of(small.buffers.frame, small.buffers.output).requiredBytes(small.buffers.frame.size);
}

void checkEach(ErrorCode code, const std::string& expected, const std::string& got,
               const std::function<cl::Memory(SmallDenoiser&, const Image&)>& makeMemory) {
  SmallDenoiser small;
  for (const Image& image : kImages) {
    INFO(image.name);
    const cl::Memory memory = makeMemory(small, image);
    checkRefused({code, "denoise", image.name, expected, got}, [&] { denoiseWith(small, image, memory()); });
  }
  checkStillWorks(small);
}

}  // namespace

TEST_CASE("a null buffer is refused", "[errors]") {
  checkEach(ErrorCode::InvalidArgument, "a buffer object", "null",
            [](SmallDenoiser&, const Image&) { return cl::Memory(); });
}

TEST_CASE("a buffer that is one byte too small is refused", "[errors]") {
  checkEach(ErrorCode::InvalidArgument, "bytes for 37x21", "bytes",
            [](SmallDenoiser& small, const Image& image) {
              return cl::Buffer(small.device.context, CL_MEM_READ_WRITE, bytesOf(small, image) - 1);
            });
}

TEST_CASE("an offset beyond the end of the buffer is refused", "[errors]") {
  SmallDenoiser small;
  small.buffers.frame.radiance.offsetBytes = 4;
  checkRefused({ErrorCode::InvalidArgument, "denoise", "radiance", std::to_string(37 * 21 * 12 + 4),
                std::to_string(37 * 21 * 12)},
               [&] { small.enqueue(); });
  small.buffers.frame.radiance.offsetBytes = 0;
  checkStillWorks(small);
}

TEST_CASE("a buffer of another context is refused", "[errors]") {
  const OpenDevice other;
  checkEach(ErrorCode::WrongContext, "the denoiser's context", "another",
            [&other](SmallDenoiser& small, const Image& image) {
              return cl::Buffer(other.context, CL_MEM_READ_WRITE, bytesOf(small, image));
            });
}

TEST_CASE("an image object in place of a buffer is refused", "[errors]") {
  SmallDenoiser probe;
  if (probe.device.device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() == 0) return;
  checkEach(ErrorCode::InvalidArgument, "a buffer object", "an image object",
            [](SmallDenoiser& small, const Image&) {
              return cl::Image2D(small.device.context, CL_MEM_READ_WRITE, cl::ImageFormat(CL_RGBA, CL_FLOAT),
                                 64, 64);
            });
}

TEST_CASE("inputs that cannot be read and outputs that cannot be written are refused", "[errors]") {
  SmallDenoiser small;
  for (const Image& image : kImages) {
    INFO(image.name);
    const bool output = image.output != nullptr;
    const auto make = [&](cl_mem_flags flags) {
      return cl::Buffer(small.device.context, flags, bytesOf(small, image));
    };
    const cl::Buffer wrong = make(output ? CL_MEM_READ_ONLY : CL_MEM_WRITE_ONLY);
    checkRefused({ErrorCode::InvalidArgument, "denoise", image.name, output ? "writable" : "readable",
                  output ? "CL_MEM_READ_ONLY" : "CL_MEM_WRITE_ONLY"},
                 [&] { denoiseWith(small, image, wrong()); });
    const cl::Buffer right = make(output ? CL_MEM_WRITE_ONLY : CL_MEM_READ_ONLY);
    CHECK_NOTHROW(denoiseWith(small, image, right()));
  }
  small.device.queue.finish();
  checkStillWorks(small);
}

TEST_CASE("a part of a buffer counts with its own size", "[errors]") {
  SmallDenoiser small;
  const std::size_t bytes = bytesOf(small, kImages[0]);
  cl::Buffer whole(small.device.context, CL_MEM_READ_WRITE, 2 * bytes);
  cl_buffer_region region{0, bytes - 4};
  const cl::Buffer part = whole.createSubBuffer(CL_MEM_READ_ONLY, CL_BUFFER_CREATE_TYPE_REGION, &region);
  checkRefused(
      {ErrorCode::InvalidArgument, "denoise", "radiance", std::to_string(bytes), std::to_string(bytes - 4)},
      [&] { denoiseWith(small, kImages[0], part()); });
  region.size = bytes;
  const cl::Buffer enough = whole.createSubBuffer(CL_MEM_READ_ONLY, CL_BUFFER_CREATE_TYPE_REGION, &region);
  small.device.queue.enqueueFillBuffer(whole, 0.5f, 0, 2 * bytes / 4 * 4);
  CHECK_NOTHROW(denoiseWith(small, kImages[0], enough()));
  small.device.queue.finish();
  checkStillWorks(small);
}

}  // namespace quell::tests
