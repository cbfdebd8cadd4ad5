// How much of a frame finds its surfaces in the one before.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/check/checks.hpp"

namespace quell::check {
namespace {

/// Largest distance between a surface point and the one found for it, as a share of its distance from the camera, if that
/// is more than a pixel covers; and largest angle between their normals as a cosine.
constexpr double kSameShare = 0.01, kSameCosine = 0.9;
/// Surfaces are seen at a grazing angle from this cosine on.
constexpr double kGrazing = 0.1;
/// Less than this share of the surfaces keeps its history: hardly a sequence.
constexpr double kLittle = 0.3;

/// Where the surface was in the frame before, pixels; nothing outside the image.
std::optional<glm::dvec2> placeBefore(const Context& context, const Surface& surface) {
  const auto& jitter = context.now.camera.jitterPx;
  auto place = project(context.now.camera.worldToClipPrev, surface.position, context.size);
  if (!place) return std::nullopt;
  *place -= glm::dvec2(jitter[0], jitter[1]);
  if (context.now.motion.present())
    place = glm::dvec2(surface.x + 0.5 + double(context.now.motion.at(surface.x, surface.y, 0)),
                       surface.y + 0.5 + double(context.now.motion.at(surface.x, surface.y, 1)));
  if (!(place->x >= 0.0 && place->y >= 0.0 && place->x < context.size.width &&
        place->y < context.size.height))
    return std::nullopt;
  return place;
}

/// How far apart points of one surface may be.
double sameDistance(const Context& context, const Surface& surface) {
  const Matrix4& m = context.now.camera.worldToClip;
  const double w = std::abs(clipOf(m, 3, surface.position));
  const double footprint = 2.0 * w / (context.size.height * glm::length(rowOf(m, 1)));
  const double cosine =
      std::abs(glm::dot(glm::normalize(surface.normal), context.view->towards(surface.position)));
  return std::max(kSameShare * w / context.view->depthUnit, footprint / std::max(cosine, kGrazing));
}

/// Whether any pixel around shows the surface.
bool keepsHistory(const Context& context, const Surface& surface, const glm::dvec2& place) {
  const int left = int(std::floor(place.x - 0.5)), top = int(std::floor(place.y - 0.5));
  const double limit = sameDistance(context, surface);
  for (int tap = 0; tap < 4; ++tap) {
    const int x = left + tap % 2, y = top + tap / 2;
    if (x < 0 || y < 0 || x >= context.size.width || y >= context.size.height) continue;
    const glm::dvec3 normal = vectorAt(context.before->normalWorld, x, y);
    const glm::dvec3 step = context.positionBefore(x, y) - surface.position;
    const bool moves =
        context.now.motion.present() && context.now.objectId.present() &&
        context.before->objectId.present() &&
        context.before->objectId.at(x, y, 0) == context.now.objectId.at(surface.x, surface.y, 0);
    if (!isFinite(normal) || isZero(normal) || !isFinite(step)) continue;
    if (glm::dot(glm::normalize(normal), glm::normalize(surface.normal)) < kSameCosine) continue;
    if (moves || glm::length(step) <= limit) return true;
  }
  return false;
}

void acceptance(const Context& context, Result& result) {
  if (context.before == nullptr || !context.view || !context.view->perspective || !result.geometryFits)
    return;
  std::size_t seen = 0, kept = 0;
  std::vector<double> lost;
  for (const Surface& surface : context.surfaces()) {
    const auto place = placeBefore(context, surface);
    const bool keeps = place && keepsHistory(context, surface, *place);
    seen += place.has_value();
    kept += keeps;
    lost.push_back(place && !keeps ? 1.0 : 0.0);
  }
  if (seen < kLeastSurfaces) return;
  const double share = double(kept) / double(seen);
  result.figures.push_back({kFoundBefore, 100.0 * share, "%"});
  if (share >= kLittle || !result.previousCameraFits) return;
  result.add({"history-lost", Severity::Doubtful, "camera",
              "surfaces of the frame before where its camera puts them",
              percent(share) + " of those within its image are found there",
              "if this is no cut: look at worldToClipPrev, motion vectors and the order of frames; at a cut, "
              "reset the history",
              (seen - kept) * context.pixelsEach()},
             context.mapOf(lost));
}

}  // namespace

const Group& historyChecks() {
  static const Group group = {acceptance};
  return group;
}

}  // namespace quell::check
