#include "host/stages/box_filter.hpp"

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
  const int lanes = run.configuration.device.lanes;
  return {static_cast<std::size_t>((m_setup.grid.width + lanes - 1) / lanes),
          static_cast<std::size_t>(m_setup.grid.height * m_setup.planes)};
}

}  // namespace quell
