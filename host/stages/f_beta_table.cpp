#include "host/stages/f_beta_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "host/core/cl_error.hpp"
#include "host/core/kernel_sources.hpp"
#include "kernels/f_beta_table_params.h"

namespace quell {
namespace {

using Bytes = DiskCache::Bytes;

constexpr char kStem[] = "f_beta_table";
constexpr std::size_t kEdge = QUELL_F_BETA_EDGE;
constexpr std::size_t kTableFloats = kEdge * kEdge * QUELL_F_BETA_ENTRY;
constexpr std::size_t kTableBytes = kTableFloats * sizeof(float);

// Work-groups of texels; a row on GPUs, single items on CPUs, where each is long enough to be shared out alone.
constexpr std::size_t kGpuWorkGroup = 64;
constexpr std::size_t kCpuWorkGroup = 1;

/// The Fibonacci lattice on the unit square, (u, v) -> (t = u^2, phi = 2 pi v), with the weights of the quadratic
/// steps, which add up to 1.
std::vector<QuellFloat4> makeSamples() {
  constexpr int kCount = QUELL_F_BETA_SAMPLES;
  constexpr double kTwoPi = 6.283185307179586;
  std::vector<QuellFloat4> samples;
  for (int i = 0; i < kCount; ++i) {
    const double u = (i + 0.5) / kCount;
    const int step = static_cast<int>(std::int64_t{i} * QUELL_F_BETA_GENERATOR % kCount);
    const double phi = kTwoPi * (step + 0.5) / kCount;
    const double cosPhi = std::cos(phi);
    samples.push_back({static_cast<float>(u * u), static_cast<float>(cosPhi),
                       static_cast<float>(1.0 - cosPhi * cosPhi), static_cast<float>(2.0 * u / kCount)});
  }
  return samples;
}

std::string buildOptions(const DeviceTraits& traits, Shadowing shadowing) {
  return "-cl-std=CL1.2 -D QUELL_LANES=" + std::to_string(traits.lanes) +
         " -D F_BETA_CORRELATED=" + (shadowing == Shadowing::HeightCorrelated ? "1" : "0");
}

// Waits on every command by itself, so that in-order and out-of-order queues both do.
void computeTable(const cl::Context& context, const cl::CommandQueue& queue, const DeviceTraits& traits,
                  const cl::Program& program, const cl::Buffer& table) {
  const std::vector<QuellFloat4> samples = makeSamples();
  const std::size_t bytes = samples.size() * sizeof(QuellFloat4);
  const cl::Buffer sampleBuffer(context, CL_MEM_READ_ONLY, bytes);
  queue.enqueueWriteBuffer(sampleBuffer, CL_TRUE, 0, bytes, samples.data());
  cl::Kernel kernel(program, kStem);
  kernel.setArg(0, sampleBuffer);
  kernel.setArg(1, table);
  const std::size_t columns = kEdge / static_cast<std::size_t>(traits.lanes);
  const std::size_t group = std::min(traits.isCpu ? kCpuWorkGroup : kGpuWorkGroup, columns);
  cl::Event done;
  queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(columns, kEdge), cl::NDRange(group, 1),
                             nullptr, &done);
  done.wait();
}

Bytes download(const cl::CommandQueue& queue, const cl::Buffer& table) {
  Bytes bytes(kTableBytes);
  queue.enqueueReadBuffer(table, CL_TRUE, 0, bytes.size(), bytes.data());
  return bytes;
}

}  // namespace

FBetaTable::FBetaTable(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
                       const DeviceTraits& traits, const ProgramCache& programs, Shadowing shadowing) {
  withClErrors(kStem, [&] {
    const std::string& source = kernelSources().at(kStem);
    const std::string options = buildOptions(traits, shadowing);
    const std::string key = std::string(kStem) + "\n" + traits.identity + "\n" + options + "\n" + source;
    m_buffer = cl::Buffer(context, CL_MEM_READ_WRITE, kTableBytes);
    if (const auto kept = programs.disk().read(key); kept && kept->size() == kTableBytes) {
      queue.enqueueWriteBuffer(m_buffer, CL_TRUE, 0, kept->size(), kept->data());
      m_fromDisk = true;
      return;
    }
    computeTable(context, queue, traits, programs.build(context, device, traits, kStem, source, options),
                 m_buffer);
    programs.disk().write(key, download(queue, m_buffer));
  });
}

std::vector<float> FBetaTable::texels(const cl::CommandQueue& queue) const {
  return withClErrors(kStem, [&] {
    const Bytes bytes = download(queue, m_buffer);
    std::vector<float> texels(2 * kEdge * kEdge);
    for (std::size_t i = 0; i < kEdge * kEdge; ++i)
      std::memcpy(&texels[2 * i], &bytes[i * QUELL_F_BETA_ENTRY * sizeof(float)], 2 * sizeof(float));
    return texels;
  });
}

int FBetaTable::edge() { return QUELL_F_BETA_EDGE; }

}  // namespace quell
