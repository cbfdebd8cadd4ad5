// Images that are not there and would lower the error.
#include <algorithm>

#include "host/check/checks.hpp"

namespace quell::check {
namespace {

void absentAlbedo(const Context& context, Result& result) {
  if (context.now.albedo.present() || context.now.glossColor.present() || context.now.demodulated) return;
  result.add({"no-albedo", Severity::Note, "albedo", "reflectance of surfaces", "none",
              "the frame is denoised without, but textures blur; give it if the renderer can", 0});
}

/// Much of the picture has no history: something moves by itself, which vectors would follow.
void absentMotion(const Context& context, Result& result) {
  constexpr double kMuchLost = 80.0;  // % found, below which it is worth a word
  if (context.now.motion.present() || context.before == nullptr || !result.previousCameraFits) return;
  for (const CheckFigure& figure : result.figures) {
    if (figure.name != kFoundBefore || figure.value >= kMuchLost) continue;
    result.add({"no-motion", Severity::Note, "motion", "motion vectors where things move",
                "none, and " + fixed(figure.value, 0) + " % of the surfaces found in the frame before",
                "if objects move, give motion vectors and object ids: they then keep their history", 0});
  }
}

void absentEmission(const Context& context, Result& result) {
  const Frame& frame = context.now;
  if (frame.emission.present() || !frame.albedo.present() || frame.demodulated) return;
  std::size_t lamps = 0;
  for (const Surface& surface : context.surfaces())
    lamps += isZero(vectorAt(frame.albedo, surface.x, surface.y)) &&
             luminanceAt(frame.radiance, surface.x, surface.y) > 0.0;
  const bool told =
      std::any_of(result.findings.begin(), result.findings.end(),
                  [](const MappedFinding& found) { return found.finding.kind == "albedo-zero"; });
  if (lamps == 0 || told) return;
  result.add({"no-emission", Severity::Note, "emission", "emitted light where surfaces shine", "none",
              "if those with albedo 0 are lamps, give their light as emission: it then stays sharp",
              lamps * context.pixelsEach()});
}

}  // namespace

const Group& absentChecks() {
  static const Group group = {absentAlbedo, absentMotion, absentEmission};
  return group;
}

}  // namespace quell::check
