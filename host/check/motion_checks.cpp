// Motion vectors, told by where the matrices say that surfaces at rest were.
#include <cmath>
#include <glm/geometric.hpp>

#include "host/check/checks.hpp"

namespace quell::check {
namespace {

/// Surfaces count that move by more than this, pixels; vectors agree up to the next, for this share of them.
constexpr double kMovingPx = 0.5, kSamePx = 0.5, kAgreeingShare = 0.1;
/// Another reading must leave this share of the error.
constexpr double kMuchBetter = 0.25;
/// Vectors shorter than this lead nowhere, pixels.
constexpr double kNoMotionPx = 0.01;

struct Moving {
  glm::dvec2 given, expected;
  int x, y;
};

glm::dvec2 motionAt(const Frame& frame, int x, int y) {
  return {double(frame.motion.at(x, y, 0)), double(frame.motion.at(x, y, 1))};
}

std::vector<Moving> movingSurfaces(const Context& context) {
  const Camera& camera = context.now.camera;
  std::vector<Moving> all;
  for (const Surface& surface : context.surfaces()) {
    const auto then = project(camera.worldToClipPrev, surface.position, context.size);
    const auto here = project(camera.worldToClip, surface.position, context.size);
    const glm::dvec2 given = motionAt(context.now, surface.x, surface.y);
    if (!then || !here || !std::isfinite(given.x + given.y)) continue;
    if (glm::length(*then - *here) > kMovingPx) all.push_back({given, *then - *here, surface.x, surface.y});
  }
  return all;
}

std::vector<double> errors(const std::vector<Moving>& moving, const glm::dvec2& factor) {
  std::vector<double> all;
  all.reserve(moving.size());
  for (const Moving& m : moving) all.push_back(glm::length(factor * m.given - m.expected));
  return all;
}

struct Reading {
  std::string is;
  glm::dvec2 factor;  ///< takes what is given to pixels, previous minus current, y down
  std::string kind;   ///< what --channels calls it (host/io/motion_kind.hpp), empty: nothing
};

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "/" + b;
}

std::vector<Reading> readings(Size size) {
  const Reading units[] = {{"", {1.0, 1.0}, ""},
                           {", as shares of the image", {size.width, size.height}, "uv"},
                           {", in NDC", {0.5 * size.width, 0.5 * size.height}, "ndc"}};
  const Reading signs[] = {{"previous minus current", {1.0, 1.0}, ""},
                           {"previous minus current, y up", {1.0, -1.0}, "y-up"},
                           {"current minus previous", {-1.0, -1.0}, "from-previous"},
                           {"current minus previous, y up", {-1.0, 1.0}, "y-up/from-previous"}};
  std::vector<Reading> all;
  for (const Reading& unit : units)
    for (const Reading& sign : signs)
      all.push_back({sign.is + unit.is, unit.factor * sign.factor, joined(unit.kind, sign.kind)});
  return all;
}

std::string cureOf(const Reading& reading) {
  const std::string multiply =
      "multiply x by " + fixed(reading.factor.x, 2) + ", y by " + fixed(reading.factor.y, 2);
  return reading.kind.empty() ? multiply
                              : multiply + "; of files, --channels motion=NAME:" + reading.kind + " does it";
}

std::string expectedText() { return "motion in pixels, x right, y down, previous minus current"; }

/// How long vectors are as a multiple of what they should be, where they point the same way.
double lengthRatio(const std::vector<Moving>& moving) {
  std::vector<double> ratios;
  for (const Moving& m : moving)
    ratios.push_back(glm::dot(m.given, m.expected) / glm::dot(m.expected, m.expected));
  return median(std::move(ratios));
}

/// True if a finding explains the vectors.
bool explain(const Context& context, const std::vector<Moving>& moving, double given, std::size_t pixels,
             Result& result) {
  std::vector<double> lengths;
  for (const Moving& m : moving) lengths.push_back(glm::length(m.given));
  if (median(std::move(lengths)) < kNoMotionPx) {
    const double ratio = lengthRatio(moving);
    if (!(std::abs(ratio) > 1e-5)) {
      result.add({"motion-zero", Severity::Wrong, "motion", expectedText(),
                  "none, though surfaces move by " + fixed(given, 2) + " px with the camera (median)",
                  "include the camera's motion in the vectors, or leave them out: the matrices then serve",
                  pixels});
      return true;
    }
  }
  std::vector<Reading> all = readings(context.size);
  const double ratio = lengthRatio(moving);
  if (std::isfinite(1.0 / ratio))
    all.push_back(
        {fixed(std::abs(ratio), 3) + " times as long as they should be", glm::dvec2(1.0 / ratio), ""});
  for (const Reading& reading : all) {
    const double error = median(errors(moving, reading.factor));
    if (!(error < kMuchBetter * given && error < kSamePx)) continue;
    result.add({"motion-convention", Severity::Wrong, "motion", expectedText(),
                fixed(given, 2) + " px from where the matrices lead (median); " + fixed(error, 2) +
                    " px read as " + reading.is,
                cureOf(reading), pixels});
    return true;
  }
  return false;
}

void motion(const Context& context, Result& result) {
  if (!context.now.motion.present() || !result.geometryFits || !result.previousCameraFits) return;
  const std::vector<Moving> moving = movingSurfaces(context);
  if (moving.size() < kLeastSurfaces) return;
  const std::vector<double> distances = errors(moving, {1.0, 1.0});
  const double given = median(distances);
  result.figures.push_back({"distance of motion vectors from what the matrices say, median", given, "px"});
  if (!(given > kSamePx)) return;
  std::size_t off = 0;
  for (const double distance : distances) off += !(distance <= kSamePx);
  if (explain(context, moving, given, off * context.pixelsEach(), result)) return;
  if (double(distances.size() - off) > kAgreeingShare * double(distances.size()))
    return;  // the rest moves by itself
  result.add({"motion-mismatch", Severity::Doubtful, "motion", expectedText(),
              fixed(given, 2) + " px from where the matrices lead (median), for nearly all that is seen",
              "compare one vector with the projections of its position by both matrices; without vectors the "
              "matrices serve",
              off * context.pixelsEach()});
}

/// Object ids that tell nothing apart though objects move: what they uncover keeps the history of what was before it.
void objectIds(const Context& context, Result& result) {
  const Frame& frame = context.now;
  if (!frame.motion.present() || !frame.objectId.present() || !result.geometryFits ||
      !result.previousCameraFits)
    return;
  std::size_t apart = 0;
  bool several = false;
  const auto& surfaces = context.surfaces();
  for (const Surface& surface : surfaces) {
    several = several || frame.objectId.at(surface.x, surface.y, 0) !=
                             frame.objectId.at(surfaces.front().x, surfaces.front().y, 0);
    const auto then = project(frame.camera.worldToClipPrev, surface.position, context.size);
    const auto here = project(frame.camera.worldToClip, surface.position, context.size);
    apart += then && here && glm::length(motionAt(frame, surface.x, surface.y) - (*then - *here)) > kMovingPx;
  }
  if (several || !(double(apart) > 0.005 * double(surfaces.size()))) return;
  result.add({"object-ids-alike", Severity::Doubtful, "objectId", "a number of its own for every object",
              "one number for all surfaces, though some move by themselves",
              "give ids (Blender: Object Properties > Relations > Pass Index), or leave the image out",
              apart * context.pixelsEach()});
}

}  // namespace

const Group& motionChecks() {
  static const Group group = {motion, objectIds};
  return group;
}

}  // namespace quell::check
