#include "renderer.hpp"

#include <cstdlib>

namespace embedding {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 54;
constexpr std::size_t kPixels = std::size_t(kWidth) * kHeight;
/// Floats of a surface record: normal, position, albedo, and one that nobody reads.
constexpr std::size_t kSurfaceFloats = 10;
constexpr std::size_t kNormalAt = 0, kPositionAt = 3, kAlbedoAt = 6;
/// Half the picture's height one metre in front of the camera, m.
constexpr double kTangent = 0.6;
constexpr double kEyeHeight = 1.0;  // m
constexpr double kStep = 0.05;      // m per frame, sideways

constexpr char kSource[] = R"(
uint hash(uint v) {
  const uint state = v * 747796405u + 2891336453u;
  const uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

__kernel void trace(__global float4* radiance, __global float* surfaces, int width, int height, float tangent,
                    float3 eye, int number) {
  const int x = (int)get_global_id(0), y = (int)get_global_id(1);
  const int pixel = y * width + x;
  const float3 direction = (float3)((2.0f * (x + 0.5f) / width - 1.0f) * tangent * width / height,
                                    (1.0f - 2.0f * (y + 0.5f) / height) * tangent, -1.0f);
  const float toWall = 6.0f, toFloor = -eye.y / direction.y;
  const int floorHit = toFloor > 0.0f && toFloor < toWall;
  const float3 position = eye + direction * (floorHit ? toFloor : toWall);
  const float3 normal = floorHit ? (float3)(0.0f, 1.0f, 0.0f) : (float3)(0.0f, 0.0f, 1.0f);
  const int tile = (int)floor(position.x) + (int)floor(position.y + 0.5f) + (int)floor(position.z);
  const float3 albedo = (tile & 1) ? (float3)(0.8f, 0.5f, 0.3f) : (float3)(0.2f, 0.3f, 0.6f);
  const float noise = 2.0f * (hash((uint)pixel + hash((uint)number)) >> 8) / 16777216.0f;
  __global float* surface = surfaces + 10 * pixel;
  vstore3(normal, 0, surface);
  vstore3(position, 0, surface + 3);
  vstore3(albedo, 0, surface + 6);
  radiance[pixel] = (float4)(albedo * noise, 1.0f);
}
)";

quell::ImageView surfaceView(cl_mem surfaces, std::size_t firstFloat) {
  quell::ImageView view = quell::packedImage(surfaces, 3);
  view.offsetBytes = firstFloat * sizeof(float);
  view.pixelStrideBytes = kSurfaceFloats * sizeof(float);
  return view;
}

double eyeX(int number) { return kStep * number; }

quell::Matrix4 worldToClip(double x) {
  const double aspect = double(kWidth) / kHeight;
  const double across = 1.0 / (kTangent * aspect), up = 1.0 / kTangent;
  return {across, 0, 0, -across * x, 0, up, 0, -up * kEyeHeight, 0, 0, 0, 0, 0, 0, -1, 0};
}

Buffer makeBuffer(cl_context context, std::size_t floatsPerPixel) {
  cl_int code = CL_SUCCESS;
  Buffer buffer(
      clCreateBuffer(context, CL_MEM_READ_WRITE, kPixels * floatsPerPixel * sizeof(float), nullptr, &code));
  check(code, "clCreateBuffer");
  return buffer;
}

Program makeProgram(const Device& device) {
  const char* source = kSource;
  cl_int code = CL_SUCCESS;
  Program program(clCreateProgramWithSource(device.context.get(), 1, &source, nullptr, &code));
  check(code, "clCreateProgramWithSource");
  check(clBuildProgram(program.get(), 1, &device.id, "", nullptr, nullptr), "clBuildProgram");
  return program;
}

template <class Value>
void setArgument(const Kernel& kernel, cl_uint index, const Value& value) {
  check(clSetKernelArg(kernel.get(), index, sizeof(Value), &value), "clSetKernelArg");
}

}  // namespace

