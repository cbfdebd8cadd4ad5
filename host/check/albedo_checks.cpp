// Albedo that cannot be what light was multiplied with.
#include <algorithm>
#include <cmath>

#include "host/check/albedo_exponent.hpp"
#include "host/check/checks.hpp"

namespace quell::check {
namespace {

/// Light beyond emission, as a share of it: more than rounding to 8 bits.
constexpr double kLitShare = 0.02;
/// Of the surfaces, below which it is a matter of some objects.
constexpr double kFewShare = 0.02;
/// A reflectance is at most 1, but for rounding; from the next on it was scaled to bytes.
constexpr double kMostAlbedo = 1.05, kByteAlbedo = 16.0;
/// Light that goes with so high a power of albedo, this many standard errors above, was reflected by linear albedo while
/// the image is encoded (2.2). Glossy light makes the power smaller.
constexpr double kEncodedExponent = 1.4, kStandardErrors = 4.0;

double mostOf(const Image& image, int x, int y) {
  const glm::dvec3 v = vectorAt(image, x, y);
  return std::max({v.x, v.y, v.z});
}

void zero(const Context& context, Result& result) {
  const Frame& frame = context.now;
  const auto mark = [&](int x, int y) {
    const double light = luminanceAt(frame.radiance, x, y);
    const bool lit = light - luminanceAt(frame.emission, x, y) > kLitShare * light;
    const bool black = mostOf(frame.albedo, x, y) <= 0.0 &&
                       (!frame.glossColor.present() || mostOf(frame.glossColor, x, y) <= 0.0);
    return lit && black ? 1.0 : 0.0;
  };
  std::vector<double> marks;
  std::size_t count = 0;
  for (const Surface& surface : context.surfaces()) {
    marks.push_back(mark(surface.x, surface.y));
    count += marks.back() > 0.0;
  }
  const double share = double(count) / double(context.surfaces().size());
  if (!(share > kFewShare)) return;
  result.add(
      {"albedo-zero", Severity::Doubtful, "albedo", "reflectance of what is lit",
       "0 on " + percent(share) + " of the surfaces though they reflect light",
       "give 1 on metal, mirrors and glass, or the colour that they reflect", count * context.pixelsEach()},
      context.mapOf(marks));
}

void aboveOne(const Context& context, Result& result) {
  std::size_t count = 0;
  double most = 0.0;
  std::vector<double> marks;
  for (const Surface& surface : context.surfaces()) {
    const double value = mostOf(context.now.albedo, surface.x, surface.y);
    if (std::isfinite(value)) most = std::max(most, value);
    marks.push_back(value > kMostAlbedo ? 1.0 : 0.0);
    count += value > kMostAlbedo;
  }
  const double share = double(count) / double(context.surfaces().size());
  if (!(share > kFewShare)) return;
  const bool bytes = share > 0.5 && most > kByteAlbedo && most <= 255.5;
  result.radianceFits = false;  // nothing to be learnt from its power
  result.add(
      {"albedo-above-1", bytes ? Severity::Wrong : Severity::Doubtful, "albedo", "reflectance from 0 to 1",
       "above 1 on " + percent(share) + " of the surfaces, up to " + fixed(most, 2),
       bytes ? "divide by 255 (and undo sRGB if it was bytes of a texture)"
             : "divide by the number of samples if they were summed up; give 1 where it is no reflectance "
               "(Mitsuba: on "
               "rough conductors)",
       count * context.pixelsEach()},
      context.mapOf(marks));
}

void encoded(const Context& context, Result& result) {
  if (context.now.demodulated || !result.radianceFits) return;
  const auto exponent = albedoExponent(context);
  if (!exponent) return;
  result.figures.push_back({"power of albedo that light goes with", exponent->value, ""});
  if (!(exponent->value - kStandardErrors * exponent->standardError > kEncodedExponent)) return;
  result.add({"albedo-srgb", Severity::Doubtful, "albedo",
              "linear albedo, with which light goes in proportion",
              "light that goes with its power of " + fixed(exponent->value, 2) + " (+- " +
                  fixed(exponent->standardError, 2) + ")",
              "undo sRGB or the gamma of 2.2: a^2.2", context.surfaces().size() * context.pixelsEach()});
}

/// All of them need albedo, and surfaces to look at.
template <void (*Work)(const Context&, Result&)>
void withAlbedo(const Context& context, Result& result) {
  if (context.now.albedo.present() && context.surfaces().size() >= kLeastSurfaces) Work(context, result);
}

}  // namespace

const Group& albedoChecks() {
  static const Group group = {withAlbedo<zero>, withAlbedo<aboveOne>, withAlbedo<encoded>};
  return group;
}

}  // namespace quell::check
