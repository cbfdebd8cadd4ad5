#include "host/stages/box_filter.hpp"

#include "host/stages/cell_sizes.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(BoxFilterOptions, BOX_FILTER)

BoxFilter::BoxFilter(const Setup& setup) : m_setup(setup) {
  BOX_MINIMA = setup.minima ? 1 : 0;
  boxFloats = makePlanes(setup.grid).stride * setup.planes;
  boxElements = setup.grid.width * setup.grid.height * setup.planes;
}

std::string BoxFilter::label() const {
  return name() + " (" + m_setup.what + (m_setup.alongRows ? ", rows)" : ", columns)");
}

BoxFilterParams BoxFilter::params(const FrameRun&) const {
  return {makePlanes(m_setup.grid), m_setup.planes, m_setup.radius, m_setup.alongRows ? 1 : 0};
}

std::array<std::size_t, 2> BoxFilter::range(const FrameRun& run) const {
  std::array<std::size_t, 2> items = cellItems(m_setup.grid, run.configuration.device.lanes);
  items[1] *= static_cast<std::size_t>(m_setup.planes);
  return items;
}

}  // namespace quell
