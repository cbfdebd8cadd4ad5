// Host side of the stage box_filter.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/box_filter_ports.h"

namespace quell {

QUELL_OPTIONS(BoxFilterOptions, BOX_FILTER, "box_filter")

/// See kernels/box_filter.cl for what it computes and from what.
class BoxFilter : public KernelStage<BoxFilterOptions, BoxFilterParams> {
 public:
  struct Setup {
    Size grid;               ///< of each plane, elements
    int planes = 1;          ///< one after the other, each laid out as the planes of an image of that size
    int radius = 0;          ///< elements to either side, >= 0
    bool alongRows = false;  ///< neighbours in a row, else in a column
    bool minima = false;     ///< the least of them, else their sums
    std::string what;        ///< for the label
  };
  explicit BoxFilter(const Setup& setup);
  std::string label() const override;

 protected:
  BoxFilterParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;

 private:
  Setup m_setup;
};

}  // namespace quell
