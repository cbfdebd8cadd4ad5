// Runs one stage of a method on a device, with inputs and outputs in host memory.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <quell/denoiser.hpp>
#include <string>

#include "host/core/schedule.hpp"
#include "host/core/stage.hpp"
#include "host/io/image.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

/// The device that all tests of a process share: environment variable QUELL_TEST_DEVICE (index or part of a
/// name), else the one that quell::chooseDevice() prefers.
struct TestDevice {
  cl::Device device;
  cl::Context context;
  cl::CommandQueue queue;  ///< in order, with profiling
  ProgramCache cache;      ///< in memory only

  static const TestDevice& shared();
};

/// What the stage is compiled for. Image views need no memory.
struct StageSetup {
  Size size;
  Mapping mapping = Mapping::Automatic;
  std::array<int, 2> workGroup{0, 0};
  int fitGroup = 0;
  Settings settings{"bmfr"};
  Frame frame;
  Output output;
  int occurrence = 0;  ///< which of the stages of this name, from 0
  bool skip = false;   ///< setting of that name
};

/// One stage of a method with buffers of its own: it can touch no other. Margins hold finite
/// rubbish instead of zeros, since only finiteness is promised.
class StageHarness {
 public:
  /// Takes the stage `stem` from the schedule of the setup's method and compiles it.
  StageHarness(const std::string& stem, const StageSetup& setup);

  /// By the names of the stage's ports. Integers are converted from and to floats.
  void upload(const std::string& name, const Planes& planes);
  Planes download(const std::string& name) const;
  bool hasPort(const std::string& name) const;

  /// The caller's images; those of the setup must all be set before run().
  void setInput(ImageView Frame::*image, const io::Image& pixels);
  void clearOutput(ImageView Output::*image);
  std::vector<unsigned char> outputBytes(const ImageView Output::*image) const;
  io::Image output(const ImageView Output::*image) const;

  /// Runs the stage once, waits, and returns the device time of its kernels, milliseconds (wall time on
  /// runtimes without event times).
  double run(const ReprojectionParams& reprojection = {}, std::uint32_t frameIndex = 1);

  Size size() const { return m_configuration.size(); }
  const Configuration& configuration() const { return m_configuration; }
  const Stage& stage() const { return *m_stage; }
  const std::vector<Port>& ports() const { return m_ports; }
  /// Bytes that a frame of this content makes the stage touch, as it declares.
  std::uint64_t bytesMoved(const Content& content = {}) const;

 private:
  void allocate();
  const Port& port(const std::string& name) const;

  Configuration m_configuration;
  std::unique_ptr<Stage> m_stage;
  std::vector<Port> m_ports;
  std::map<std::string, cl::Buffer> m_buffers;
  std::map<std::string, cl::Buffer> m_images;  // memory behind m_frame and m_output
  Frame m_frame;
  Output m_output;
};

}  // namespace quell::tests
