// Runs what the kernels do with the F_beta table by itself.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kernels/common/types.h"
#include "tests/support/f_beta_texels.hpp"

namespace quell::tests {

inline constexpr char kProbe[] = R"(
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
  const float3L divisor = divisorOf(factor);
  const float3L back = multiply3(divisor, divideBy(signal, divisor));
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

constexpr Mapping kProbedMappings[] = {Mapping::Wide, Mapping::Narrow};
constexpr Shadowing kShadowings[] = {Shadowing::Separable, Shadowing::HeightCorrelated};

constexpr double kUsualFrom = 0.02;  // less than 1.2 degrees from grazing

}  // namespace quell::tests
