// What all checks of a frame share: its surfaces, and what earlier checks have found.
#pragma once

#include <functional>
#include <quell/check.hpp>
#include <string>
#include <vector>

#include "host/check/frame.hpp"
#include "host/check/view.hpp"

namespace quell::check {

/// Pixel by pixel, in [0, 1], of a regular grid of pixels (all of them in small frames); what a finding's picture shows.
struct Map {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

struct MappedFinding {
  Finding finding;
  Map map;  ///< empty where the finding is about the frame as a whole
};

struct Result {
  std::vector<CheckFigure> figures;
  std::vector<MappedFinding> findings;
  // What later checks build on.
  bool geometryFits = true;        ///< positions lie where the camera of this frame says
  bool previousCameraFits = true;  ///< and that of the frame before is the one it had
  bool normalsFit = true;          ///< directions in world space
  bool radianceFits = true;        ///< light of this frame alone

  void add(Finding finding, Map map = {}) { findings.push_back({std::move(finding), std::move(map)}); }
};

/// A pixel that shows a surface.
struct Surface {
  int x, y;
  glm::dvec3 position;
  glm::dvec3 normal;  ///< of any length above 0
};

class Context {
 public:
  /// `before`: the frame right before, or null. Both outlive this.
  Context(const Frame& now, const Frame* before);

  const Frame& now;
  const Frame* const before;
  const Size size;
  const std::optional<View> view;  ///< of this frame's camera

  /// Surfaces of the grid. Where there is no position they follow from view depth.
  const std::vector<Surface>& surfaces() const { return m_surfaces; }
  /// Pixels that one pixel of the grid stands for.
  std::size_t pixelsEach() const { return std::size_t(m_step) * std::size_t(m_step); }

  /// Position of a surface in this frame or the one before; NaN where there is none.
  glm::dvec3 positionAt(int x, int y) const;
  glm::dvec3 positionBefore(int x, int y) const;

  /// `value` at each pixel of the grid.
  Map mapOf(const std::function<double(int x, int y)>& value) const;
  /// The same where there are surfaces, of the same order as surfaces(), 0 elsewhere.
  Map mapOf(const std::vector<double>& ofSurfaces) const;

  /// Runs work(x, y) for each pixel of the grid.
  template <class Work>
  void forEach(const Work& work) const {
    for (int y = m_step / 2; y < size.height; y += m_step)
      for (int x = m_step / 2; x < size.width; x += m_step) work(x, y);
  }

 private:
  const int m_step;
  const std::optional<View> m_viewBefore;
  std::vector<Surface> m_surfaces;
};

/// Position along the ray of a pixel at this view depth; `view` belongs to the camera. NaN for what is not in front.
glm::dvec3 positionFromDepth(const Camera& camera, const View& view, Size size, int x, int y, double depth);

/// Fewer surfaces than this prove nothing.
constexpr std::size_t kLeastSurfaces = 64;

/// The middle value, NaN of none; infinite ones count as large.
double median(std::vector<double> values);

/// "12.3", with so many digits behind the point; and "12.3 %" of a share.
std::string fixed(double value, int digits);
std::string percent(double share);

}  // namespace quell::check
