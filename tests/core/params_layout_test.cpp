// Structs that host and kernels share: size and offset of the last member are the same on both.
#include <catch2/catch.hpp>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <type_traits>

#include "kernels/accumulate_filtered_params.h"
#include "kernels/accumulate_noisy_params.h"
#include "kernels/atrous_params.h"
#include "kernels/background_params.h"
#include "kernels/box_filter_params.h"
#include "kernels/change_params.h"
#include "kernels/common/edge_stops_params.h"
#include "kernels/common/frame_image_params.h"
#include "kernels/common/reprojection_params.h"
#include "kernels/common/types.h"
#include "kernels/demodulate_params.h"
#include "kernels/firefly_weights_params.h"
#include "kernels/fit_params.h"
#include "kernels/gram_params.h"
#include "kernels/guided_params.h"
#include "kernels/import_image_params.h"
#include "kernels/light_params.h"
#include "kernels/low_confidence_params.h"
#include "kernels/material_guides_params.h"
#include "kernels/median_filter_params.h"
#include "kernels/remodulate_params.h"
#include "kernels/render/scene_params.h"
#include "kernels/resample_history_params.h"
#include "kernels/separable_bilateral_params.h"
#include "kernels/soft_history_params.h"
#include "kernels/sparse_bilateral_params.h"
#include "kernels/temporal_antialiasing_params.h"
#include "kernels/variance_params.h"
#include "kernels/virtual_motion_params.h"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

// Structs that kernels and host share: header, name, last member.
#define QUELL_SHARED_STRUCTS(X)                                                        \
  X("common/types.h", ImageViewParams, rowPitch)                                       \
  X("common/types.h", PlaneParams, stride)                                             \
  X("common/edge_stops_params.h", EdgeStopParams, inverseRoughness)                    \
  X("common/frame_image_params.h", FrameImageParams, hitDistance)                      \
  X("common/frame_image_params.h", OutputImageParams, display)                         \
  X("common/reprojection_params.h", ReprojectionParams, historyValid)                  \
  X("accumulate_filtered_params.h", AccumulateFilteredParams, leastWeight)             \
  X("accumulate_noisy_params.h", AccumulateNoisyParams, antialiasBackground)           \
  X("atrous_params.h", AtrousParams, filtersVariance)                                  \
  X("background_params.h", BackgroundParams, finish)                                   \
  X("box_filter_params.h", BoxFilterParams, alongRows)                                 \
  X("change_params.h", ChangeParams, momentsLeastWeight)                               \
  X("demodulate_params.h", DemodulateParams, images)                                   \
  X("firefly_weights_params.h", FireflyWeightsParams, fireflyRatio)                    \
  X("fit_params.h", FitParams, noiseAmplitude)                                         \
  X("gram_params.h", GramParams, noiseVariance)                                        \
  X("guided_params.h", GuidedParams, epsilon)                                          \
  X("import_image_params.h", ImportImageParams, depthSlope)                            \
  X("light_params.h", LightParams, tilesY)                                             \
  X("low_confidence_params.h", LowConfidenceParams, cells)                             \
  X("material_guides_params.h", MaterialGuidesParams, images)                          \
  X("median_filter_params.h", MedianFilterParams, planes)                              \
  X("remodulate_params.h", RemodulateParams, tilesY)                                   \
  X("resample_history_params.h", ResampleHistoryParams, planeCount)                    \
  X("separable_bilateral_params.h", SeparableBilateralParams, alongRows)               \
  X("soft_history_params.h", SoftHistoryParams, trustsMotion)                          \
  X("sparse_bilateral_params.h", SparseBilateralParams, sine)                          \
  X("temporal_antialiasing_params.h", TemporalAntialiasingParams, antialiasBackground) \
  X("variance_params.h", VarianceParams, temporalFrames)                               \
  X("virtual_motion_params.h", VirtualMotionParams, parallel)                          \
  X("render/scene_params.h", RenderPrimitive, light)                                   \
  X("render/scene_params.h", RenderTexture, high)                                      \
  X("render/scene_params.h", RenderMaterial, bumpTexture)                              \
  X("render/scene_params.h", RenderLight, padding)                                     \
  X("render/scene_params.h", RenderSky, sunRadiance)                                   \
  X("render/scene_params.h", RenderBvhNode, count)                                     \
  X("render/scene_params.h", RenderCamera, clip)                                       \
  X("render/scene_params.h", RenderParams, padding)

// C++ and OpenCL C lay a struct out alike if it is one of C, has no alignment beyond that of a vector of four, and
// nothing but that alignment's padding behind the last member.
#define QUELL_ASSERT_LAYOUT(header, Struct, lastMember)                                                     \
  static_assert(                                                                                            \
      std::is_standard_layout_v<Struct> && std::is_trivially_copyable_v<Struct> && alignof(Struct) <= 16 && \
          sizeof(Struct) - offsetof(Struct, lastMember) - sizeof(Struct::lastMember) < alignof(Struct),     \
      #Struct " is laid out differently on devices");
QUELL_SHARED_STRUCTS(QUELL_ASSERT_LAYOUT)

struct SharedStruct {
  std::string header;
  std::string name;
  std::string lastMember;
  std::size_t size;
  std::size_t lastOffset;
};

std::vector<SharedStruct> sharedStructs() {
#define QUELL_ROW(header, Struct, lastMember) \
  {header, #Struct, #lastMember, sizeof(Struct), offsetof(Struct, lastMember)},
  return {QUELL_SHARED_STRUCTS(QUELL_ROW)};
}

// Names of all structs in the headers that kernels and host share.
std::set<std::string> structsInHeaders() {
  const std::regex definition("typedef struct (\\w+)");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(QUELL_KERNEL_DIR)) {
    const std::string file = entry.path().filename().string();
    if (file != "types.h" && file.find("_params.h") == std::string::npos) continue;
    std::ifstream stream(entry.path());
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    for (std::sregex_iterator match(text.begin(), text.end(), definition), end; match != end; ++match)
      names.insert((*match)[1]);
  }
  return names;
}

// A kernel of one work-item that stores size and offset of each struct.
std::string sizesKernel(const std::vector<SharedStruct>& structs) {
  std::ostringstream source;
  for (const SharedStruct& shared : structs) source << "#include \"" << shared.header << "\"\n";
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

TEST_CASE("every struct of the headers that kernels share is checked", "[core]") {
  std::set<std::string> checked;
  for (const SharedStruct& shared : sharedStructs()) checked.insert(shared.name);
  CHECK(checked == structsInHeaders());
}

TEST_CASE("shared structs have the same layout on device and host", "[core]") {
  const std::vector<SharedStruct> structs = sharedStructs();
  const OpenDevice device;
  cl::Program program(device.context, sizesKernel(structs));
  program.build({device.device}, "-cl-std=CL1.2 -I " QUELL_KERNEL_DIR " -I " QUELL_KERNEL_DIR "/../include");
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
