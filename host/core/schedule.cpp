#include "host/core/schedule.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/core/imported_images.hpp"
#include "host/core/round_up.hpp"
#include "host/core/stage.hpp"

namespace quell {
namespace {

/// Resolves one row after the other.
class Planner {
 public:
  explicit Planner(const Configuration& configuration) : m_configuration(configuration) {}

  void add(const StageRow& row) {
    m_name = row.stage->label();
    std::vector<Binding> bindings;
    for (const Port& port : row.stage->ports(m_configuration)) bindings.push_back({port, -1});
    for (const Wire& wire : row.wires) checkWire(wire, bindings);
    for (Binding& binding : bindings) {
      if (isImportedPort(binding.port)) {
        binding.port.extent = importedExtent(m_configuration.frame, binding.port.input);
        bind(binding, importedBuffer(binding.port.name));
      } else if (binding.port.exists && !binding.port.isImage()) {
        bind(binding, bufferOf(binding.port, row.wires));
      }
    }
    checkAliases(bindings);
    // What the row writes may be read from the next row on.
    for (const Binding& binding : bindings)
      if (binding.hasBuffer() && binding.port.writes())
        m_written[static_cast<std::size_t>(binding.buffer)] = true;
    m_plan.rows.push_back(std::move(bindings));
  }

  Plan finish() {
    for (std::size_t i = 0; i < m_plan.buffers.size(); ++i)
      if (!m_written[i]) refuse(m_plan.buffers[i].name, "a stage that writes the buffer", "none");
    return std::move(m_plan);
  }

 private:
  [[noreturn]] void refuse(const std::string& port, const std::string& expected,
                           const std::string& got) const {
    throw std::logic_error("the method's table, stage " + m_name + ", " + port + ": expected " + expected +
                           ", got " + got);
  }

  bool isImportedPort(const Port& port) const {
    return port.exists && port.input != nullptr && !port.asGiven &&
           isImported(m_configuration.frame, port.input);
  }

  static std::string bufferOf(const Port& port, const std::vector<Wire>& wires) {
    for (const Wire& wire : wires)
      if (wire.port == port.name) return wire.buffer;
    return port.usualBuffer();
  }

  void checkWire(const Wire& wire, const std::vector<Binding>& bindings) const {
    std::string names;
    for (const Binding& binding : bindings) {
      if (binding.port.isImage()) continue;
      if (binding.port.name == wire.port) return;
      names += (names.empty() ? "" : ", ") + std::string(binding.port.name);
    }
    refuse("port " + wire.port, "one of " + names, "a wire of an unknown port");
  }

  void bind(Binding& binding, const std::string& buffer) {
    const Port& port = binding.port;
    if (port.access == Access::Table) {
      if (m_configuration.tables.count(port.name) == 0)
        refuse(std::string("port ") + port.name, "a table that the runtime provides", "none");
      return;
    }
    const int row = static_cast<int>(m_plan.rows.size());
    binding.buffer = m_plan.find(buffer);
    if (binding.buffer < 0) {
      binding.buffer = static_cast<int>(m_plan.buffers.size());
      m_plan.buffers.push_back({buffer, port.element, port.extent, false, row, row});
      m_written.push_back(false);
      m_firstStage.push_back(m_name);
    }
    const auto index = static_cast<std::size_t>(binding.buffer);
    BufferSpec& spec = m_plan.buffers[index];
    if (spec.element != port.element || !(spec.extent == port.extent))
      refuse(std::string("port ") + port.name,
             toString(spec.extent) + " of " + toString(spec.element) + " in the buffer " + buffer +
                 ", as stage " + m_firstStage[index] + " has it",
             toString(port.extent) + " of " + toString(port.element));
    const bool readsThisFrame = port.access == Access::Read || port.access == Access::Update;
    if (readsThisFrame && !m_written[index])
      refuse(std::string("port ") + port.name, "an earlier stage that writes the buffer " + buffer, "none");
    spec.history = spec.history || port.access == Access::Previous;
    spec.lastRow = row;
  }

  // The work-items of a kernel run in any order: none may read what another one writes.
  void checkAliases(const std::vector<Binding>& bindings) const {
    for (const Binding& a : bindings)
      for (const Binding& b : bindings)
        if (&a != &b && a.hasBuffer() && a.buffer == b.buffer && a.port.writes() &&
            b.port.access != Access::Previous)
          refuse(std::string("port ") + a.port.name, "a buffer of its own",
                 "that of the port " + std::string(b.port.name));
  }

  const Configuration& m_configuration;
  Plan m_plan;
  std::vector<bool> m_written;            // per buffer
  std::vector<std::string> m_firstStage;  // per buffer
  std::string m_name;
};

}  // namespace

int Plan::find(const std::string& name) const {
  const auto found =
      std::find_if(buffers.begin(), buffers.end(), [&](const BufferSpec& spec) { return spec.name == name; });
  return found == buffers.end() ? -1 : static_cast<int>(found - buffers.begin());
}

int Plan::require(const std::string& name, const char* function, const char* argument) const {
  const int index = find(name);
  if (index >= 0) return index;
  std::string names;
  for (const BufferSpec& spec : buffers) names += (names.empty() ? "" : ", ") + spec.name;
  throw Error(ErrorCode::InvalidArgument, {function, argument, "one of " + names, name});
}

bool operator==(const Plan& a, const Plan& b) {
  const auto sameBuffer = [](const BufferSpec& x, const BufferSpec& y) {
    return x.name == y.name && x.element == y.element && x.extent == y.extent && x.history == y.history &&
           x.firstRow == y.firstRow && x.lastRow == y.lastRow;
  };
  const auto sameBinding = [](const Binding& x, const Binding& y) {
    return x.buffer == y.buffer && x.port.exists == y.port.exists && x.port.access == y.port.access;
  };
  const auto sameRow = [&](const std::vector<Binding>& x, const std::vector<Binding>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), sameBinding);
  };
  return std::equal(a.buffers.begin(), a.buffers.end(), b.buffers.begin(), b.buffers.end(), sameBuffer) &&
         std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(), sameRow);
}

Plan makePlan(const Schedule& schedule, const Configuration& configuration) {
  Planner planner(configuration);
  for (const StageRow& row : schedule) planner.add(row);
  return planner.finish();
}

std::array<std::size_t, 2> pixelItems(const Configuration& configuration) {
  const std::size_t lanes = static_cast<std::size_t>(configuration.device.lanes);
  const std::size_t width = static_cast<std::size_t>(configuration.size().width);
  return {(width + lanes - 1) / lanes, static_cast<std::size_t>(configuration.size().height)};
}

int surfaceItemCount(const Configuration& configuration) {
  const auto [columns, rows] = pixelItems(configuration);
  return static_cast<int>(columns * rows);
}

PlaneParams makePlanes(Size size) {
  PlaneParams planes;
  planes.width = size.width;
  planes.height = size.height;
  planes.pitch = roundUp(size.width, QUELL_PLANE_MARGIN) + 2 * QUELL_PLANE_MARGIN;
  planes.stride = planes.pitch * (size.height + 2 * QUELL_PLANE_MARGIN_ROWS);
  return planes;
}

std::size_t elementCount(const BufferSpec& spec, Size size) {
  if (spec.extent.planes == 0) return spec.extent.elements;
  return static_cast<std::size_t>(makePlanes(size).stride) * static_cast<std::size_t>(spec.extent.planes);
}

}  // namespace quell
