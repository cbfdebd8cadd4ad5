// How much of a frame shows surfaces, and what is missing in it.
#include <cmath>
#include <string_view>

#include "host/check/checks.hpp"
#include "host/core/image_schema.hpp"

namespace quell::check {
namespace {

/// Of the pixels: fewer are broken pixels rather than a habit of the renderer.
constexpr double kFewShare = 0.01;

void surfaceShare(const Context& context, Result& result) {
  std::size_t pixels = 0;
  context.forEach([&](int, int) { ++pixels; });
  const double share = double(context.surfaces().size()) / double(pixels);
  result.figures.push_back({"surface share", 100.0 * share, "%"});
  if (share > 0.0) return;
  result.add({"no-surfaces", Severity::Doubtful, "normalWorld",
              "normals and positions of surfaces, 0 for background alone", "none on the whole frame",
              "all of it counts as background and passes through unfiltered; give both for "
              "every surface",
              pixels * context.pixelsEach()});
}

/// Pixels of the grid for which `isMissing` is true, as a finding.
template <class Missing>
void countMissing(const Context& context, Result& result, const Missing& isMissing, Finding finding) {
  std::size_t pixels = 0, missing = 0;
  const auto mark = [&](int x, int y) { return isMissing(x, y) ? 1.0 : 0.0; };
  context.forEach([&](int x, int y) {
    ++pixels;
    missing += mark(x, y) > 0.0;
  });
  if (missing == 0) return;
  finding.severity = double(missing) > kFewShare * double(pixels) ? Severity::Doubtful : Severity::Note;
  finding.got = percent(double(missing) / double(pixels)) + " of the pixels " + finding.got;
  finding.pixels = missing * context.pixelsEach();
  result.add(std::move(finding), context.mapOf(mark));
}

bool isBroken(const Image& image, int x, int y) {
  return image.present() && !isFinite(vectorAt(image, x, y));
}

void missingSamples(const Context& context, Result& result) {
  const Frame& frame = context.now;
  countMissing(context, result,
               [&](int x, int y) {
                 return isBroken(frame.radiance, x, y) || isBroken(frame.glossyRadiance, x, y) ||
                        isBroken(frame.emission, x, y);
               },
               {"missing-samples", Severity::Note, "radiance", "finite light", "NaN or infinite",
                "they keep their history or are filled from around; if they are many, look for divisions by "
                "0 in the renderer",
                0});
  countMissing(context, result, [&](int x, int y) { return luminanceAt(frame.radiance, x, y) < 0.0; },
               {"negative-light", Severity::Note, "radiance", "light of 0 and above", "negative",
                "they count as 0, which makes the picture brighter; look for a filter with negative lobes or "
                "a difference",
                0});
}

/// Whether a feature has no value where there is a surface. Depth of the sky is often infinite, and positions there.
bool isBrokenFeature(const Frame& frame, const char* name, const Image& image, int x, int y) {
  if (isZero(vectorAt(frame.normalWorld, x, y))) return false;
  return name == std::string_view("viewDepth") ? std::isnan(image.at(x, y, 0)) : isBroken(image, x, y);
}

void brokenFeatures(const Context& context, Result& result) {
  const Frame& frame = context.now;
  for (const auto& facts : kInputs<Frame>) {
    const Image& image = frame.*facts.member;
    const bool isLight = facts.member == &Frame::radiance || facts.member == &Frame::glossyRadiance ||
                         facts.member == &Frame::emission;
    const bool mayBreak =
        facts.identifiers() || facts.member == &Frame::motion || facts.member == &Frame::hitDistance;
    if (!image.present() || isLight || mayBreak) continue;
    countMissing(
        context, result, [&](int x, int y) { return isBrokenFeature(frame, facts.name, image, x, y); },
        {"broken-features", Severity::Note, facts.name, "finite values on surfaces", "NaN or infinite",
         std::string(facts.texts.broken) + "; write the values of the first hit", 0});
  }
}

}  // namespace

const Group& surfaceChecks() {
  static const Group group = {surfaceShare, missingSamples, brokenFeatures};
  return group;
}

}  // namespace quell::check
