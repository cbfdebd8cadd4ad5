#include "host/stress/block_fitter.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <quell/devices.hpp>

#include "host/core/cl_error.hpp"
#include "host/core/program_cache.hpp"
#include "host/core/round_up.hpp"
#include "host/core/stage.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stress/batch_data.hpp"

namespace quell::stress {
namespace {

// Work-items that share a block, or a tile, on GPUs; as the stages fit and gram_sums have it.
constexpr std::size_t kFitGroup = 256;
constexpr std::size_t kLeastFitGroup = QUELL_MOST_FEATURES;  // one lane for each pivot
constexpr std::size_t kGramGroup = 128;
constexpr char kStageName[] = "stress";

using Images = std::array<std::pair<ImageView Frame::*, std::array<Vector3, kBlockPixels> Block::*>, 3>;
constexpr Images kImages = {{{&Frame::radiance, &Block::radiance},
                             {&Frame::normalWorld, &Block::normalWorld},
                             {&Frame::positionWorld, &Block::positionRelative}}};

class StressRun : public FrameRun {
 public:
  StressRun(const Configuration& c, const Frame& f, const ReprojectionParams& r,
            const cl::CommandQueue& queue, const std::map<std::string, cl::Buffer>& buffers)
      : FrameRun(c, f, c.output, r, 0), m_queue(queue), m_buffers(buffers) {}

  const cl::Buffer& buffer(const std::string& name) const override { return m_buffers.at(name); }

 protected:
  void enqueue(const cl::Kernel& kernel, std::array<std::size_t, 2> global,
               const cl::NDRange& local) override {
    const cl::NDRange range(roundUp<std::size_t>(global[0], local[0]),
                            roundUp<std::size_t>(global[1], local[1]));
    m_queue.enqueueNDRangeKernel(kernel, cl::NullRange, range, local);
  }

