// OpenCL image objects as inputs and outputs: the same values give the same picture as buffers of them.
#include <CL/cl_half.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 2;

struct Texels {
  cl_channel_order order = CL_RGBA;
  cl_channel_type type = CL_FLOAT;
};

bool hasImages(const OpenDevice& device) { return device.device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() != 0; }

std::size_t typeBytes(cl_channel_type type) { return type == CL_FLOAT ? 4 : type == CL_HALF_FLOAT ? 2 : 1; }

void store(unsigned char* where, cl_channel_type type, float value) {
  if (type == CL_FLOAT) {
    std::memcpy(where, &value, sizeof(value));
  } else if (type == CL_HALF_FLOAT) {
    const cl_half half = cl_half_from_float(value, CL_HALF_RTE);
    std::memcpy(where, &half, sizeof(half));
  } else if (type == CL_UNORM_INT8) {
    *where = static_cast<unsigned char>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
  } else {
    const auto byte = static_cast<signed char>(std::lround(std::clamp(value, -1.0f, 1.0f) * 127.0f));
    std::memcpy(where, &byte, 1);
  }
}

// An image of four components a texel.
class TexelImage {
 public:
  TexelImage(const OpenDevice& device, Size size, Texels texels)
      : image(device.context, CL_MEM_READ_WRITE, cl::ImageFormat(texels.order, texels.type),
              std::size_t(size.width), std::size_t(size.height)),
        m_queue(device.queue),
        m_size(size),
        m_texels(texels) {}

  void write(const io::Image& values, bool bottomUp) {
    const std::size_t component = typeBytes(m_texels.type);
    std::vector<unsigned char> bytes(std::size_t(m_size.width) * std::size_t(m_size.height) * 4 * component);
    for (int y = 0; y < m_size.height; ++y)
      for (int x = 0; x < m_size.width; ++x)
        for (int c = 0; c < values.channels; ++c) {
          const int row = bottomUp ? m_size.height - 1 - y : y;
          const int place = m_texels.order == CL_BGRA && c < 3 ? 2 - c : c;
          const std::size_t texel = std::size_t(row) * std::size_t(m_size.width) + std::size_t(x);
          store(&bytes[(4 * texel + std::size_t(place)) * component], m_texels.type, values.at(x, y, c));
        }
    m_queue.enqueueWriteImage(image, CL_TRUE, {0, 0, 0}, region(), 0, 0, bytes.data());
  }

  // Of floats.
  io::Image read(bool bottomUp) const {
    std::vector<float> texels(std::size_t(m_size.width) * std::size_t(m_size.height) * 4);
    m_queue.enqueueReadImage(image, CL_TRUE, {0, 0, 0}, region(), 0, 0, texels.data());
    io::Image values(m_size.width, m_size.height, 3);
    for (int y = 0; y < m_size.height; ++y)
      for (int x = 0; x < m_size.width; ++x)
        for (int c = 0; c < 3; ++c) {
          const int row = bottomUp ? m_size.height - 1 - y : y;
          values.at(x, y, c) =
              texels[4 * (std::size_t(row) * std::size_t(m_size.width) + std::size_t(x)) + std::size_t(c)];
        }
    return values;
  }

  cl::Image2D image;

 private:
  cl::array<cl::size_type, 3> region() const {
    return {std::size_t(m_size.width), std::size_t(m_size.height), 1};
  }

  cl::CommandQueue m_queue;
  Size m_size;
  Texels m_texels;
};

struct ObjectSetup {
  ImageSetup images;
  std::vector<ImageView Frame::*> inputs;  // as image objects
  Texels texels = {};
  bool outputs = false;
  bool bottomUp = false;
};

const std::vector<ImageView Frame::*> kAllInputs = {&Frame::radiance, &Frame::normalWorld,
                                                    &Frame::positionWorld, &Frame::albedo, &Frame::emission};

