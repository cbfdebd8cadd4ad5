// What the columns of kernels/<stem>_ports.h mean on the host. For the source file of a stage alone, as its last include:
// the names are short.
#pragma once

#include "host/core/ports.hpp"
#include "host/core/schedule.hpp"

#define QUELL_ACCESS_READ Access::Read
#define QUELL_ACCESS_PREVIOUS Access::Previous
#define QUELL_ACCESS_WRITE Access::Write
#define QUELL_ACCESS_UPDATE Access::Update
#define QUELL_ACCESS_SCRATCH Access::Scratch
#define QUELL_ACCESS_TABLE Access::Table

#define QUELL_ELEMENT_FLOAT Element::Float32
#define QUELL_ELEMENT_HALF Element::Float16
#define QUELL_ELEMENT_UCHAR Element::UInt8
#define QUELL_ELEMENT_INT Element::Int32
#define QUELL_ELEMENT_FLOAT4 Element::Float32x4

#define RECORDS(count) Extent::records(static_cast<std::size_t>(count))

#define ALL 1.0
#define PLANES(count) (static_cast<double>(count) / extentPlanes)
#define ELEMENTS(count) (static_cast<double>(count) / static_cast<double>(port.extent.elements))
#define SURFACES content.surfaces
#define HISTORIES (content.frames > 1 ? content.histories : 0.0)
#define SHORT_HISTORIES (content.frames < temporalFrames ? 1.0 : content.shortHistories)
#define CHANGED content.changed
#define NEAR_SURFACES content.nearSurfaces
#define WHERE_REPROJECTED (antialiasBackground != 0 ? 1.0 : content.surfaces)
#define LOOKED_UP 0.0

#define ALWAYS true
#define HAS(image) configuration.frame.image.present()

#define QUELL_HOST_PORT(portName, portAccess, portElement, portExtent, portTouched, when) \
  {                                                                                       \
    Port port;                                                                            \
    port.name = #portName;                                                                \
    port.access = QUELL_ACCESS_##portAccess;                                              \
    port.element = QUELL_ELEMENT_##portElement;                                           \
    port.extent = portExtent;                                                             \
    [[maybe_unused]] const double extentPlanes = static_cast<double>(port.extent.planes); \
    port.touched = static_cast<double>(portTouched);                                      \
    port.exists = (when);                                                                 \
    ports.push_back(port);                                                                \
  }
#define QUELL_HOST_IMAGE(portName, NAME, share, when) \
  {                                                   \
    Port port;                                        \
    port.name = #portName;                            \
    port.options = #NAME;                             \
    port.input = &Frame::portName;                    \
    port.touched = static_cast<double>(share);        \
    port.exists = (when) && HAS(portName);            \
    ports.push_back(port);                            \
  }
#define QUELL_HOST_OUTPUT(portName, NAME, share, when)               \
  {                                                                  \
    Port port;                                                       \
    port.name = #portName;                                           \
    port.access = Access::Write;                                     \
    port.options = #NAME;                                            \
    port.output = &Output::portName;                                 \
    port.touched = static_cast<double>(share);                       \
    port.exists = (when) && configuration.output.portName.present(); \
    ports.push_back(port);                                           \
  }

#define QUELL_OPTION_DEFINE(name) text += " -D " #name "=" + std::to_string(name);
#define QUELL_SIZE_DEFINE(name)

#define QUELL_PORTS(Type, STEM)                                                          \
  std::string Type::defines() const {                                                    \
    std::string text;                                                                    \
    STEM##_OPTIONS(QUELL_OPTION_DEFINE, QUELL_SIZE_DEFINE) return text;                  \
  }                                                                                      \
  std::vector<Port> Type::makePorts([[maybe_unused]] const Configuration& configuration, \
                                    [[maybe_unused]] const Content& content) const {     \
    std::vector<Port> ports;                                                             \
    STEM##_PORTS(QUELL_HOST_PORT, QUELL_HOST_IMAGE, QUELL_HOST_OUTPUT) return ports;     \
  }