 private:
  cl::CommandQueue m_queue;
  const std::map<std::string, cl::Buffer>& m_buffers;
};

/// A kernel and the number of work-items that share a block.
struct SharedKernel {
  cl::Kernel kernel;
  std::size_t group = 1;
};

/// The largest group up to `wish` that the device takes.
SharedKernel buildShared(const KernelBuilder& builder, const std::string& stem, std::size_t wish,
                         const std::string& groupName, const std::string& options) {
  for (std::size_t group = std::min(wish, builder.configuration().device.maxWorkGroup);; group /= 2) {
    SharedKernel shared{builder.build(stem, options + " -D " + groupName + "=" + std::to_string(group)),
                        group};
    if (group == 1 || builder.maxWorkGroup(shared.kernel) >= group) return shared;
  }
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
        m_noiseAmplitude(options.noiseAmplitude) {
    const ProgramCache cache(options.options.cacheDirectory ? *options.options.cacheDirectory
                                                            : defaultCacheDirectory());
    m_configuration.device = queryDeviceTraits(m_device, options.options.mapping);
    m_configuration.options = options.options;
    const DeviceKernelBuilder builder(m_context, m_device, cache, m_configuration);
    buildSolvers(builder);
    for (const auto format : {ComponentFormat::Float32, ComponentFormat::Float16}) {
      for (const auto& [image, values] : kImages)
        m_configuration.frame.*image = packedImage(nullptr, 3, format);
      accumulator(format).build(builder);
    }
  }

  BatchFit fit(const Batch& batch, std::uint32_t noiseSeed) {
    allocate(batch.blocks.size());
    Frame frame = upload(batch);
    m_configuration.frame = frame;
    const ReprojectionParams reprojection = makeReprojection(batch);
    StressRun run(m_configuration, frame, reprojection, m_queue, m_buffers);
    accumulator(frame.radiance.format).enqueue(run);

    BatchFit result;
    result.inputs.resize(batch.blocks.size());
    downloadInputs(result.inputs);
    enqueueHouseholder(run, noiseSeed);
    result.householder = synthesize(run);
    enqueueGram(run);
    result.gram = synthesize(run);
    return result;
  }

  const std::string& name() const { return m_name; }

 private:
  AccumulateNoisy& accumulator(ComponentFormat format) {
    return format == ComponentFormat::Float16 ? m_accumulateHalf : m_accumulateFloat;
  }

  void buildSolvers(const KernelBuilder& builder) {
    const bool wide = m_configuration.device.lanes > 1;
    const int wish = m_configuration.options.fitGroup;
    const std::size_t group = wish > 0 ? static_cast<std::size_t>(wish) : wide ? 1 : kFitGroup;
    const std::string unroll = m_configuration.device.isCpu ? "0" : "1";
    const std::size_t leastGroup = wide ? 1 : kLeastFitGroup;
    m_fit = buildShared(builder, "fit",
                        std::max(leastGroup, std::min(group, kFitGroup / static_cast<std::size_t>(lanes()))),
                        "FIT_GROUP_SIZE", "-D FIT_STORAGE_HALF=0 -D FIT_UNROLL=" + unroll);
    m_gramSums = buildShared(builder, "gram_sums", wide ? 1 : kGramGroup, "GRAM_GROUP_SIZE",
                             "-D GRAM_TILE_EDGE=" + std::to_string(kBlockEdge) + " -D GRAM_MIRROR=1");
    m_gramSolve = builder.build("gram_solve", "-D GRAM_OVERLAP=0");
    m_weightedSum = builder.build("weighted_sum", "");
  }

  int lanes() const { return m_configuration.device.lanes; }

  /// Buffers for this many blocks; kept as long as the number stays the same.
  void allocate(std::size_t blocks) {
    if (blocks == m_blocks) return;
    const auto planeElements = static_cast<std::size_t>(makePlanes(imageSize(blocks)).stride);
    const std::map<std::string, std::size_t> elements = {{"irradiance", 3 * planeElements},
                                                         {"irradiance.prev", 3 * planeElements},
                                                         {"historyLength", planeElements},
                                                         {"historyLength.prev", planeElements},
                                                         {"guides", QUELL_GUIDE_PLANES * planeElements},
                                                         {"guides.prev", QUELL_GUIDE_PLANES * planeElements},
                                                         {"pixelPrev", 2 * planeElements},
                                                         {"reprojectionMask", planeElements},
                                                         {"fitted", 3 * planeElements},
                                                         {"fitRecords", blocks * QUELL_FIT_RECORD},
                                                         {"gramTiles", blocks * QUELL_GRAM_PLANES},
                                                         {"fitStorage", 1}};
    for (const auto& [name, count] : elements) {
      m_buffers[name] = cl::Buffer(m_context, CL_MEM_READ_WRITE, count * sizeof(float));
      m_queue.enqueueFillBuffer(m_buffers[name], 0.0f, 0, count * sizeof(float));
    }
    m_blocks = blocks;
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

  void enqueueHouseholder(StressRun& run, std::uint32_t noiseSeed) {
    run.launch(m_fit.kernel, {m_blocks * m_fit.group, 1}, cl::NDRange(m_fit.group, 1),
               run.buffer("irradiance"), run.buffer("guides"), run.buffer("guides"), run.buffer("fitRecords"),
               run.buffer("fitStorage"), makeFitParams(m_blocks, noiseSeed, m_noiseAmplitude));
  }

  void enqueueGram(StressRun& run) {
    const GramParams params = makeGramParams(m_blocks, m_noiseAmplitude);
    const auto solvedAtOnce = static_cast<std::size_t>(lanes());
    run.launch(m_gramSums.kernel, {m_blocks * m_gramSums.group, 1}, cl::NDRange(m_gramSums.group, 1),
               run.buffer("irradiance"), run.buffer("guides"), run.buffer("guides"), run.buffer("gramTiles"),
               params);
    run.launch(m_gramSolve, {(m_blocks + solvedAtOnce - 1) / solvedAtOnce, 1}, cl::NDRange(1, 1),
               run.buffer("gramTiles"), run.buffer("fitRecords"), params);
  }

  /// Predicts every pixel from the records that were enqueued last; blocks.
  std::vector<BlockFit> synthesize(StressRun& run) {
    run.launch(m_weightedSum, {static_cast<std::size_t>(kBlockEdge / lanes()), m_blocks * kBlockEdge},
               cl::NDRange(1, 1), run.buffer("fitRecords"), run.buffer("guides"), run.buffer("guides"),
               run.buffer("fitted"), makeFitParams(m_blocks, 0, 0.0));
    std::vector<BlockFit> fits(m_blocks);
    const std::vector<float> records = download("fitRecords", m_blocks * QUELL_FIT_RECORD);
    const std::vector<float> fitted = downloadPlanes("fitted", 3);
    for (std::size_t block = 0; block < m_blocks; ++block) {
      std::copy_n(records.begin() + static_cast<std::ptrdiff_t>(block * QUELL_FIT_RECORD), QUELL_FIT_RECORD,
                  fits[block].record.begin());
      for (std::size_t pixel = 0; pixel < kBlockPixels; ++pixel)
        for (std::size_t c = 0; c < 3; ++c) fits[block].fitted[pixel][c] = fitted[elementOf(c, block, pixel)];
    }
    return fits;
  }

  void downloadInputs(std::vector<BlockInputs>& inputs) {
    const std::vector<float> irradiance = downloadPlanes("irradiance", 3);
    const std::vector<float> guides = downloadPlanes("guides", QUELL_GUIDE_PLANES);
    for (std::size_t block = 0; block < m_blocks; ++block) {
      for (std::size_t pixel = 0; pixel < kBlockPixels; ++pixel) {
        for (std::size_t c = 0; c < 3; ++c)
          inputs[block].irradiance[pixel][c] = irradiance[elementOf(c, block, pixel)];
        for (std::size_t plane = 0; plane < QUELL_GUIDE_PLANES; ++plane)
          inputs[block].guides[pixel][plane] = guides[elementOf(plane, block, pixel)];
      }
    }
  }

  std::vector<float> download(const std::string& name, std::size_t elements) {
    std::vector<float> values(elements);
    m_queue.enqueueReadBuffer(m_buffers.at(name), CL_TRUE, 0, elements * sizeof(float), values.data());
    return values;
  }

  std::vector<float> downloadPlanes(const std::string& name, std::size_t planes) {
    return download(name, planes * static_cast<std::size_t>(makePlanes(imageSize(m_blocks)).stride));
  }

  std::size_t elementOf(std::size_t plane, std::size_t block, std::size_t pixel) const {
    const PlaneParams planes = makePlanes(imageSize(m_blocks));
    const std::size_t row = block * kBlockEdge + pixel / kBlockEdge + QUELL_PLANE_MARGIN_ROWS;
    return plane * static_cast<std::size_t>(planes.stride) + row * static_cast<std::size_t>(planes.pitch) +
           QUELL_PLANE_MARGIN + pixel % kBlockEdge;
  }

  cl::Device m_device;
  cl::Context m_context;
  cl::CommandQueue m_queue;
  std::string m_name;
  double m_noiseAmplitude;
  Configuration m_configuration;
  AccumulateNoisy m_accumulateFloat{AccumulateNoisy::Setup{1.0}};
  AccumulateNoisy m_accumulateHalf{AccumulateNoisy::Setup{1.0}};
  SharedKernel m_fit, m_gramSums;
  cl::Kernel m_gramSolve, m_weightedSum;
  std::size_t m_blocks = 0;
  std::map<std::string, cl::Buffer> m_buffers;
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
