// Lookups in the F_beta table: between texels, at the ends of its axes, and with broken inputs.
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/common/types.h"
#include "tests/support/f_beta_texels.hpp"
#include "tests/support/random_images.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr char kProbe[] = R"(
#include "common/f_beta.h"
#include "common/planes.h"
__kernel void probe(__global const float4* table, __global const float* in, __global float* out, int count) {
  const int i = (int)get_global_id(0) * QUELL_LANES;
  const FBeta terms = lookUpFBeta(table, loadLanes(in + i), loadLanes(in + count + i));
  storeLanes(terms.scale, out + i);
  storeLanes(terms.bias, out + count + i);
}
__kernel void copy(__global const float4* table, __global const float* in, __global float* out, int count) {
  const int i = (int)get_global_id(0) * QUELL_LANES;
  storeLanes(loadLanes(in + i), out + i);
  storeLanes(loadLanes(in + count + i), out + count + i);
}
)";

struct Query {
  float cosTheta, roughness;
};

class Probe {
 public:
  Probe(Mapping mapping, Shadowing shadowing)
      : m_lanes(queryDeviceTraits(device().device, mapping).lanes), m_texels(mapping, shadowing) {
    m_program = ProgramCache("").build(
        device().context, device().device, queryDeviceTraits(device().device, mapping), "probe", kProbe,
        "-cl-std=CL1.2 -I " QUELL_KERNEL_DIR " -D QUELL_LANES=" + std::to_string(m_lanes));
  }

  const FBetaTexels& texels() const { return m_texels; }

  std::vector<FBetaTerms> lookUp(const std::vector<Query>& queries) {
    const std::vector<float> out = run("probe", queries, 1);
    std::vector<FBetaTerms> terms;
    for (std::size_t i = 0; i < queries.size(); ++i) terms.push_back({out[i], out[padded(queries) + i]});
    return terms;
  }

  // Least device time of `repeat` runs, ms.
  double milliseconds(const char* kernel, const std::vector<Query>& queries, int repeat) {
    run(kernel, queries, repeat);
    return m_leastMs;
  }

 private:
  static const TestDevice& device() { return TestDevice::shared(); }
  static std::size_t padded(const std::vector<Query>& queries) { return (queries.size() + 15) / 16 * 16; }

  std::vector<float> run(const char* name, const std::vector<Query>& queries, int repeat) {
    const std::size_t count = padded(queries), bytes = 2 * count * sizeof(float);
    std::vector<float> in(2 * count, 0.5f), out(2 * count);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      in[i] = queries[i].cosTheta;
      in[count + i] = queries[i].roughness;
    }
    const cl::Buffer inBuffer(device().context, CL_MEM_READ_ONLY, bytes);
    const cl::Buffer outBuffer(device().context, CL_MEM_READ_WRITE, bytes);
    device().queue.enqueueWriteBuffer(inBuffer, CL_TRUE, 0, bytes, in.data());
    cl::Kernel kernel(m_program, name);
    kernel.setArg(0, m_texels.buffer());
    kernel.setArg(1, inBuffer);
    kernel.setArg(2, outBuffer);
    kernel.setArg(3, static_cast<cl_int>(count));
    m_leastMs = std::numeric_limits<double>::infinity();
    for (int i = 0; i < repeat; ++i) {
      cl::Event done;
      device().queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count / std::size_t(m_lanes)),
                                          cl::NullRange, nullptr, &done);
      done.wait();
      const auto ns = done.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                      done.getProfilingInfo<CL_PROFILING_COMMAND_START>();
      m_leastMs = std::min(m_leastMs, double(ns) * 1e-6);
    }
    device().queue.enqueueReadBuffer(outBuffer, CL_TRUE, 0, bytes, out.data());
    return out;
  }

  int m_lanes;
  FBetaTexels m_texels;
  cl::Program m_program;
  double m_leastMs = 0.0;
};

constexpr Mapping kMappings[] = {Mapping::Wide, Mapping::Narrow};
constexpr Shadowing kShadowings[] = {Shadowing::Separable, Shadowing::HeightCorrelated};

struct LookupErrors {
  double usual = 0.0;    // cosTheta >= kUsualFrom
  double grazing = 0.0;  // below
  double mean = 0.0;
};

constexpr double kUsualFrom = 0.02;  // less than 1.2 degrees from grazing

LookupErrors lookupErrors(Mapping mapping, Shadowing shadowing) {
  Random random(11);
  std::vector<Query> queries;
  // More of them where F_beta changes fast: grazing angles, low roughness.
  for (int i = 0; i < 3000; ++i)
    queries.push_back({float(std::pow(random.uniform(), i % 2 == 0 ? 1.0 : 4.0)),
                       float(random.uniform() * (i % 3 == 0 ? 0.15 : 1.0))});
  const std::vector<FBetaTerms> found = Probe(mapping, shadowing).lookUp(queries);
  LookupErrors errors;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double cosTheta = queries[i].cosTheta;
    const double error = largestDifference(found[i], exactFBeta(cosTheta, queries[i].roughness, shadowing));
    double& largest = cosTheta >= kUsualFrom ? errors.usual : errors.grazing;
    largest = std::max(largest, error);
    errors.mean += error / double(queries.size());
  }
  return errors;
}

}  // namespace

