// The README's example: one frame of a renderer's own buffers, denoised on the renderer's own queue.
#include <cstdio>
#include <cstdlib>
#include <quell/quell.hpp>
#include <vector>

namespace {

constexpr quell::Size kSize = {64, 48};

// [example]
void denoiseOneFrame(cl_context context, cl_device_id device, cl_command_queue queue, cl_mem radiance,
                     cl_mem normal, cl_mem position, cl_mem albedo, cl_mem display,
                     const quell::Camera& camera) {
  quell::Denoiser denoiser(context, device, queue);
  quell::Frame frame;
  frame.size = kSize;
  frame.camera = camera;
  frame.radiance = quell::packedImage(radiance, 3);  // packed float3; see ImageView for float4, half, strides
  frame.normalWorld = quell::packedImage(normal, 3);
  frame.positionWorld = quell::packedImage(position, 3);
  frame.albedo = quell::packedImage(albedo, 3);
  quell::Output output;
  output.display = quell::packedImage(display, 3);
  denoiser.prepare(frame, output);                            // once: builds and allocates
  const quell::Event done = denoiser.denoise(frame, output);  // every frame: only enqueues
  done.wait();
}
// [example]

cl_mem makeImage(cl_context context, float value) {
  std::vector<float> pixels(static_cast<std::size_t>(kSize.width * kSize.height) * 3, value);
  return clCreateBuffer(context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, pixels.size() * sizeof(float),
                        pixels.data(), nullptr);
}

}  // namespace

int main() {
  const char* spec = std::getenv("QUELL_TEST_DEVICE");
  const quell::DeviceInfo info = quell::chooseDevice(spec != nullptr ? spec : "");
  cl_context context = clCreateContext(nullptr, 1, &info.device, nullptr, nullptr, nullptr);
  cl_command_queue queue = clCreateCommandQueue(context, info.device, 0, nullptr);
  quell::Camera camera;
  camera.worldToClip = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0};
  cl_mem radiance = makeImage(context, 0.25f), normal = makeImage(context, 0.57735f);
  cl_mem position = makeImage(context, -2.0f), albedo = makeImage(context, 0.5f),
         display = makeImage(context, 0.0f);
  denoiseOneFrame(context, info.device, queue, radiance, normal, position, albedo, display, camera);

  float pixel[3] = {};
  clEnqueueReadBuffer(queue, display, CL_TRUE, 0, sizeof(pixel), pixel, 0, nullptr, nullptr);
  std::printf("%s: %.4f %.4f %.4f\n", info.name.c_str(), pixel[0], pixel[1], pixel[2]);
  for (cl_mem image : {radiance, normal, position, albedo, display}) clReleaseMemObject(image);
  clReleaseCommandQueue(queue);
  clReleaseContext(context);
  // A constant image stays constant: 0.25^(1/2.2) = 0.5325.
  return pixel[0] > 0.532f && pixel[0] < 0.533f ? 0 : 1;
}