Device::Device() {
  const char* spec = std::getenv("QUELL_TEST_DEVICE");
  id = quell::chooseDevice(spec != nullptr ? spec : "").device;
  cl_int code = CL_SUCCESS;
  context = Context(clCreateContext(nullptr, 1, &id, nullptr, nullptr, &code));
  check(code, "clCreateContext");
}

Queue Device::makeQueue(cl_command_queue_properties properties) const {
  cl_int code = CL_SUCCESS;
  Queue queue(clCreateCommandQueue(context.get(), id, properties, &code));
  check(code, "clCreateCommandQueue");
  return queue;
}

Renderer::Renderer(const Device& device, const Queue& queue)
    : m_queue(queue.get()),
      m_program(makeProgram(device)),
      m_radiance(makeBuffer(device.context.get(), 4)),
      m_surfaces(makeBuffer(device.context.get(), kSurfaceFloats)),
      m_linear(makeBuffer(device.context.get(), 3)),
      m_display(makeBuffer(device.context.get(), 4)) {
  cl_int code = CL_SUCCESS;
  m_trace = Kernel(clCreateKernel(m_program.get(), "trace", &code));
  check(code, "clCreateKernel");
}

Event Renderer::trace(int number, const std::vector<cl_event>& waitFor) {
  const cl_float3 eye = {{static_cast<float>(eyeX(number)), static_cast<float>(kEyeHeight), 0.0f, 0.0f}};
  setArgument(m_trace, 0, m_radiance.get());
  setArgument(m_trace, 1, m_surfaces.get());
  setArgument(m_trace, 2, cl_int(kWidth));
  setArgument(m_trace, 3, cl_int(kHeight));
  setArgument(m_trace, 4, static_cast<float>(kTangent));
  setArgument(m_trace, 5, eye);
  setArgument(m_trace, 6, cl_int(number));
  const std::size_t global[2] = {kWidth, kHeight};
  cl_event event = nullptr;
  check(clEnqueueNDRangeKernel(m_queue, m_trace.get(), 2, nullptr, global, nullptr, cl_uint(waitFor.size()),
                               waitFor.empty() ? nullptr : waitFor.data(), &event),
        "clEnqueueNDRangeKernel");
  return Event(event);
}

quell::Frame Renderer::frame(int number) const {
  quell::Frame frame;
  frame.size = {kWidth, kHeight};
  frame.camera.worldToClip = worldToClip(eyeX(number));
  frame.camera.worldToClipPrev = worldToClip(eyeX(number - 1));
  frame.radiance = quell::packedImage(m_radiance.get(), 4);
  frame.normalWorld = surfaceView(m_surfaces.get(), kNormalAt);
  frame.positionWorld = surfaceView(m_surfaces.get(), kPositionAt);
  frame.albedo = surfaceView(m_surfaces.get(), kAlbedoAt);
  return frame;
}

quell::Output Renderer::output() const {
  return {quell::packedImage(m_linear.get(), 3), quell::packedImage(m_display.get(), 4)};
}

Event Renderer::read(Picture& picture, cl_event waitFor) {
  picture.linear.assign(kPixels * 3, -1.0f);
  picture.display.assign(kPixels * 4, -1.0f);
  cl_event first = nullptr, second = nullptr;
  check(clEnqueueReadBuffer(m_queue, m_linear.get(), CL_FALSE, 0, picture.linear.size() * sizeof(float),
                            picture.linear.data(), 1, &waitFor, &first),
        "clEnqueueReadBuffer");
  const Event linear(first);
  check(clEnqueueReadBuffer(m_queue, m_display.get(), CL_FALSE, 0, picture.display.size() * sizeof(float),
                            picture.display.data(), 1, &first, &second),
        "clEnqueueReadBuffer");
  return Event(second);
}

}  // namespace embedding
