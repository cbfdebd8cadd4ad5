// What the handles of the C API stand for.
#pragma once

#include <quell/quell.h>

#include <quell/denoiser.hpp>
#include <quell/settings.hpp>
#include <string>
#include <vector>

struct quell_settings {
  quell::Settings settings;
  std::string text;                          // last handed out by quellGetSetting
  std::vector<quell::InputNeed> needs = {};  // as of quellCountInputNeeds
};

struct quell_denoiser {
  quell::Denoiser denoiser;
  quell::MemoryUse memory;                       // as of quellGetMemoryUse
  quell::Timings timings;                        // as of quellGetTimings
  quell::FrameCheck check;                       // as of quellCheckFrame
  std::vector<std::string> sentences = {};       // of its findings
  quell::CaptureState capture = {};              // as of quellGetCaptureState
  std::vector<quell::StageKernel> kernels = {};  // as of quellCountStageKernels
  std::vector<std::string> buffers = {};         // as of quellCountBuffers
  quell::BackgroundMap background = {};          // as of quellGetBackgroundMap
};
