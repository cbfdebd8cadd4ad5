#include "host/render/render_sequence.hpp"

#include <fmt/format.h>

#include <quell/error.hpp>

#include "host/io/halton.hpp"

namespace quell::render {
namespace {

constexpr int kMaxFrames = 10000;  // four digits in file names
constexpr int kMaxSamples = 1 << 20;
void requireInRange(const char* option, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw Error(ErrorCode::InvalidArgument,
              {"render", option, fmt::format("a number in [{}, {}]", low, high), std::to_string(value)});
}

class Run {
 public:
  Run(const RenderOptions& options, const RenderProgress& progress)
      : m_options(options),
        m_progress(progress),
        m_scene(findScene(options.settings.scene)),
        m_tracer(options.device, options.cacheDirectory, options.settings.size),
        m_writer(options.output, options.settings, options.frameCount) {
    if (options.settings.referenceSamples > 0)
      m_referenceFrames = options.referenceFrames.empty()
                              ? defaultReferenceFrames(m_scene, options.frameCount)
                              : options.referenceFrames;
    if (options.settings.jitter) m_referenceKinds.push_back(io::ReferenceKind::Antialiased);
    const double halves = 2.0 * double(m_referenceKinds.size() * m_referenceFrames.size());
    m_work =
        double(options.frameCount) * options.settings.samples + halves * options.settings.referenceSamples;
    m_report.device = m_tracer.deviceName();
  }

  RenderReport run() {
    for (int frame = 0; frame < m_options.frameCount; ++frame) renderFrame(frame);
    for (const int frame : m_referenceFrames)
      for (const io::ReferenceKind kind : m_referenceKinds)
        for (const char half : {'a', 'b'}) renderReference(frame, kind, half);
    return m_report;
  }

 private:
  void renderFrame(int frame) {
    const int samples = m_options.settings.samples;
    if (m_writer.hasFrame(frame)) {
      ++m_report.framesKept;
      return advance(samples, fmt::format("frame {} kept", frame));
    }
    Scene scene = makeScene(m_scene, frame);
    if (m_options.settings.jitter) scene.camera.jitterPx = io::jitterPxOf(frame);
    const Features features = m_tracer.features(scene, makeScene(m_scene, frame - 1));
    m_writer.writeFrame(frame, withLight(features, lightOf(frame, kNoisyStream, samples, {})));
    ++m_report.framesRendered;
    advance(samples, fmt::format("frame {}", frame));
  }

  void renderReference(int frame, io::ReferenceKind kind, char half) {
    const int samples = m_options.settings.referenceSamples;
    const std::string name = fmt::format("reference {} ({}) of frame {}", half, toString(kind), frame);
    if (m_writer.hasReference(frame, kind, half)) {
      ++m_report.halvesKept;
      return advance(samples, name + " kept");
    }
    const SampleProgress progress = [&](int done) { advance(done, name); };
    m_writer.writeReference(frame, kind, half, referenceOf(frame, kind, half, progress));
    ++m_report.halvesRendered;
  }

  io::FrameData referenceOf(int frame, io::ReferenceKind kind, char half, const SampleProgress& progress) {
    const int samples = m_options.settings.referenceSamples, stream = referenceStream(half, kind);
    const Scene now = makeScene(m_scene, frame), before = makeScene(m_scene, frame - 1);
    if (kind == io::ReferenceKind::Centre) {
      const Features features = m_tracer.features(now, before);
      return withLight(features, lightOf(frame, stream, samples, progress));
    }
    io::FrameData data;
    data.combined =
        m_tracer.antialiased(now, before, mixSeed(m_options.settings.seed, frame, stream), samples, progress);
    return data;
  }

  Light lightOf(int frame, int stream, int samples, const SampleProgress& progress) {
    return m_tracer.light(mixSeed(m_options.settings.seed, frame, stream), samples, Estimator::Both,
                          progress);
  }

  void advance(int samples, const std::string& what) {
    m_done += samples;
    if (m_progress) m_progress(m_done / m_work, what);
  }

  const RenderOptions& m_options;
  const RenderProgress& m_progress;
  const SceneEntry& m_scene;
  PathTracer m_tracer;
  SequenceWriter m_writer;
  std::vector<int> m_referenceFrames;
  std::vector<io::ReferenceKind> m_referenceKinds{io::ReferenceKind::Centre};
  RenderReport m_report;
  double m_work = 0.0;
  double m_done = 0.0;
};

}  // namespace

std::vector<int> defaultReferenceFrames(const SceneEntry& scene, int frameCount) {
  std::vector<int> frames;
  if (scene.extraReferenceFrame >= 0 && scene.extraReferenceFrame < frameCount - 1)
    frames.push_back(scene.extraReferenceFrame);
  frames.push_back(frameCount - 1);
  return frames;
}

RenderReport renderSequence(const RenderOptions& options, const RenderProgress& progress) {
  requireInRange("frames", options.frameCount, 1, kMaxFrames);
  requireInRange("spp", options.settings.samples, 1, kMaxSamples);
  requireInRange("reference", options.settings.referenceSamples, 0, kMaxSamples);
  for (const int frame : options.referenceFrames)
    requireInRange("reference-frames", frame, 0, options.frameCount - 1);
  return Run(options, progress).run();
}

}  // namespace quell::render
