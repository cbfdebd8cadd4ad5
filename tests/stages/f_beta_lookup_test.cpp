// Lookups in the F_beta table: between texels, at the ends of its axes, and with broken inputs.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernels/common/types.h"
#include "tests/support/f_beta_texels.hpp"
#include "tests/support/random_images.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr char kProbe[] = R"(
#include "common/demodulation.h"
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
// In: position, normal, F0, gloss colour, signal (3 planes each), roughness. Out: F_beta, then the signal divided by
// gloss colour times F_beta and multiplied again.
__kernel void surface(__global const float4* table, __global const float* in, __global float* out, int count) {
  const int i = (int)get_global_id(0) * QUELL_LANES;
  const float3L fBeta =
      surfaceFBeta3(table, loadLanes3(in, i, count), loadLanes3(in + 3 * count, i, count),
                    loadLanes(in + 15 * count + i), loadLanes3(in + 6 * count, i, count));
  const float3L factor = cleanFactor3(multiply3(loadLanes3(in + 9 * count, i, count), fBeta));
  const float3L signal = loadLanes3(in + 12 * count, i, count);
  floatL weight;
  const float3L irradiance = divideSignal(signal, factor, &weight);
  const float3L share = filteredShare3(factor);
  const float3L back = add3(multiply3(share, multiply3(factor, irradiance)),
                            multiply3(subtract3(splat3(1.0f), share), signal));
  storeLanes3(fBeta, out, i, count);
  storeLanes3(back, out + 3 * count, i, count);
}
)";

struct Query {
  float cosTheta, roughness;
};

class Probe {
 public:
  Probe(Mapping mapping, Shadowing shadowing)
      : m_lanes(queryDeviceTraits(device().device, mapping).lanes),
        m_texels(sharedFBetaTexels(Mapping::Wide, shadowing)) {
    m_program = ProgramCache("").build(
        device().context, device().device, queryDeviceTraits(device().device, mapping), "probe", kProbe,
        "-cl-std=CL1.2 -I " QUELL_KERNEL_DIR " -D QUELL_LANES=" + std::to_string(m_lanes));
  }

  const FBetaTexels& texels() const { return m_texels; }

  std::vector<FBetaTerms> lookUp(const std::vector<Query>& queries) {
    const std::vector<float> out = run("probe", planesOf(queries), 2, 2);
    const std::size_t stride = out.size() / 2;
    std::vector<FBetaTerms> terms;
    for (std::size_t i = 0; i < queries.size(); ++i) terms.push_back({out[i], out[stride + i]});
    return terms;
  }

  // Least device time of `repeat` runs, ms.
  double milliseconds(const char* kernel, const std::vector<Query>& queries, int repeat) {
    run(kernel, planesOf(queries), 2, 2, repeat);
    return m_leastMs;
  }

  // `in` holds `inPlanes` planes, each a multiple of 16 floats; so does the result with `outPlanes`.
  std::vector<float> run(const char* name, const std::vector<float>& in, std::size_t inPlanes,
                         std::size_t outPlanes, int repeat = 1) {
    const std::size_t count = in.size() / inPlanes;
    std::vector<float> out(outPlanes * count);
    const cl::Buffer inBuffer(device().context, CL_MEM_READ_ONLY, in.size() * sizeof(float));
    const cl::Buffer outBuffer(device().context, CL_MEM_READ_WRITE, out.size() * sizeof(float));
    device().queue.enqueueWriteBuffer(inBuffer, CL_TRUE, 0, in.size() * sizeof(float), in.data());
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
    device().queue.enqueueReadBuffer(outBuffer, CL_TRUE, 0, out.size() * sizeof(float), out.data());
    return out;
  }

 private:
  static const TestDevice& device() { return TestDevice::shared(); }

  static std::vector<float> planesOf(const std::vector<Query>& queries) {
    const std::size_t stride = (queries.size() + 15) / 16 * 16;
    std::vector<float> planes(2 * stride, 0.5f);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      planes[i] = queries[i].cosTheta;
      planes[stride + i] = queries[i].roughness;
    }
    return planes;
  }

  int m_lanes;
  const FBetaTexels& m_texels;
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

std::vector<Query> randomQueries() {
  Random random(11);
  std::vector<Query> queries;
  // More of them where F_beta changes fast: grazing angles, low roughness.
  for (int i = 0; i < 3000; ++i)
    queries.push_back({float(std::pow(random.uniform(), i % 2 == 0 ? 1.0 : 4.0)),
                       float(random.uniform() * (i % 3 == 0 ? 0.15 : 1.0))});
  return queries;
}

LookupErrors lookupErrors(const std::vector<Query>& queries, const std::vector<FBetaTerms>& found,
                          Shadowing shadowing) {
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
    const std::vector<Query> queries = randomQueries();
    const std::vector<FBetaTerms> found = Probe(Mapping::Wide, shadowing).lookUp(queries);
    const std::vector<FBetaTerms> narrow = Probe(Mapping::Narrow, shadowing).lookUp(queries);
    const LookupErrors wide = lookupErrors(queries, found, shadowing);
    double betweenMappings = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i)
      betweenMappings = std::max(betweenMappings, largestDifference(found[i], narrow[i]));
    WARN("bilinear lookup, " << (shadowing == Shadowing::Separable ? "separable" : "height-correlated")
                             << ": largest error " << wide.usual << " for cos(theta) >= " << kUsualFrom
                             << ", " << wide.grazing << " below, mean " << wide.mean);
    CHECK(wide.usual < 3e-4);
    CHECK(wide.grazing < 0.04);
    CHECK(betweenMappings < 1e-5);
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

