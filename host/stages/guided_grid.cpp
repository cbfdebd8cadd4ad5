#include "host/stages/guided_grid.hpp"

namespace quell {

Size guidedCells(Size size, int subsampling) { return cellsCovering(size, {subsampling, subsampling}); }

GuidedParams makeGuidedParams(Size size, int subsampling, double epsilon) {
  GuidedParams params{};
  params.planes = makePlanes(size);
  params.cells = makePlanes(guidedCells(size, subsampling));
  params.epsilon = static_cast<float>(epsilon);
  return params;
}

}  // namespace quell
