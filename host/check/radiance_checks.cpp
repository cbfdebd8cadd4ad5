// Light that is not of this frame alone, or not what is emitted and reflected.
#include <algorithm>
#include <cmath>

#include "host/check/checks.hpp"
#include "host/check/noise.hpp"

namespace quell::check {
namespace {

/// Of the pixels: a sum never falls, noise of its own falls in half of them.
constexpr double kNeverFalls = 0.99, kMostlyRises = 0.5, kRounding = 2e-3;
/// Difference of neighbours as a share of their sum, median: below, it is not noise.
constexpr double kLeastNoise = 0.1;
/// Emission counts from here on; radiance is below it from this share on, more than rounding to 8 bits.
constexpr double kLeastEmission = 1e-4, kBelowShare = 0.95;
/// Of the emitting pixels, and their least number.
constexpr double kMostEmitters = 0.5;
constexpr std::size_t kLeastEmitters = 16;
/// A firefly is so many times as bright as its neighbours together; and their share of all light from which on it counts.
constexpr double kFirefly = 8.0, kFireflyLight = 0.5;

bool isNoisy(const Context& context) {
  std::vector<double> differences;
  context.forEach([&](int x, int y) {
    if (x + 1 >= context.size.width) return;
    const double a = luminanceAt(context.now.radiance, x, y), b = luminanceAt(context.now.radiance, x + 1, y);
    if (a + b > 0.0 && std::isfinite(a + b)) differences.push_back(std::abs(a - b) / (a + b));
  });
  return median(std::move(differences)) > kLeastNoise;
}

void sums(const Context& context, Result& result) {
  if (context.before == nullptr || !isNoisy(context)) return;
  double pixels = 0.0, kept = 0.0, risen = 0.0, now = 0.0, before = 0.0;
  for (const Surface& surface : context.surfaces()) {
    const double a = luminanceAt(context.before->radiance, surface.x, surface.y);
    const double b = luminanceAt(context.now.radiance, surface.x, surface.y);
    if (!std::isfinite(a + b)) continue;
    pixels += 1.0;
    kept += b >= a * (1.0 - kRounding);
    risen += b > a * (1.0 + kRounding);
    now += b;
    before += a;
  }
  if (!(pixels >= double(kLeastSurfaces) && kept > kNeverFalls * pixels && risen > kMostlyRises * pixels))
    return;
  result.radianceFits = false;
  result.add({"radiance-sum", Severity::Wrong, "radiance", "light of this frame alone",
              "no less than in the frame before on " + percent(kept / pixels) + " of the surfaces, " +
                  fixed(now / before, 2) + " times in all",
              "it is summed up over frames: give each frame's own samples, divided by their number",
              std::size_t(pixels) * context.pixelsEach()});
}

void frozenNoise(const Context& context, Result& result) {
  if (context.before == nullptr || !result.radianceFits) return;
  const auto correlation = noiseCorrelation(noiseResiduals(*context.before), noiseResiduals(context.now));
  if (!correlation) return;
  result.figures.push_back({"correlation of noise with that of the frame before", *correlation, ""});
  if (!(*correlation > kFrozenNoise)) return;
  result.radianceFits = false;
  result.add({kFrozenNoiseKind, Severity::Doubtful, "radiance", "noise of its own in every frame",
              "noise like that of the frame before (correlation " + fixed(*correlation, 2) + ")",
              "goes on without history where the view is still; render with another seed for every frame "
              "(Blender: the clock "
              "beside Sampling > Advanced > Seed), and give no averages over frames",
              0});
}

/// Of light where something is emitted: how often it is less, and whether at one value.
struct Emitters {
  std::size_t pixels = 0, below = 0, atMost = 0;
  double most = 0.0;
};

bool isBelow(const Frame& frame, int x, int y) {
  const double emitted = luminanceAt(frame.emission, x, y);
  return emitted > kLeastEmission && luminanceAt(frame.radiance, x, y) < kBelowShare * emitted;
}

Emitters countEmitters(const Context& context) {
  Emitters emitters;
  const Frame& frame = context.now;
  std::vector<double> below;
  context.forEach([&](int x, int y) {
    emitters.pixels += luminanceAt(frame.emission, x, y) > kLeastEmission;
    emitters.most = std::max(emitters.most, luminanceAt(frame.radiance, x, y));
    if (isBelow(frame, x, y)) below.push_back(luminanceAt(frame.radiance, x, y));
  });
  emitters.below = below.size();
  for (const double value : below) emitters.atMost += value >= 0.99 * emitters.most;
  return emitters;
}

void emission(const Context& context, Result& result) {
  const Frame& frame = context.now;
  if (!frame.emission.present() || frame.demodulated) return;
  const Emitters emitters = countEmitters(context);
  if (emitters.below < kLeastEmitters || !(double(emitters.below) > kMostEmitters * double(emitters.pixels)))
    return;
  const bool clamped = double(emitters.atMost) > kMostEmitters * double(emitters.below);
  const std::string share =
      percent(double(emitters.below) / double(emitters.pixels)) + " of the pixels that emit";
  result.add(
      {clamped ? "radiance-clamped" : "emission-not-in-radiance", clamped ? Severity::Note : Severity::Wrong,
       "radiance", "light with emission included",
       clamped ? "cut off at " + fixed(emitters.most, 3) + " on " + share : "less than emission on " + share,
       clamped ? "nothing to do: no more emission is added than radiance has; unclamped light is better"
               : "add emission to radiance (it is taken off before the filter and added afterwards), or "
                 "leave the "
                 "emission image out",
       emitters.below * context.pixelsEach()},
      context.mapOf([&](int x, int y) { return isBelow(frame, x, y) ? 1.0 : 0.0; }));
}

bool isFirefly(const Context& context, int x, int y) {
  const Image& light = context.now.radiance;
  if (x < 1 || y < 1 || x + 1 >= context.size.width || y + 1 >= context.size.height) return false;
  double around = 0.0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (dx != 0 || dy != 0) around += luminanceAt(light, x + dx, y + dy);
  return luminanceAt(light, x, y) - luminanceAt(context.now.emission, x, y) > kFirefly * around;
}

void fireflies(const Context& context, Result& result) {
  std::size_t count = 0;
  double theirs = 0.0, all = 0.0;
  for (const Surface& surface : context.surfaces()) {
    const double light = luminanceAt(context.now.radiance, surface.x, surface.y);
    if (!(light > 0.0) || !std::isfinite(light)) continue;
    all += light;
    if (!isFirefly(context, surface.x, surface.y)) continue;
    ++count;
    theirs += light;
  }
  if (!(all > 0.0)) return;
  result.figures.push_back({"light in fireflies", 100.0 * theirs / all, "%"});
  if (!(theirs > kFireflyLight * all)) return;
  result.add(
      {"fireflies", Severity::Doubtful, "radiance", "light that most pixels have a share of",
       percent(theirs / all) + " of it in pixels brighter than " + fixed(kFirefly, 0) +
           " times all their neighbours",
       "sample lights directly, or clamp indirect light in the renderer", count * context.pixelsEach()},
      context.mapOf([&](int x, int y) { return isFirefly(context, x, y) ? 1.0 : 0.0; }));
}

void black(const Context& context, Result& result) {
  double most = 0.0;
  context.forEach([&](int x, int y) { most = std::max(most, luminanceAt(context.now.radiance, x, y)); });
  if (most > 0.0) return;
  result.radianceFits = false;
  result.add({"radiance-black", Severity::Doubtful, "radiance", "light", "none on the whole frame",
              "look whether the right buffer was given, after the renderer was done", 0});
}

}  // namespace

const Group& radianceChecks() {
  static const Group group = {black, sums, frozenNoise, emission, fireflies};
  return group;
}

}  // namespace quell::check
