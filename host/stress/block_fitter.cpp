#include "host/stress/block_fitter.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <quell/devices.hpp>
#include <tuple>

#include "host/core/buffer_reader.hpp"
#include "host/core/cl_error.hpp"
#include "host/core/pipeline.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/gram_solve.hpp"
#include "host/stages/gram_sums.hpp"
#include "host/stages/weighted_sum.hpp"
#include "host/stress/batch_data.hpp"

namespace quell::stress {
namespace {

constexpr char kStageName[] = "stress";

using Images = std::array<std::pair<ImageView Frame::*, std::array<Vector3, kBlockPixels> Block::*>, 3>;
constexpr Images kImages = {{{&Frame::radiance, &Block::radiance},
                             {&Frame::normalWorld, &Block::normalWorld},
                             {&Frame::positionWorld, &Block::positionRelative}}};

// Every block is a block of the grid: nothing is displaced.
FitParams align(FitParams params, const Size& size) {
  params.blockOffsetX = params.blockOffsetY = 0;
  params.blocksX = 1;
  params.blocksY = size.height / kBlockEdge;
  return params;
}

/// The stages on that grid. `seed` outlives them.
class AlignedFit : public Fit {
 public:
  AlignedFit(const Configuration& configuration, double noiseAmplitude, const std::uint32_t& seed)
      : Fit(configuration, FitFeatures(), {noiseAmplitude, FeatureStorage::Float, 0, false}), m_seed(&seed) {}

 protected:
  FitParams params(const FrameRun& run) const override {
    FitParams params = align(Fit::params(run), run.frame.size);
    params.noiseSeed = *m_seed;
    return params;
  }

 private:
  const std::uint32_t* m_seed;
};

class AlignedWeightedSum : public WeightedSum {
 public:
  explicit AlignedWeightedSum(const Configuration& configuration)
      : WeightedSum(configuration, FitFeatures(), 0, false) {}

 protected:
  FitParams params(const FrameRun& run) const override {
    return align(WeightedSum::params(run), run.frame.size);
  }
};

GramParams align(GramParams params, const Size& size) {
  params.tileOffsetX = params.tileOffsetY = 0;
  params.tilesX = 1;
  params.tilesY = params.tileStride = size.height / kBlockEdge;
  return params;
}

class AlignedGramSums : public GramSums {
 public:
  explicit AlignedGramSums(const Configuration& configuration)
      : GramSums(configuration, {}, FitFeatures(), 0, false, false) {}

 protected:
  GramParams params(const FrameRun& run) const override {
    return align(GramSums::params(run), run.frame.size);
  }
};

class AlignedGramSolve : public GramSolve {
 public:
  AlignedGramSolve(const Configuration& configuration, double noiseAmplitude)
      : GramSolve(configuration, {}, noiseAmplitude, FitFeatures()) {}

 protected:
  GramParams params(const FrameRun& run) const override {
    return align(GramSolve::params(run), run.frame.size);
  }
};

Schedule makeSchedule(const Configuration& configuration, Solver solver, double noiseAmplitude,
                      const std::uint32_t& seed) {
  Schedule table;
  AccumulateNoisy::Setup accumulation;
  accumulation.leastWeight = 1.0;
  add(table, AccumulateNoisy(configuration, accumulation));
  if (solver == Solver::Gram) {
    add(table, AlignedGramSums(configuration));
    add(table, AlignedGramSolve(configuration, noiseAmplitude));
  } else {
    add(table, AlignedFit(configuration, noiseAmplitude, seed));
  }
  add(table, AlignedWeightedSum(configuration));
  return table;
}

}  // namespace

std::string solverName(Solver solver) { return solver == Solver::Gram ? "gram" : "householder"; }

class BlockFitter::Implementation {
 public:
  Implementation(const DeviceInfo& info, const FitterOptions& options)
      : m_device(info.device, true),
        m_context(m_device),
        m_queue(m_context, m_device),
        m_name(info.name),
        m_noiseAmplitude(options.noiseAmplitude),
        m_cache(options.options.cacheDirectory ? *options.options.cacheDirectory : defaultCacheDirectory()) {
    m_configuration.device = queryDeviceTraits(m_device, options.options.mapping);
    m_configuration.options = options.options;
    m_configuration.options.keptBuffers = {"irradiance", "guides", "fitRecords", "fitted"};
  }

  BatchFit fit(const Batch& batch, std::uint32_t noiseSeed) {
    const Frame frame = upload(batch);
    m_noiseSeed = noiseSeed;
    BatchFit result;
    result.inputs.resize(batch.blocks.size());
    for (const Solver solver : kSolvers) {
      const Pipeline& pipeline = run(solver, frame, makeReprojection(batch));
      if (solver == kSolvers[0]) downloadInputs(pipeline, result.inputs);
      (solver == Solver::Gram ? result.gram : result.householder) =
          downloadFits(pipeline, batch.blocks.size());
    }
    return result;
  }

