// The README's example: frames of a renderer's own memory, denoised on the renderer's own queue.
#include <CL/cl.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <quell/quell.hpp>
#include <vector>

namespace {

constexpr quell::Size kSize = {64, 48};
constexpr int kFrames = 3;

// What the renderer has in device memory.
struct Images {
  cl_mem radiance;                  // float4: the sum of a frame's samples, and their number in w
  cl_mem normal, position, albedo;  // float3, packed
  cl_mem display;                   // a cl_image2d of 8-bit RGBA
};

// A camera that drives forward.
std::array<double, 3> eyeOf(int frame) { return {0.0, 0.0, -0.1 * frame}; }
std::array<double, 3> targetOf(int frame) { return {0.0, 0.0, -0.1 * frame - 1.0}; }
void trace(const Images&, int) {}  // the renderer's work: everything stays as it is here

void renderFrames(cl_context context, cl_device_id device, cl_command_queue queue, const Images& images) {
  // [example]
  quell::Denoiser denoiser(context, device, queue);
  quell::Frame frame;
  frame.size = kSize;
  frame.radiance = quell::summed(quell::packedImage(images.radiance, 4));  // sums, their counts in w
  frame.normalWorld = quell::packedImage(images.normal, 3);  // see ImageView for half, structs, strides
  frame.positionWorld = quell::packedImage(images.position, 3);
  frame.albedo = quell::packedImage(images.albedo, 3);
  quell::Output output;
  output.display = quell::imageObject(images.display, 4);  // a cl_image2d; packedImage() for a buffer
  denoiser.prepare(frame, output);                         // once: builds and allocates
  for (int number = 0; number < kFrames; ++number) {
    trace(images, number);
    frame.camera.worldToClip = quell::lookAt(eyeOf(number), targetOf(number), {0, 1, 0}, 60.0, 4.0 / 3.0);
    denoiser.denoise(frame, output);  // every frame: only enqueues
  }
  // [example]
}

cl_mem makeBuffer(cl_context context, const std::vector<float>& pixel) {
  std::vector<float> pixels;
  for (int i = 0; i < kSize.width * kSize.height; ++i)
    pixels.insert(pixels.end(), pixel.begin(), pixel.end());
  return clCreateBuffer(context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, pixels.size() * sizeof(float),
                        pixels.data(), nullptr);
}

cl_mem makeImage(cl_context context) {
  const cl_image_format format = {CL_RGBA, CL_UNORM_INT8};
  cl_image_desc description;
  std::memset(&description, 0, sizeof(description));
  description.image_type = CL_MEM_OBJECT_IMAGE2D;
  description.image_width = kSize.width;
  description.image_height = kSize.height;
  return clCreateImage(context, CL_MEM_READ_WRITE, &format, &description, nullptr, nullptr);
}

}  // namespace

int main() {
  const char* spec = std::getenv("QUELL_TEST_DEVICE");
  const quell::DeviceInfo info = quell::chooseDevice(spec != nullptr ? spec : "");
  cl_context context = clCreateContext(nullptr, 1, &info.device, nullptr, nullptr, nullptr);
  cl_command_queue queue = clCreateCommandQueue(context, info.device, 0, nullptr);
  const Images images = {makeBuffer(context, {1.0f, 1.0f, 1.0f, 4.0f}),
                         makeBuffer(context, {0.0f, 0.0f, 1.0f}), makeBuffer(context, {-2.0f, -2.0f, -2.0f}),
                         makeBuffer(context, {0.5f, 0.5f, 0.5f}), makeImage(context)};
  renderFrames(context, info.device, queue, images);

  unsigned char pixel[4] = {};
  const std::size_t origin[3] = {0, 0, 0}, region[3] = {1, 1, 1};
  clEnqueueReadImage(queue, images.display, CL_TRUE, origin, region, 0, 0, pixel, 0, nullptr, nullptr);
  std::printf("%s: %d %d %d %d\n", info.name.c_str(), pixel[0], pixel[1], pixel[2], pixel[3]);
  for (cl_mem memory : {images.radiance, images.normal, images.position, images.albedo, images.display})
    clReleaseMemObject(memory);
  clReleaseCommandQueue(queue);
  clReleaseContext(context);
  // A constant image stays constant: 255 * (1 / 4)^(1 / 2.2) = 135.8.
  return pixel[0] == 136 && pixel[3] == 255 ? 0 : 1;
}
