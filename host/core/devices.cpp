#include <algorithm>
#include <cctype>
#include <quell/devices.hpp>
#include <quell/error.hpp>

#include "host/core/cl_error.hpp"

namespace quell {
namespace {

const char* typeName(cl_device_type type) {
  if ((type & CL_DEVICE_TYPE_GPU) != 0) return "GPU";
  if ((type & CL_DEVICE_TYPE_CPU) != 0) return "CPU";
  if ((type & CL_DEVICE_TYPE_ACCELERATOR) != 0) return "accelerator";
  return "other";
}

std::vector<cl::Platform> platforms() {
  std::vector<cl::Platform> found;
  try {
    cl::Platform::get(&found);
  } catch (const cl::Error&) {
    found.clear();  // the loader reports "no platform" as an error
  }
  if (found.empty()) {
    throw Error(
        ErrorCode::NoDevice,
        {"devices", "",
         "an OpenCL platform (install your GPU's driver, or pocl-opencl-icd to run on the CPU)", "none"});
  }
  return found;
}

std::vector<cl::Device> devicesOf(const cl::Platform& platform) {
  std::vector<cl::Device> found;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &found);
  } catch (const cl::Error& error) {
    if (error.err() != CL_DEVICE_NOT_FOUND) throw translateClError(error.err(), error.what(), "devices");
  }
  return found;
}

DeviceInfo describe(const cl::Platform& platform, const cl::Device& device, int index) {
  DeviceInfo info;
  info.platform = platform();
  info.device = device();
  info.index = index;
  info.platformName = platform.getInfo<CL_PLATFORM_NAME>();
  info.name = device.getInfo<CL_DEVICE_NAME>();
  info.vendor = device.getInfo<CL_DEVICE_VENDOR>();
  info.version = device.getInfo<CL_DEVICE_VERSION>();
  info.driverVersion = device.getInfo<CL_DRIVER_VERSION>();
  info.type = typeName(device.getInfo<CL_DEVICE_TYPE>());
  info.computeUnits = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  info.localMemoryBytes = device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
  info.globalMemoryBytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  info.maxWorkGroup = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
  info.images = device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() != 0;
  info.halfArithmetic = device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp16") != std::string::npos;
  info.profiling = (device.getInfo<CL_DEVICE_QUEUE_PROPERTIES>() & CL_QUEUE_PROFILING_ENABLE) != 0;
  return info;
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool matches(const DeviceInfo& info, const std::string& spec) {
  const bool isIndex = !spec.empty() && spec.find_first_not_of("0123456789") == std::string::npos;
  if (isIndex) return spec == std::to_string(info.index);
  return lowerCase(info.name + "\n" + info.platformName).find(lowerCase(spec)) != std::string::npos;
}

int preference(const DeviceInfo& info) {
  if (info.type == "GPU") return 0;
  if (info.type == "accelerator") return 1;
  return info.type == "CPU" ? 2 : 3;
}

}  // namespace

std::vector<DeviceInfo> listDevices() {
  return withClErrors("devices", [] {
    std::vector<DeviceInfo> infos;
    for (const cl::Platform& platform : platforms())
      for (const cl::Device& device : devicesOf(platform))
        infos.push_back(describe(platform, device, static_cast<int>(infos.size())));
    if (infos.empty()) {
      throw Error(ErrorCode::NoDevice,
                  {"devices", "",
                   "an OpenCL device (install your GPU's driver, or pocl-opencl-icd to run on "
                   "the CPU)",
                   "platforms without devices"});
    }
    return infos;
  });
}

DeviceInfo chooseDevice(const std::string& spec) {
  const std::vector<DeviceInfo> infos = listDevices();
  const DeviceInfo* best = nullptr;
  std::string names;
  for (const DeviceInfo& info : infos) {
    names += (names.empty() ? "" : "; ") + std::to_string(info.index) + ": " + info.name;
    if (matches(info, spec) && (best == nullptr || preference(info) < preference(*best))) best = &info;
  }
  if (best == nullptr) {
    throw Error(ErrorCode::NoDevice,
                {"devices", spec, "an index or part of a device or platform name", names});
  }
  return *best;
}

}  // namespace quell