// Denoises the first frames of the built-in sequence with some of their images as image objects.
Picture denoised(const ObjectSetup& setup) {
  const OpenDevice device;
  FrameBuffers buffers(device, setup.images);
  Denoiser denoiser(device.context, device.device, device.queue, Settings(), testOptions());
  Frame frame = buffers.frame;
  Output output = buffers.output;
  std::vector<TexelImage> inputs;
  const auto asObject = [&](const ImageView& view, const TexelImage& texels) {
    const ImageView object = imageObject(texels.image(), view.channels);
    return setup.bottomUp ? bottomUp(object, frame.size) : object;
  };
  for (const auto input : setup.inputs) {
    inputs.emplace_back(device, frame.size, setup.texels);
    frame.*input = asObject(buffers.frame.*input, inputs.back());
  }
  const TexelImage linear(device, frame.size, {}), display(device, frame.size, {});
  if (setup.outputs) output = {asObject(output.linear, linear), asObject(output.display, display)};
  denoiser.prepare(frame, output);
  for (int number = 0; number <= kLastFrame; ++number) {
    buffers.upload(number);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const ImageView& view = buffers.frame.*setup.inputs[i];
      inputs[i].write(decodeImage(buffers.bytes(view), view, frame.size), setup.bottomUp);
    }
    frame.camera = buffers.frame.camera;
    denoiser.denoise(frame, output).wait();
  }
  if (setup.outputs) return {linear.read(setup.bottomUp), display.read(setup.bottomUp)};
  return buffers.download();
}

double largestDifference(const io::Image& a, const io::Image& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, double(std::abs(a.pixels[i] - b.pixels[i])));
  return largest;
}

}  // namespace

TEST_CASE("image objects of floats hold what buffers hold, bit for bit", "[core]") {
  if (!hasImages(OpenDevice())) return;
  const Picture expected = denoised({});
  CHECK(denoised({{}, {}, {}, true}) == expected);
  CHECK(denoised({{}, kAllInputs, {}, true}) == expected);
  CHECK(denoised({{}, kAllInputs, {}, true, true}) == expected);
}

TEST_CASE("image objects of halves hold what buffers of halves hold", "[core]") {
  if (!hasImages(OpenDevice())) return;
  ImageSetup halves;
  halves.roundToHalf = true;
  CHECK(denoised({halves, kAllInputs, {CL_RGBA, CL_HALF_FLOAT}}) == denoised({halves, {}}));
}

TEST_CASE("image objects of normalised integers are converted, in the order of their channels", "[core]") {
  if (!hasImages(OpenDevice())) return;
  const Picture expected = denoised({});
  const Picture albedo = denoised({{}, {&Frame::albedo}, {CL_BGRA, CL_UNORM_INT8}});
  CHECK(largestDifference(albedo.display, expected.display) < 0.02);
  const Picture normal = denoised({{}, {&Frame::normalWorld}, {CL_RGBA, CL_SNORM_INT8}});
  CHECK(largestDifference(normal.display, expected.display) < 0.05);
}

TEST_CASE("image objects of object ids hold integers, extended, or the bits of floats", "[core]") {
  ImageSetup setup;
  setup.objectId = {ComponentFormat::UInt32, 1};
  SmallDenoiser small(setup, testOptions(), 0, Settings("svgf"));
  if (!hasImages(small.device)) return;
  const std::size_t pixels = std::size_t(setup.size.width) * std::size_t(setup.size.height);
  Frame frame = small.buffers.frame;
  frame.objectId = imageObject(nullptr, 1);
  small.denoiser.prepare(frame, small.buffers.output);
  // One kernel for all of them: what the texels are, the image says. Kept ids are read as signed integers.
  const auto idsOf = [&](cl_channel_type type, auto texel) {
    const cl::Image2D image(small.device.context, CL_MEM_READ_ONLY, cl::ImageFormat(CL_RGBA, type),
                            std::size_t(setup.size.width), std::size_t(setup.size.height));
    std::vector<decltype(texel)> texels(4 * pixels);
    for (std::size_t i = 0; i < pixels; ++i) texels[4 * i] = texel;
    small.device.queue.enqueueWriteImage(image, CL_TRUE, {0, 0, 0},
                                         {std::size_t(setup.size.width), std::size_t(setup.size.height), 1},
                                         0, 0, texels.data());
    frame.objectId.memory = image();
    small.denoiser.denoise(frame, small.buffers.output).wait();
    const BufferContent ids = small.denoiser.readBuffer("objectIds");
    CHECK(std::count(ids.values.begin(), ids.values.end(), ids.values.front()) == std::ptrdiff_t(pixels));
    return ids.values.front();
  };
  CHECK(idsOf(CL_UNSIGNED_INT32, cl_uint(0x80000100)) == -2147483392.0f);
  CHECK(idsOf(CL_UNSIGNED_INT8, cl_uchar(200)) == 200.0f);
  CHECK(idsOf(CL_UNSIGNED_INT16, cl_ushort(60000)) == 60000.0f);
  CHECK(idsOf(CL_SIGNED_INT32, cl_int(-256)) == -256.0f);
  CHECK(idsOf(CL_SIGNED_INT16, cl_short(300)) == 300.0f);
  CHECK(idsOf(CL_FLOAT, cl_float(1.0f)) == float(0x3F800000));
}

