// Holes of background in the inputs of a stage that has the port `surfaces`: what it leaves out, what others leave in such
// pixels and what it has to leave there itself, as kernels/common/surfaces.h has it.
#pragma once

#include <map>
#include <optional>

#include "tests/support/comparison.hpp"
#include "tests/support/stage_harness.hpp"

namespace quell::tests {

class Holes {
 public:
  /// Background is what the test scene with holes shows no surface in.
  explicit Holes(const StageHarness& harness);

  /// Pixels of work-items without a surface, if the stage leaves them out; 1 plane. Null: it leaves out none.
  const BasicPlanes<char>* leftOut() const { return m_leavesOut ? &m_leftOut : nullptr; }
  /// Sets what has no value there to 0.
  void clear(Planes& planes) const;

  /// After upload(): gives the stage its `surfaces` and, in what is left out, values of other pixels where nothing is
  /// promised about earlier frames; keeps what outputs hold.
  void dig(StageHarness& harness);
  /// After run(): `surfaces` if the stage finds them, and what is left out holds what it held or what is promised.
  void compare(Comparison& comparison, const StageHarness& harness, float cameraDepth) const;

  /// Whether variances of background next to surfaces are set to 0.
  bool zeroesVariance = true;

 private:
  bool isNearSurface(int x, int y) const;
  /// Where the frame before left out background, for a stage that finds it.
  BasicPlanes<char> leftOutBefore(const StageHarness& harness) const;
  bool isKept(const std::string& port, int plane, int x, int y) const;
  void spoil(StageHarness& harness, const std::string& port, const BasicPlanes<char>& where) const;
  std::optional<float> promised(const std::string& port, int plane, int x, int y, float cameraDepth) const;

  Size m_size;
  int m_lanes = 1;
  bool m_finds = false;  // background, instead of being told
  bool m_leavesOut = false;
  bool m_jittered = false;
  bool m_motion = false;
  Planes m_surfaces;               // 1 in work-items with a surface
  BasicPlanes<char> m_background;  // pixels of the others
  BasicPlanes<char> m_leftOut;     // those of them that the stage leaves out
  std::map<std::string, Planes> m_before;
  std::map<std::string, io::Image> m_imagesBefore;
};

}  // namespace quell::tests