namespace {

constexpr std::size_t kSurfaces = 1024, kSurfacePlanes = 16, kResultPlanes = 6;

Eigen::Vector3d randomDirection(Random& random) {
  Eigen::Vector3d direction;
  do direction = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  while (direction.norm() > 1.0 || direction.norm() < 0.1);
  return direction.normalized();
}

// Planes of the kernel `surface`: camera-relative positions of any size, unit normals, F0 and gloss colour in [0, 1],
// signals up to 316, so that no irradiance behind a factor of 0.01 or more is clamped.
std::vector<float> randomSurfaces() {
  Random random(21);
  std::vector<float> planes(kSurfaces * kSurfacePlanes);
  const auto at = [&](std::size_t plane, std::size_t i) -> float& { return planes[plane * kSurfaces + i]; };
  for (std::size_t i = 0; i < kSurfaces; ++i) {
    const double distance = std::pow(10.0, random.uniform(-6.0, 15.0));
    const Eigen::Vector3d normal = randomDirection(random), position = distance * randomDirection(random);
    for (std::size_t c = 0; c < 3; ++c) {
      at(c, i) = float(position[Eigen::Index(c)]);
      at(3 + c, i) = float(normal[Eigen::Index(c)]);
      at(6 + c, i) = float(random.uniform());
      at(9 + c, i) = float(random.uniform());
      at(12 + c, i) = float(std::pow(10.0, random.uniform(-3.0, 2.5)));
    }
    at(15, i) = float(random.uniform());
  }
  return planes;
}

Eigen::Vector3d vectorAt(const std::vector<float>& planes, std::size_t plane, std::size_t i) {
  return {planes[plane * kSurfaces + i], planes[(plane + 1) * kSurfaces + i],
          planes[(plane + 2) * kSurfaces + i]};
}

}  // namespace

TEST_CASE("F_beta of a surface follows from position, normal, roughness and F0") {
  const std::vector<float> in = randomSurfaces();
  for (const Mapping mapping : kMappings) {
    const std::vector<float> out =
        Probe(mapping, Shadowing::Separable).run("surface", in, kSurfacePlanes, kResultPlanes);
    double largest = 0.0;
    for (std::size_t i = 0; i < kSurfaces; ++i) {
      const double cosTheta = absCosine(vectorAt(in, 0, i), vectorAt(in, 3, i));
      const FBetaTerms exact = exactFBeta(cosTheta, in[15 * kSurfaces + i], Shadowing::Separable);
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = out[c * kSurfaces + i];
        REQUIRE(std::isfinite(value));
        const double error = std::abs(value - exact.scale * in[(6 + c) * kSurfaces + i] - exact.bias);
        if (cosTheta >= kUsualFrom) largest = std::max(largest, error);
      }
    }
    INFO("largest error " << largest);
    CHECK(largest < 4e-4);  // those of scale and bias may add up
  }
}

TEST_CASE(
    "a signal divided by gloss colour times F_beta and multiplied again is the same to half precision") {
  constexpr double kHalfUlp = 1.0 / 2048;  // of half precision, relative
  constexpr double kFullFactor = 0.01;     // channels with less are blended with the unfiltered signal
  const std::vector<float> in = randomSurfaces();
  for (const Mapping mapping : kMappings) {
    const std::vector<float> out =
        Probe(mapping, Shadowing::HeightCorrelated).run("surface", in, kSurfacePlanes, kResultPlanes);
    double largest = 0.0;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < kSurfaces; ++i) {
      const Eigen::Vector3d factor = vectorAt(out, 0, i).cwiseProduct(vectorAt(in, 9, i));
      if (factor.minCoeff() < kFullFactor) continue;
      const Eigen::Vector3d signal = vectorAt(in, 12, i), back = vectorAt(out, 3, i);
      largest = std::max(largest, ((back - signal).cwiseQuotient(signal)).cwiseAbs().maxCoeff());
      ++compared;
    }
    INFO("largest relative change " << largest << " in " << compared << " pixels");
    CHECK(compared > kSurfaces / 2);
    CHECK(largest <= kHalfUlp);
  }
}

TEST_CASE("F_beta of a broken surface is finite") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  std::vector<float> in = randomSurfaces();
  Random random(22);
  for (const std::size_t plane : {0, 1, 2, 3, 4, 5, 15})
    for (std::size_t i = 0; i < kSurfaces; ++i)
      if (const int what = random.integer(0, 15); what < 5)
        in[plane * kSurfaces + i] = std::array<float, 5>{nan, inf, -inf, 0.0f, 3e38f}[std::size_t(what)];
  for (std::size_t i = 0; i < kSurfaces; i += 7)  // positions at the camera, normals of the background
    for (std::size_t plane = 0; plane < 6; ++plane) in[plane * kSurfaces + i] = 0.0f;
  for (const Mapping mapping : kMappings) {
    const std::vector<float> out =
        Probe(mapping, Shadowing::Separable).run("surface", in, kSurfacePlanes, kResultPlanes);
    for (std::size_t i = 0; i < 3 * kSurfaces; ++i) {
      REQUIRE(out[i] >= 0.0f);
      REQUIRE(out[i] <= 1.0f + 1e-5f);
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
