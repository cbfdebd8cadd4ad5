#include "host/analytic/sequence.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numeric>
#include <quell/error.hpp>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "host/analytic/camera.hpp"
#include "host/analytic/light.hpp"
#include "host/analytic/material.hpp"
#include "host/io/halton.hpp"

namespace quell::io {
namespace {

using namespace analytic;

constexpr int kMaxExtentPx = 16384;
constexpr int kMaxThreads = 1024;
constexpr int kMaxFrames = 1 << 20;  // frames() lists them all
// Keeps a mistyped number from running for days; at 2^20 samples the noise is 0.1 % of one sample's.
constexpr int kMaxReferenceSamples = 1 << 20;

// Streams of random numbers, so that the noisy frame and both halves of the reference are independent.
constexpr std::uint32_t kNoisyStream = 0;
constexpr std::uint32_t kReferenceStreamA = 1;
constexpr std::uint32_t kReferenceStreamB = 2;
constexpr std::uint32_t kAntialiasedStreams = 2;  // added to them

void requireInRange(const char* option, long long value, long long low, long long high) {
  if (value >= low && value <= high) return;
  throw Error(
      ErrorCode::InvalidArgument,
      {"makeAnalyticSequence", option,
       "a value in [" + std::to_string(low) + ", " + std::to_string(high) + "]", std::to_string(value)});
}

void requireValid(const AnalyticOptions& options) {
  requireInRange("width", options.width, 1, kMaxExtentPx);
  requireInRange("height", options.height, 1, kMaxExtentPx);
  requireInRange("frameCount", options.frameCount, 1, kMaxFrames);
  requireInRange("referenceSamples", options.referenceSamples, 0, kMaxReferenceSamples);
  requireInRange("threadCount", options.threadCount, 0, kMaxThreads);
  if (!(options.skyShare >= 0.0 && options.skyShare <= 1.0))
    throw Error(ErrorCode::InvalidArgument,
                {"makeAnalyticSequence", "skyShare", "a value in [0, 1]", std::to_string(options.skyShare)});
  for (const double offset : options.worldOffset) {
    if (std::isfinite(offset)) continue;
    throw Error(ErrorCode::InvalidArgument,
                {"makeAnalyticSequence", "worldOffset", "three finite numbers in m", std::to_string(offset)});
  }
}

/// Calls renderRow(y) once for each row, on several threads. renderRow must not throw.
void forEachRow(int height, int threadCount, const std::function<void(int)>& renderRow) {
  std::atomic<int> nextRow{0};
  const auto work = [&] {
    for (int y = nextRow++; y < height; y = nextRow++) renderRow(y);
  };
  const int wanted = threadCount > 0 ? threadCount : int(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> helpers;
  helpers.reserve(std::size_t(std::min(wanted, height) - 1));
  try {
    while (helpers.size() < helpers.capacity()) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // With fewer threads than wanted the frame is only slower.
  }
  work();
  for (std::thread& helper : helpers) helper.join();
}

void store(Image& image, int x, int y, const glm::dvec3& value) {
  for (int c = 0; c < 3; ++c) image.at(x, y, c) = float(value[c]);
}

class AnalyticSequence final : public FrameSequence {
 public:
  explicit AnalyticSequence(const AnalyticOptions& options) : m_options(options) {}

  std::string name() const override;
  int width() const override { return m_options.width; }
  int height() const override { return m_options.height; }
  std::vector<int> frames() const override;
  FrameData read(int frame) const override;
  bool jittered() const override { return m_options.jitter; }
  bool hasReference(int frame, ReferenceKind kind) const override;
  Reference reference(int frame, ReferenceKind kind) const override;

 private:
  void requireFrame(const char* function, int frame) const;
  RoomCamera cameraAt(int frame) const;
  glm::dvec3 offset() const;
  std::optional<Hit> hitThrough(const Ray& ray, int y) const;
  Image blankImage() const { return Image(m_options.width, m_options.height, 3); }
  Random randomFor(std::uint32_t stream, int frame, int x, int y, int sample) const;
  void renderPixel(const RoomCamera& camera, int x, int y, FrameData& data) const;
  std::array<double, 2> jitterOf(int frame) const;
  Image renderReference(int frame, ReferenceKind kind, std::uint32_t stream) const;
  glm::dvec3 centrePixel(const RoomCamera& camera, int frame, std::uint32_t stream, int x, int y) const;
  glm::dvec3 antialiasedPixel(const RoomCamera& camera, int frame, std::uint32_t stream, int x, int y) const;

  AnalyticOptions m_options;
};

std::string AnalyticSequence::name() const {
  const std::string room = "analytic room, seed " + std::to_string(m_options.seed);
  if (m_options.skyShare == 0.0) return room;
  return room + ", " + std::to_string(std::lround(100.0 * m_options.skyShare)) + " % sky";
}

std::vector<int> AnalyticSequence::frames() const {
  std::vector<int> numbers(std::size_t(m_options.frameCount));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

void AnalyticSequence::requireFrame(const char* function, int frame) const {
  if (frame >= 0 && frame < m_options.frameCount) return;
  throw Error(ErrorCode::InvalidArgument,
              {std::string("AnalyticSequence::") + function, "frame",
               "a frame in [0, " + std::to_string(m_options.frameCount) + ")", std::to_string(frame)});
}

RoomCamera AnalyticSequence::cameraAt(int frame) const {
  return {m_options.movingCamera ? double(frame) : 0.0, m_options.width, m_options.height};
}

glm::dvec3 AnalyticSequence::offset() const {
  return {m_options.worldOffset[0], m_options.worldOffset[1], m_options.worldOffset[2]};
}

std::optional<Hit> AnalyticSequence::hitThrough(const Ray& ray, int y) const {
  if (y < m_options.skyShare * m_options.height) return std::nullopt;
  return nearestHit(ray);
}

Random AnalyticSequence::randomFor(std::uint32_t stream, int frame, int x, int y, int sample) const {
  const auto pixel = std::uint32_t(y) * std::uint32_t(m_options.width) + std::uint32_t(x);
  return {m_options.seed, stream, std::uint32_t(frame), pixel, std::uint32_t(sample)};
}

std::array<double, 2> AnalyticSequence::jitterOf(int frame) const {
  return m_options.jitter ? jitterPxOf(frame) : std::array<double, 2>{0.0, 0.0};
}

void AnalyticSequence::renderPixel(const RoomCamera& camera, int x, int y, FrameData& data) const {
  const Ray ray = camera.rayThrough(x + data.camera.jitterPx[0], y + data.camera.jitterPx[1]);
  const auto hit = hitThrough(ray, y);
  if (!hit) {  // the other images are zero already
    store(data.emission, x, y, skyRadiance(ray.direction));
    store(data.radiance, x, y, skyRadiance(ray.direction));
    return;
  }
  const glm::dvec3 normal = shadingNormalAt(*hit, ray.direction);
  const glm::dvec3 albedo = albedoAt(*hit);
  const glm::dvec3 emission = emissionAt(*hit);
  Random random = randomFor(kNoisyStream, data.number, x, y, 0);
  store(data.normalWorld, x, y, normal);
  store(data.positionWorld, x, y, hit->position + offset());
  store(data.albedo, x, y, albedo);
  store(data.emission, x, y, emission);
  store(data.radiance, x, y, albedo * sampleIrradiance(*hit, normal, random) + emission);
}

FrameData AnalyticSequence::read(int frame) const {
  requireFrame("read", frame);
  const RoomCamera camera = cameraAt(frame);
  FrameData data;
  data.number = frame;
  data.camera.worldToClip = camera.worldToClip(offset());
  data.camera.worldToClipPrev = cameraAt(frame - 1).worldToClip(offset());
  data.camera.jitterPx = jitterOf(frame);
  for (Image* image :
       {&data.radiance, &data.normalWorld, &data.positionWorld, &data.albedo, &data.emission}) {
    *image = blankImage();
  }
  forEachRow(m_options.height, m_options.threadCount, [&](int y) {
    for (int x = 0; x < m_options.width; ++x) renderPixel(camera, x, y, data);
  });
  return data;
}

glm::dvec3 AnalyticSequence::centrePixel(const RoomCamera& camera, int frame, std::uint32_t stream, int x,
                                         int y) const {
  const Ray ray = camera.rayThrough(x, y);
  const auto hit = hitThrough(ray, y);
  if (!hit) return skyRadiance(ray.direction);
  const glm::dvec3 normal = shadingNormalAt(*hit, ray.direction);
  glm::dvec3 sum(0.0);
  for (int sample = 0; sample < m_options.referenceSamples; ++sample) {
    Random random = randomFor(stream, frame, x, y, sample);
    sum += sampleIrradiance(*hit, normal, random);
  }
  return albedoAt(*hit) * sum / double(m_options.referenceSamples) + emissionAt(*hit);
}

glm::dvec3 AnalyticSequence::antialiasedPixel(const RoomCamera& camera, int frame, std::uint32_t stream,
                                              int x, int y) const {
  glm::dvec3 sum(0.0);
  for (int sample = 0; sample < m_options.referenceSamples; ++sample) {
    Random random = randomFor(stream, frame, x, y, sample);
    const double column = x + random.uniform() - 0.5, row = y + random.uniform() - 0.5;
    const Ray ray = camera.rayThrough(column, row);
    const auto hit = hitThrough(ray, y);
    if (!hit) {
      sum += skyRadiance(ray.direction);
      continue;
    }
    const glm::dvec3 normal = shadingNormalAt(*hit, ray.direction);
    sum += albedoAt(*hit) * sampleIrradiance(*hit, normal, random) + emissionAt(*hit);
  }
  return sum / double(m_options.referenceSamples);
}

Image AnalyticSequence::renderReference(int frame, ReferenceKind kind, std::uint32_t stream) const {
  const RoomCamera camera = cameraAt(frame);
  Image image = blankImage();
  const auto pixel =
      kind == ReferenceKind::Centre ? &AnalyticSequence::centrePixel : &AnalyticSequence::antialiasedPixel;
  if (kind == ReferenceKind::Antialiased) stream += kAntialiasedStreams;
  forEachRow(m_options.height, m_options.threadCount, [&](int y) {
    for (int x = 0; x < m_options.width; ++x) store(image, x, y, (this->*pixel)(camera, frame, stream, x, y));
  });
  return image;
}

bool AnalyticSequence::hasReference(int frame, ReferenceKind /*kind*/) const {
  return m_options.referenceSamples > 0 && frame >= 0 && frame < m_options.frameCount;
}

Reference AnalyticSequence::reference(int frame, ReferenceKind kind) const {
  requireReference(*this, frame, kind);
  return {renderReference(frame, kind, kReferenceStreamA), renderReference(frame, kind, kReferenceStreamB),
          kind};
}

}  // namespace

std::unique_ptr<FrameSequence> makeAnalyticSequence(const AnalyticOptions& options) {
  requireValid(options);
  return std::make_unique<AnalyticSequence>(options);
}

}  // namespace quell::io