TEST_CASE("a lookup at a texel gives the texel") {
  for (const Mapping mapping : kMappings) {
    Probe probe(mapping, Shadowing::Separable);
    std::vector<Query> queries;
    for (int y = 0; y < kFBetaEdge; y += 3)
      for (int x = 0; x < kFBetaEdge; x += 3)
        queries.push_back({float(texelCosTheta(x)), float(texelRoughness(y))});
    const std::vector<FBetaTerms> found = probe.lookUp(queries);
    double largest = 0.0;
    std::size_t i = 0;
    for (int y = 0; y < kFBetaEdge; y += 3)
      for (int x = 0; x < kFBetaEdge; x += 3)
        largest = std::max(largest, largestDifference(found[i++], probe.texels().at(x, y)));
    CHECK(largest < 2e-5);  // coordinates are rounded to 1e-5 texels
  }
}

TEST_CASE("a lookup between texels is close to the integral") {
  for (const Shadowing shadowing : kShadowings) {
    const LookupErrors wide = lookupErrors(Mapping::Wide, shadowing);
    const LookupErrors narrow = lookupErrors(Mapping::Narrow, shadowing);
    WARN("bilinear lookup, " << (shadowing == Shadowing::Separable ? "separable" : "height-correlated")
                             << ": largest error " << wide.usual << " for cos(theta) >= " << kUsualFrom
                             << ", " << wide.grazing << " below, mean " << wide.mean);
    CHECK(wide.usual < 3e-4);
    CHECK(wide.grazing < 0.04);
    CHECK(narrow.usual == Approx(wide.usual).margin(1e-5));
    CHECK(narrow.grazing == Approx(wide.grazing).margin(1e-5));
  }
}

TEST_CASE("a lookup clamps its arguments, and NaN gives finite values") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<std::pair<Query, Query>> sameAs = {
      {{-1.0f, 0.5f}, {0.0f, 0.5f}},  {{-0.0f, 0.5f}, {0.0f, 0.5f}}, {{1.5f, 0.5f}, {1.0f, 0.5f}},
      {{inf, 0.5f}, {1.0f, 0.5f}},    {{-inf, 0.5f}, {0.0f, 0.5f}},  {{nan, 0.5f}, {0.0f, 0.5f}},
      {{0.5f, -1.0f}, {0.5f, 0.0f}},  {{0.5f, 2.0f}, {0.5f, 1.0f}},  {{0.5f, inf}, {0.5f, 1.0f}},
      {{0.5f, -inf}, {0.5f, 0.0f}},   {{0.5f, nan}, {0.5f, 1.0f}},   {{nan, nan}, {0.0f, 1.0f}},
      {{3e38f, 1e-42f}, {1.0f, 0.0f}}};
  for (const Mapping mapping : kMappings) {
    Probe probe(mapping, Shadowing::HeightCorrelated);
    std::vector<Query> broken, clamped;
    for (const auto& [a, b] : sameAs) {
      broken.push_back(a);
      clamped.push_back(b);
    }
    const std::vector<FBetaTerms> found = probe.lookUp(broken), expected = probe.lookUp(clamped);
    for (std::size_t i = 0; i < found.size(); ++i) {
      INFO("cos(theta) " << broken[i].cosTheta << ", roughness " << broken[i].roughness);
      CHECK(largestDifference(found[i], expected[i]) < 1e-7);
    }
  }
}

// Not a test: prints times. Run by name, with one thread for figures per thread.
TEST_CASE("time of a lookup", "[.]") {
  constexpr int kWidth = 1280, kHeight = 720, kRepeat = 50;
  Random random(3);
  std::vector<Query> smooth, textured, scattered;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float across = float(x) / kWidth, down = float(y) / kHeight;
      smooth.push_back({0.2f + 0.7f * across, 0.1f + 0.8f * down});
      textured.push_back({0.2f + 0.7f * across, float(random.uniform(0.2, 0.6))});
      scattered.push_back({float(random.uniform()), float(random.uniform())});
    }
  }
  for (const Mapping mapping : kMappings) {
    Probe probe(mapping, Shadowing::Separable);
    const double copy = probe.milliseconds("copy", smooth, kRepeat);
    for (const auto& [name, queries] : {std::pair("smooth", &smooth), std::pair("rough texture", &textured),
                                        std::pair("scattered", &scattered)}) {
      const double ms = probe.milliseconds("probe", *queries, kRepeat);
      WARN((mapping == Mapping::Wide ? "16 lanes, " : "1 lane, ")
           << name << ": " << ms << " ms, " << ms - copy << " above a copy, "
           << (ms - copy) * 1e6 / (kWidth * kHeight) << " ns a pixel");
    }
  }
}