  const std::string& name() const { return m_name; }

 private:
  /// Runs all stages and waits.
  const Pipeline& run(Solver solver, const Frame& frame, const ReprojectionParams& reprojection) {
    const Key key{solver, frame.size.height, frame.radiance.format};
    const auto found = m_pipelines.find(key);
    if (found == m_pipelines.end()) {
      m_configuration.frame = frame;
      const auto schedule = [&](const Configuration& configuration) {
        return makeSchedule(configuration, solver, m_noiseAmplitude, m_noiseSeed);
      };
      m_pipelines.emplace(key, Pipeline(m_context, m_device, m_queue, m_cache, m_configuration, schedule));
    }
    const Pipeline& pipeline = m_pipelines.at(key);
    FrameCommands commands(m_queue, {}, false, false);
    pipeline.record(commands, frame, {}, reprojection, 0);
    m_queue.finish();
    return pipeline;
  }

  template <class Value>
  void uploadImage(ImageView& view, const std::vector<Value>& values) {
    m_images.emplace_back(m_context, CL_MEM_READ_ONLY, values.size() * sizeof(Value));
    m_queue.enqueueWriteBuffer(m_images.back(), CL_TRUE, 0, values.size() * sizeof(Value), values.data());
    view.memory = m_images.back()();
  }

  Frame upload(const Batch& batch) {
    m_images.clear();
    Frame frame;
    frame.size = imageSize(batch.blocks.size());
    for (const auto& [image, values] : kImages) {
      ImageView& view = frame.*image;
      view = packedImage(nullptr, 3, batch.halfInputs ? ComponentFormat::Float16 : ComponentFormat::Float32);
      if (batch.halfInputs) uploadImage(view, packImage<Eigen::half>(batch, values));
      if (!batch.halfInputs) uploadImage(view, packImage<float>(batch, values));
    }
    return frame;
  }

  BufferContent download(const Pipeline& pipeline, const char* name) {
    const int index = pipeline.plan().find(name);
    return readBufferContent(m_queue, pipeline.buffers().current(index, 0),
                             pipeline.plan().buffers[static_cast<std::size_t>(index)],
                             pipeline.configuration().size());
  }

  /// Predictions of every pixel, and the records that they come from.
  std::vector<BlockFit> downloadFits(const Pipeline& pipeline, std::size_t blocks) {
    std::vector<BlockFit> fits(blocks);
    const BufferContent records = download(pipeline, "fitRecords");
    const BufferContent fitted = download(pipeline, "fitted");
    for (std::size_t block = 0; block < blocks; ++block) {
      std::copy_n(records.values.begin() + static_cast<std::ptrdiff_t>(block * QUELL_FIT_RECORD),
                  QUELL_FIT_RECORD, fits[block].record.begin());
      takePixels(fitted, block, fits[block].fitted);
    }
    return fits;
  }

  void downloadInputs(const Pipeline& pipeline, std::vector<BlockInputs>& inputs) {
    const BufferContent irradiance = download(pipeline, "irradiance");
    const BufferContent guides = download(pipeline, "guides");
    for (std::size_t block = 0; block < inputs.size(); ++block) {
      takePixels(irradiance, block, inputs[block].irradiance);
      takePixels(guides, block, inputs[block].guides);
    }
  }

  /// The values of one block, pixel by pixel. Blocks lie one below the other: their pixels follow each other.
  template <std::size_t Planes>
  static void takePixels(const BufferContent& content, std::size_t block,
                         std::array<std::array<float, Planes>, kBlockPixels>& pixels) {
    const std::size_t planePixels = content.values.size() / static_cast<std::size_t>(content.planes);
    for (std::size_t pixel = 0; pixel < kBlockPixels; ++pixel)
      for (std::size_t plane = 0; plane < Planes; ++plane)
        pixels[pixel][plane] = content.values[plane * planePixels + block * kBlockPixels + pixel];
  }

  using Key = std::tuple<Solver, int, ComponentFormat>;

  cl::Device m_device;
  cl::Context m_context;
  cl::CommandQueue m_queue;
  std::string m_name;
  double m_noiseAmplitude;
  std::uint32_t m_noiseSeed = 0;
  ProgramCache m_cache;
  Configuration m_configuration;
  std::map<Key, Pipeline> m_pipelines;  // of all sizes and formats so far
  std::vector<cl::Buffer> m_images;
};

BlockFitter::BlockFitter(const FitterOptions& options) {
  const DeviceInfo info = chooseDevice(options.device);
  m_implementation =
      withClErrors(kStageName, [&] { return std::make_unique<Implementation>(info, options); });
}
BlockFitter::~BlockFitter() = default;

BatchFit BlockFitter::fit(const Batch& batch, std::uint32_t noiseSeed) {
  return withClErrors(kStageName, [&] { return m_implementation->fit(batch, noiseSeed); });
}

const std::string& BlockFitter::deviceName() const { return m_implementation->name(); }

}  // namespace quell::stress
