// A stage that is nothing but a name and ports, for tests of what the runtime makes of them.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/core/stage.hpp"

namespace quell::tests {

class FakeStage : public Stage {
 public:
  FakeStage(std::string name, std::vector<Port> ports) : m_name(std::move(name)), m_ports(std::move(ports)) {}
  std::string name() const override { return m_name; }
  std::vector<Port> ports(const Configuration&, const Content&) const override { return m_ports; }
  void build(const KernelBuilder&) override {}
  void enqueue(FrameRun&) override {}

 private:
  std::string m_name;
  std::vector<Port> m_ports;
};

inline Port fakePort(const char* name, Access access, Extent extent = 1, Element element = Element::Float32) {
  Port port;
  port.name = name;
  port.access = access;
  port.extent = extent;
  port.element = element;
  return port;
}

inline StageRow fakeRow(const std::string& name, std::vector<Port> ports, std::vector<Wire> wires = {}) {
  return {std::make_unique<FakeStage>(name, std::move(ports)), std::move(wires)};
}

}  // namespace quell::tests
