#include "tests/cases/holes.hpp"

#include <algorithm>
#include <limits>

#include "host/core/frame_images.hpp"
#include "kernels/common/guides.h"
#include "tests/cases/surface_items.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

// Every plane of a buffer at this pixel.
template <class Work>
void forEachPlane(const Planes& planes, Work&& work) {
  for (int plane = 0; plane < planes.count; ++plane)
    forEachPixel(planes.size(), [&](int x, int y) { work(plane, x, y); });
}

bool isGuides(const std::string& port) { return port == "guides" || port == "guidesPrev"; }

// The next pixel, in the order of rows, that is not marked; the pixel itself if there is none.
std::size_t nextUnmarked(const BasicPlanes<char>& marks, std::size_t pixel) {
  const std::size_t pixels = marks.values.size();
  for (std::size_t step = 1; step < pixels; ++step)
    if (!marks.values[(pixel + step) % pixels]) return (pixel + step) % pixels;
  return pixel;
}

const Port* findSurfaces(const StageHarness& harness) {
  for (const Port& port : harness.ports())
    if (port.exists && port.name == std::string(kSurfacesBuffer)) return &port;
  return nullptr;
}

}  // namespace

Holes::Holes(const StageHarness& harness)
    : m_size(harness.size()),
      m_lanes(harness.configuration().device.lanes),
      m_background(m_size, 1),
      m_leftOut(m_size, 1) {
  const Port* port = findSurfaces(harness);
  const Frame& frame = harness.configuration().frame;
  if (port == nullptr || harness.stage().coverage(frame) == Coverage::Background) return;
  m_finds = port->access == Access::Write;
  m_leavesOut = m_finds || leavesOutBackground(harness.stage().coverage(frame));
  const bool alsoAround = harness.stage().coverage(frame) == Coverage::AroundSurfaces;
  m_jittered = isJittered(frame.camera);
  m_motion = frame.motion.present();
  m_surfaces = Planes({(m_size.width + m_lanes - 1) / m_lanes, m_size.height}, 1);
  const Planes guides = renderScene({}, m_size, 1, true).guides;
  forEachPixel(m_size, [&](int x, int y) {
    if (guides.at(QUELL_GUIDE_WEIGHT, x, y) > 0.0f) m_surfaces.at(0, x / m_lanes, y) = 1.0f;
  });
  forEachPixel(m_size, [&](int x, int y) {
    m_background.at(0, x, y) = char(!hasSurface(m_surfaces, x / m_lanes, y));
    m_leftOut.at(0, x, y) = char(m_background.at(0, x, y) && !(alsoAround && isNearSurface(x, y)));
  });
}

bool Holes::isNearSurface(int x, int y) const {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (hasSurface(m_surfaces, x / m_lanes + dx, y + dy)) return true;
  return false;
}

void Holes::clear(Planes& planes) const {
  if (!m_leavesOut) return;
  forEachPlane(planes, [&](int plane, int x, int y) {
    if (m_background.at(0, x, y)) planes.at(plane, x, y) = 0.0f;
  });
}

BasicPlanes<char> Holes::leftOutBefore(const StageHarness& harness) const {
  const bool hasHistory = harness.hasPort("guidesPrev");
  BasicPlanes<char> marks(m_size, 1, char(hasHistory));
  if (!hasHistory) return marks;
  const Planes guides = harness.download("guidesPrev");
  for (int plane = QUELL_GUIDE_NORMAL; plane < QUELL_GUIDE_NORMAL + 3; ++plane)
    forEachPixel(m_size, [&](int x, int y) {
      if (guides.at(plane, x, y) != 0.0f) marks.at(0, x, y) = 0;
    });
  return marks;
}

// What others leave in background, or what nobody writes there.
bool Holes::isKept(const std::string& port, int plane, int x, int y) const {
  if (isGuides(port))
    return plane >= QUELL_GUIDE_WEIGHT ||
           (m_motion && plane >= QUELL_GUIDE_NORMAL && plane < QUELL_GUIDE_NORMAL + 3);
  if (port == "variance") return isNearSurface(x, y);
  if (port == "beforeAntialiasing") return isSeenByAntialiasing(m_surfaces, m_lanes, x, y);
  return port == "tapWeights" || port == "viewDepth" || port == "reprojectionMask" ||
         port == "historyLength" || port == "historyLengthPrev";
}

