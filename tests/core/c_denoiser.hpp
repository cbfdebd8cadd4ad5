// The C API in tests: conversions from C++, handles that destroy themselves, and the last error.
#pragma once

#include <quell/quell.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <memory>
#include <string>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {

struct DestroyDenoiser {
  void operator()(quell_denoiser* denoiser) const { quellDestroyDenoiser(denoiser); }
};
using DenoiserHandle = std::unique_ptr<quell_denoiser, DestroyDenoiser>;

inline quell_component_format toC(ComponentFormat format) {
  if (format == ComponentFormat::UInt32) return QUELL_UINT32;
  if (format == ComponentFormat::ImageObject) return QUELL_IMAGE_OBJECT;
  return format == ComponentFormat::Float32 ? QUELL_FLOAT32 : QUELL_FLOAT16;
}

inline quell_image_view toC(const ImageView& view) {
  quell_image_view result = quellPackedImage(view.memory, view.channels, toC(view.format));
  result.offsetBytes = view.offsetBytes;
  result.pixelStrideBytes = view.pixelStrideBytes;
  result.rowPitchBytes = view.rowPitchBytes;
  result.sum = static_cast<quell_sum>(view.sum);
  return result;
}

inline quell_frame toC(const Frame& frame) {
  quell_frame result;
  QUELL_INIT(result);
  result.width = frame.size.width;
  result.height = frame.size.height;
  result.renderWidth = frame.renderSize.width;
  result.renderHeight = frame.renderSize.height;
  std::memcpy(result.camera.worldToClip, frame.camera.worldToClip.data(), sizeof(Matrix4));
  std::memcpy(result.camera.worldToClipPrev, frame.camera.worldToClipPrev.data(), sizeof(Matrix4));
  std::memcpy(result.camera.jitterPx, frame.camera.jitterPx.data(), sizeof(result.camera.jitterPx));
  result.demodulated = frame.demodulated ? 1 : 0;
  result.depthKind = static_cast<quell_depth_kind>(frame.depthKind);
  result.depthNear = frame.depthNear;
  result.depthFar = std::isinf(frame.depthFar) ? 0.0 : frame.depthFar;
  result.motionScale[0] = frame.motionScale[0];
  result.motionScale[1] = frame.motionScale[1];
  result.sampleCount = frame.sampleCount;
  forEachInput(frame, result,
               [](const ImageFacts&, const ImageView& view, quell_image_view& given) { given = toC(view); });
  return result;
}

inline quell_output toC(const Output& output) {
  quell_output result;
  QUELL_INIT(result);
  result.linear = toC(output.linear);
  result.display = toC(output.display);
  return result;
}

/// A device with buffers, and a denoiser of the C API that is prepared for them.
struct CDenoiser {
  explicit CDenoiser(const ImageSetup& setup = {}, cl_command_queue_properties properties = 0,
                     quell_timer_mode timers = QUELL_TIMERS_OFF, const char* keptBuffers = nullptr)
      : device(properties), buffers(device, setup) {
    quell_options options;
    QUELL_INIT(options);
    options.timers = timers;
    options.cacheDirectory = "";
    options.keptBuffers = keptBuffers;
    quell_denoiser* made = nullptr;
    REQUIRE(quellCreateDenoiser(device.context(), device.device(), device.queue(), nullptr, &options,
                                &made) == QUELL_SUCCESS);
    denoiser.reset(made);
    const quell_frame frame = toC(buffers.frame);
    const quell_output output = toC(buffers.output);
    REQUIRE(quellPrepare(denoiser.get(), &frame, &output) == QUELL_SUCCESS);
  }

  Picture run(int first, int last) {
    for (int number = first; number <= last; ++number) {
      buffers.upload(number);
      const quell_frame frame = toC(buffers.frame);
      const quell_output output = toC(buffers.output);
      cl_event done = nullptr;
      REQUIRE(quellDenoise(denoiser.get(), &frame, &output, 0, nullptr, &done) == QUELL_SUCCESS);
      Event(done).wait();
    }
    return buffers.download();
  }

  OpenDevice device;
  FrameBuffers buffers;
  DenoiserHandle denoiser;
};

struct SettingsHandle {
  explicit SettingsHandle(const char* method = nullptr) {
    REQUIRE(quellCreateSettings(method, &settings) == QUELL_SUCCESS);
  }
  SettingsHandle(const SettingsHandle&) = delete;
  SettingsHandle& operator=(const SettingsHandle&) = delete;
  ~SettingsHandle() { quellDestroySettings(settings); }
  std::string text(const char* name) const {
    const char* value = nullptr;
    REQUIRE(quellGetSetting(settings, name, &value) == QUELL_SUCCESS);
    return value;
  }
  quell_settings* settings = nullptr;
};

/// The last error must have this status and argument.
inline void checkError(quell_status returned, quell_status status, const std::string& argument) {
  quell_error error;
  QUELL_INIT(error);
  REQUIRE(quellGetLastError(&error) == QUELL_SUCCESS);
  INFO(error.message);
  CHECK(returned == status);
  CHECK(error.status == status);
  CHECK(error.buffer == argument);
  CHECK(std::string(error.message) == quellErrorMessage());
  CHECK_THAT(error.message, Catch::Contains(quellStatusName(status)) && Catch::Contains(error.expected) &&
                                Catch::Contains(error.got) && Catch::Contains(error.stage));
}

}  // namespace quell::tests