TEST_CASE("history of another object is discarded where ids lie in an image object", "[core]") {
  if (!hasImages(OpenDevice())) return;
  const auto run = [](cl_uint second) {
    SmallDenoiser small;
    const Size size = small.buffers.frame.size;
    const cl::Image2D image(small.device.context, CL_MEM_READ_ONLY, cl::ImageFormat(CL_R, CL_UNSIGNED_INT32),
                            std::size_t(size.width), std::size_t(size.height));
    Frame frame = small.buffers.frame;
    frame.objectId = imageObject(image(), 1);
    small.denoiser.prepare(frame, small.buffers.output);
    for (int number = 0; number < 2; ++number) {
      small.buffers.upload(number);
      frame.camera = small.buffers.frame.camera;
      const cl_uint id = number == 0 ? 0xFFFFFFFEu : second;
      const std::vector<cl_uint> ids(std::size_t(size.width) * std::size_t(size.height), id);
      small.device.queue.enqueueWriteImage(image, CL_TRUE, {0, 0, 0},
                                           {std::size_t(size.width), std::size_t(size.height), 1}, 0, 0,
                                           ids.data());
      small.denoiser.denoise(frame, small.buffers.output).wait();
    }
    return small.buffers.download();
  };
  const Picture plain = SmallDenoiser().run(0, 1);
  CHECK(run(0xFFFFFFFEu) == plain);
  CHECK_FALSE(run(0xFFFFFFFFu).linear.pixels == plain.linear.pixels);
}

TEST_CASE("an image object is refused where it cannot be had, by prepare() where it is given", "[core]") {
  SmallDenoiser small;
  if (!hasImages(small.device)) return;
  Frame frame = small.buffers.frame;
  const auto make = [&](cl_channel_type type, std::size_t width) {
    return cl::Image2D(small.device.context, CL_MEM_READ_WRITE, cl::ImageFormat(CL_RGBA, type), width, 32);
  };
  const auto refused = [&](const cl::Memory& memory, const char* expected, const char* got) {
    frame.albedo = imageObject(memory(), 3);
    checkRefused({ErrorCode::InvalidArgument, "prepare", "albedo", expected, got},
                 [&] { small.denoiser.prepare(frame, small.buffers.output); });
  };
  refused(make(CL_UNSIGNED_INT8, 64), "floats, halves or normalised", "0x10da");
  refused(make(CL_FLOAT, 36), "at least 37x21", "36x32");
  refused(cl::Buffer(small.device.context, CL_MEM_READ_WRITE, 1 << 16), "an image object", "a buffer object");
  frame.albedo = imageObject(nullptr, 3);
  CHECK_NOTHROW(small.denoiser.prepare(frame, small.buffers.output));
  const cl::Image2D wrong = make(CL_UNSIGNED_INT8, 64);
  frame.albedo.memory = wrong();
  checkRefused({ErrorCode::InvalidArgument, "denoise", "albedo", "normalised", "0x10da"},
               [&] { small.denoiser.denoise(frame, small.buffers.output); });
  const cl::Image2D right = make(CL_UNORM_INT8, 64);
  frame.albedo.memory = right();
  CHECK_NOTHROW(small.denoiser.denoise(frame, small.buffers.output).wait());
}

}  // namespace quell::tests