void Holes::spoil(StageHarness& harness, const std::string& port, const BasicPlanes<char>& where) const {
  const Planes planes = harness.download(port);
  Planes spoilt = planes;
  const std::size_t pixels = where.values.size();
  forEachPlane(planes, [&](int plane, int x, int y) {
    if (!where.at(0, x, y) || isKept(port, plane, x, y)) return;
    const std::size_t other = nextUnmarked(where, where.index(0, x, y));
    spoilt.at(plane, x, y) = planes.values[std::size_t(plane) * pixels + other];
  });
  harness.upload(port, spoilt);
}

void Holes::dig(StageHarness& harness) {
  if (m_surfaces.count == 0) return;
  if (!m_finds) harness.upload(kSurfacesBuffer, m_surfaces);
  if (!m_leavesOut) return;
  const BasicPlanes<char> before = m_finds ? leftOutBefore(harness) : BasicPlanes<char>();
  for (const Port& port : harness.ports()) {
    if (!port.exists) continue;
    if (port.output != nullptr) m_imagesBefore[port.name] = harness.output(port.output);
    if (port.isImage() || port.extent.planes == 0) continue;
    if (m_finds && port.access == Access::Previous) spoil(harness, port.name, before);
    if (port.access == Access::Read || port.access == Access::Update) spoil(harness, port.name, m_background);
    if (port.writes()) m_before[port.name] = harness.download(port.name);
  }
}

// Nothing: what it held before, or what the case compares with its oracle.
std::optional<float> Holes::promised(const std::string& port, int plane, int x, int y,
                                     float cameraDepth) const {
  if (m_finds && isGuides(port) && isKept(port, plane, x, y)) return 0.0f;
  if (m_finds && port == "historyLength") return 0.0f;
  if (m_finds && port == "viewDepth") return cameraDepth;
  if (port == "tapWeights") return 0.0f;
  const bool ofVariance = port == "variance" || port == "filteredVariance";
  if (ofVariance && zeroesVariance && isNearSurface(x, y)) return 0.0f;
  return std::nullopt;
}

void Holes::compare(Comparison& comparison, const StageHarness& harness, float cameraDepth) const {
  const auto expectSame = [&](const std::string& what, int plane, int x, int y, float device, float wanted) {
    comparison.include(what + " of background, wanted " + std::to_string(wanted), plane, x, y, 0.0,
                       device == wanted ? 0.0 : std::numeric_limits<double>::infinity());
  };
  if (m_finds) {
    const Planes found = harness.download(kSurfacesBuffer);
    for (std::size_t i = 0; i < found.values.size(); ++i)
      expectSame("surfaces", 0, int(i), 0, found.values[i], m_surfaces.values[i]);
  }
  for (const auto& [name, before] : m_before) {
    if (m_finds && m_jittered && (name == "pixelPrev" || name == "reprojectionMask")) continue;
    const Planes after = harness.download(name);
    forEachPlane(after, [&, &name = name, &before = before](int plane, int x, int y) {
      if (m_leftOut.at(0, x, y))
        expectSame(name, plane, x, y, after.at(plane, x, y),
                   promised(name, plane, x, y, cameraDepth).value_or(before.at(plane, x, y)));
    });
  }
  for (const Port& port : harness.ports()) {
    const auto before = m_imagesBefore.find(port.name);
    if (port.output == nullptr || before == m_imagesBefore.end()) continue;
    const io::Image after = harness.output(port.output);
    forEachPixel(m_size, [&](int x, int y) {
      for (int c = 0; c < after.channels; ++c)
        if (m_leftOut.at(0, x, y))
          expectSame(port.name, c, x, y, after.at(x, y, c), before->second.at(x, y, c));
    });
  }
}

}  // namespace quell::tests
