// Do positions lie where the camera says, in this frame and with the matrix of the one before?
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/check/camera_candidates.hpp"
#include "host/check/checks.hpp"
#include "host/check/projection.hpp"

namespace quell::check {
namespace {

/// Another reading must leave this share of the distance, and no more than so many pixels.
constexpr double kMuchBetter = 0.25, kNearPx = 1.0;
/// From this median on it is asked whether another reading is better, pixels. Rays anywhere in a pixel have .38.
constexpr double kSuspectPx = 0.75;
/// A common offset counts from here on, pixels, if so little of the distance is left without it.
constexpr double kLeastShiftPx = 0.3, kLeftOverShare = 0.5;
/// Matrices of two frames agree up to this, pixels; less proves more if the matrix is another one that is known.
constexpr double kSameCameraPx = 0.5, kFrozenCameraPx = 0.1;
/// A whole factor up to this is more likely a number of samples than the ratio of two units (10, 100, 1000).
constexpr double kMostSamples = 9.5;
/// Distance that is white in a picture, pixels.
constexpr double kPicturePx = 5.0;

constexpr char kExpected[] = "positions that the camera puts into their pixels";

std::string px(double distance) { return fixed(distance, 2) + " px"; }

/// How far positions are off as the camera is given.
std::string offText(double medianPx) {
  return std::isfinite(medianPx) ? "positions " + px(medianPx) + " off (median)"
                                 : "most positions behind the camera";
}

std::size_t countAbove(const std::vector<double>& values, double limit) {
  std::size_t count = 0;
  for (const double value : values) count += !(value <= limit);
  return count;
}

Map mapOf(const Context& context, std::vector<double> distances) {
  for (double& distance : distances) distance = std::isfinite(distance) ? distance / kPicturePx : 1.0;
  return context.mapOf(distances);
}

/// Positions are all `factor` times too far from the world's origin; NaN for a camera without a place.
double scaleOfPositions(const Context& context) {
  const Matrix4& m = context.now.camera.worldToClip;
  std::vector<double> factors;
  for (const Surface& surface : context.surfaces()) {
    const double ndcX = 2.0 * (surface.x + 0.5) / context.size.width - 1.0;
    const double part = glm::dot(rowOf(m, 0) - ndcX * rowOf(m, 3), surface.position);
    const double factor = part / (ndcX * m[15] - m[3]);
    if (std::isfinite(factor)) factors.push_back(factor);
  }
  return median(std::move(factors));
}

struct Best {
  CameraCandidate candidate;
  double medianPx;
};

std::optional<Best> bestCandidate(const Context& context) {
  std::optional<Best> best;
  for (const CameraCandidate& candidate : cameraCandidates()) {
    const auto matrix = candidate.matrix(context);
    if (!matrix) continue;
    const double distance = median(lengthsOf(offsetsPx(context, *matrix)));
    if (!best || distance < best->medianPx - 1e-3) best = Best{candidate, distance};
  }
  return best;
}

/// Sums and other units; `distances` under the camera as given.
bool findScale(const Context& context, double given, const std::vector<double>& distances, Result& result) {
  const double factor = scaleOfPositions(context);
  const double unit = 1.0 / factor;
  if (!std::isfinite(unit) || !(unit > 0.0) || std::abs(factor - 1.0) < 1e-3) return false;
  const Matrix4 matrix = scaledColumns(context.now.camera.worldToClip, {unit, unit, unit, 1.0});
  const double scaled = median(lengthsOf(offsetsPx(context, matrix)));
  if (!(scaled < kMuchBetter * given && scaled < kNearPx)) return false;
  const bool isSum =
      factor > 1.5 && factor < kMostSamples && std::abs(factor - std::round(factor)) < 0.02 * factor;
  const std::string times = fixed(factor, isSum ? 0 : 3);
  result.add(
      {isSum ? "position-sum" : "position-unit", Severity::Wrong, "positionWorld", kExpected,
       offText(given) + "; " + px(scaled) + " divided by " + times,
       isSum ? "divide by the number of samples, " + times + ": they are summed up; or by the ratio of units"
             : "give positions and matrices in one unit, and divide sums by the number of samples",
       countAbove(distances, kNearPx) * context.pixelsEach()},
      mapOf(context, distances));
  return true;
}

void explainDistance(const Context& context, double given, const std::vector<double>& distances,
                     Result& result) {
  const auto best = bestCandidate(context);
  if (best && best->medianPx < kMuchBetter * given && best->medianPx < kNearPx) {
    result.geometryFits = false;
    result.add({best->candidate.kind, Severity::Wrong, best->candidate.image, kExpected,
                offText(given) + "; " + px(best->medianPx) + " " + best->candidate.is, best->candidate.cure,
                countAbove(distances, kNearPx) * context.pixelsEach()},
               mapOf(context, distances));
    return;
  }
  result.geometryFits = given <= kFittingPx;
  if (findScale(context, given, distances, result) || result.geometryFits) return;
  result.add(
      {"position-camera-mismatch", Severity::Wrong, "camera", kExpected,
       px(given) +
           " (median), and no better with any reading tried (transposed, turned over, inverse, of the frame "
           "before, in view space, other axes or units)",
       "compare the projection of one position by hand: clip = worldToClip * (x, y, z, 1), column = (0.5 + "
       "0.5 x / w) "
       "* width, row = (0.5 - 0.5 y / w) * height",
       countAbove(distances, kNearPx) * context.pixelsEach()},
      mapOf(context, distances));
}

/// Which convention a common offset speaks of.
std::string cureOfShift(const glm::dvec2& shift, const std::array<double, 2>& jitterPx) {
  const glm::dvec2 jitter(jitterPx[0], jitterPx[1]);
  const auto is = [&](const glm::dvec2& other) {
    return glm::length(shift - other) < 0.2 * glm::length(other);
  };
  if (isJittered({{}, {}, jitterPx})) {
    if (is(-jitter))
      return "leave the jitter out of the matrices, or set jitterPx to 0 if rays go through centres";
    if (is(-2.0 * jitter)) return "negate jitterPx: it is the ray's place minus the pixel's centre";
    if (is({0.0, -2.0 * jitter.y})) return "negate y of jitterPx: it points down";
  }
  if (std::abs(std::abs(shift.x) - 0.5) < 0.1 && std::abs(std::abs(shift.y) - 0.5) < 0.1)
    return "pixel centres lie at + 0.5: trace through them, or move the matrices by half a pixel";
  return "move the images or the matrices by that much (LuxCore: its picture lies a row lower than its "
         "camera says), or "
         "set jitterPx if it is the same for all pixels and changes from frame to frame";
}

void commonShift(const Context& context, const std::vector<glm::dvec2>& offsets, double given,
                 Result& result) {
  const glm::dvec2 shift = medianOf(offsets);
  if (!(glm::length(shift) > kLeastShiftPx)) return;
  std::vector<glm::dvec2> rest = offsets;
  for (glm::dvec2& offset : rest) offset -= shift;
  const double left = median(lengthsOf(rest));
  if (!(left < kLeftOverShare * given)) return;
  result.add({"image-shifted", Severity::Doubtful, "camera", kExpected,
              "positions " + fixed(shift.x, 2) + " px right of and " + fixed(shift.y, 2) +
                  " px below them (median); " + px(left) + " without that",
              cureOfShift(shift, context.now.camera.jitterPx), 0});
}

void projection(const Context& context, Result& result) {
  if (!context.now.cameraKnown) result.geometryFits = false;
  if (!result.geometryFits) return;
  if (!context.now.positionWorld.present() || context.surfaces().size() < kLeastSurfaces) return;
  const std::vector<glm::dvec2> offsets = offsetsPx(context, context.now.camera.worldToClip);
  const std::vector<double> distances = lengthsOf(offsets);
  const double given = median(distances);
  result.figures.push_back({"distance of projected positions from their pixels, median", given, "px"});
  if (given > kSuspectPx) explainDistance(context, given, distances, result);
  if (!result.geometryFits) return;
  commonShift(context, offsets, given, result);
  const double mean = rayOffsetPx(context.now);
  if (mean > kCentredRaysPx && median(lengthsOf(offsets)) > kCentredRaysPx && result.findings.empty())
    result.add({"features-jittered", Severity::Note, "positionWorld",
                "rays through pixel centres, or where jitterPx says",
                px(mean) + " off on average, another way in every pixel",
                "set `jitteredRays` to on, which `quell denoise` does by itself", 0});
}

/// What a camera may be like without harm.
void conventions(const Context& context, Result& result) {
  if (!context.view || !result.geometryFits) return;
  const Matrix4& m = context.now.camera.worldToClip;
  const View& view = *context.view;
  if (!view.perspective) return;
  if (glm::dot(glm::cross(view.right, view.up), view.forward) > 0.0) {
    const bool down = std::max(view.up.y, view.up.z) < -std::min(view.up.y, view.up.z);
    result.add({down ? "rows-bottom-up" : "left-handed", Severity::Note, "camera",
                "any camera that agrees with the images",
                down ? "a mirrored one whose up points down" : "a mirrored one",
                down ? "nothing to do if rows run bottom up on purpose; the output then does, too"
                     : "nothing to do if the world is left-handed",
                0});
  }
  const glm::dvec3 row = rowOf(m, 2);
  const double atEye =
      m[11] + glm::dot(row, view.eye);  // clip.z = a * clip.w + this, so NDC z falls with clip.w if it is > 0
  const bool alongView = glm::length(glm::cross(row, view.forward)) <= 1e-6 * glm::length(row);
  if (alongView && atEye > 1e-12 * std::abs(m[11]))
    result.add({"reversed-z", Severity::Note, "camera", "any row 2, which is not used",
                "clip.z that falls with distance", "nothing to do: reversed z makes no difference here", 0});
}

/// Distance between where two cameras put the surfaces of this frame, median, pixels.
double apartPx(const Context& context, const Matrix4& a, const Matrix4& b) {
  std::vector<double> distances;
  for (const Surface& surface : context.surfaces()) {
    const auto one = project(a, surface.position, context.size),
               other = project(b, surface.position, context.size);
    if (other)
      distances.push_back(one ? glm::length(*one - *other) : std::numeric_limits<double>::infinity());
  }
  return median(std::move(distances));
}

void previousCamera(const Context& context, Result& result) {
  if (context.before == nullptr || !result.geometryFits || context.surfaces().size() < kLeastSurfaces) return;
  const Camera& camera = context.now.camera;
  const double apart = apartPx(context, camera.worldToClipPrev, context.before->camera.worldToClip);
  const bool frozen = apartPx(context, camera.worldToClipPrev, camera.worldToClip) < 0.1 * apart;
  if (!(apart > (frozen ? kFrozenCameraPx : kSameCameraPx))) return;
  result.previousCameraFits = false;
  result.add(
      {frozen ? "previous-camera-frozen" : "previous-camera", Severity::Wrong, "camera",
       "in worldToClipPrev the worldToClip of the frame before",
       (frozen ? "that of this frame, though the camera moved: surfaces are "
               : "another one: surfaces are ") +
           px(apart) + " apart (median)",
       frozen ? "keep last frame's matrix and pass it; without it history is lost wherever the camera moves"
              : "keep last frame's worldToClip and pass it as it was; at a cut, reset the history",
       context.surfaces().size() * context.pixelsEach()});
}

}  // namespace

const Group& cameraChecks() {
  static const Group group = {projection, conventions, previousCamera};
  return group;
}

}  // namespace quell::check
