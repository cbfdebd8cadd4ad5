// Parameter structs: size and offset of the last member are the same on device and host.
#include <catch2/catch.hpp>
#include <cstddef>
#include <fstream>
#include <sstream>

#include "kernels/accumulate_filtered_params.h"
#include "kernels/accumulate_noisy_params.h"
#include "kernels/atrous_params.h"
#include "kernels/background_params.h"
#include "kernels/change_params.h"
#include "kernels/fit_params.h"
#include "kernels/gram_params.h"
#include "kernels/remodulate_params.h"
#include "kernels/temporal_antialiasing_params.h"
#include "kernels/variance_params.h"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

struct ParamsStruct {
  std::string header;
  std::string name;
  std::string lastMember;
  std::size_t size;
  std::size_t lastOffset;
};

#define QUELL_PARAMS(header, Struct, lastMember) \
  ParamsStruct { header, #Struct, #lastMember, sizeof(Struct), offsetof(Struct, lastMember) }

std::vector<ParamsStruct> paramsStructs() {
  return {
      QUELL_PARAMS("common/types.h", ImageViewParams, rowPitch),
      QUELL_PARAMS("common/types.h", PlaneParams, stride),
      QUELL_PARAMS("common/reprojection_params.h", ReprojectionParams, historyValid),
      QUELL_PARAMS("accumulate_noisy_params.h", AccumulateNoisyParams, momentsLeastWeight),
      QUELL_PARAMS("change_params.h", ChangeParams, momentsLeastWeight),
      QUELL_PARAMS("variance_params.h", VarianceParams, temporalFrames),
      QUELL_PARAMS("atrous_params.h", AtrousParams, iteration),
      QUELL_PARAMS("background_params.h", BackgroundParams, finish),
      QUELL_PARAMS("fit_params.h", FitParams, noiseAmplitude),
      QUELL_PARAMS("gram_params.h", GramParams, noiseVariance),
      QUELL_PARAMS("accumulate_filtered_params.h", AccumulateFilteredParams, leastWeight),
      QUELL_PARAMS("remodulate_params.h", RemodulateParams, displayOutput),
      QUELL_PARAMS("temporal_antialiasing_params.h", TemporalAntialiasingParams, newestWeight),
  };
}

// A kernel of one work-item that stores size and offset of each struct.
std::string sizesKernel(const std::vector<ParamsStruct>& structs) {
  std::ostringstream source;
  for (const ParamsStruct& params : structs) source << "#include \"" << params.header << "\"\n";
  source << "__kernel void sizes(__global uint* out) {\n";
  for (std::size_t i = 0; i < structs.size(); ++i) {
    const std::string& name = structs[i].name;
    source << "  { " << name << " v; out[" << 2 * i << "] = sizeof(" << name << "); out[" << 2 * i + 1
           << "] = (uint)((uintptr_t)&v." << structs[i].lastMember << " - (uintptr_t)&v); }\n";
  }
  source << "}\n";
  return source.str();
}

}  // namespace

TEST_CASE("parameter structs have the same layout on device and host", "[core]") {
  const std::vector<ParamsStruct> structs = paramsStructs();
  const OpenDevice device;
  cl::Program program(device.context, sizesKernel(structs));
  program.build({device.device}, "-cl-std=CL1.2 -I " QUELL_KERNEL_DIR);
  const cl::Buffer buffer(device.context, CL_MEM_WRITE_ONLY, structs.size() * 2 * sizeof(cl_uint));
  cl::Kernel kernel(program, "sizes");
  kernel.setArg(0, buffer);
  device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
  std::vector<cl_uint> sizes(structs.size() * 2);
  device.queue.enqueueReadBuffer(buffer, CL_TRUE, 0, sizes.size() * sizeof(cl_uint), sizes.data());
  for (std::size_t i = 0; i < structs.size(); ++i) {
    INFO(structs[i].name);
    CHECK(sizes[2 * i] == structs[i].size);
    CHECK(sizes[2 * i + 1] == structs[i].lastOffset);
  }
}

}  // namespace quell::tests
