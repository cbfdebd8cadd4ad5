#include "host/core/kernel_uses.hpp"

namespace quell {
namespace {

/// Writes down what it is asked for.
class RecordingKernelBuilder : public KernelBuilder {
 public:
  RecordingKernelBuilder(const Configuration& configuration, std::vector<KernelUse>& uses)
      : KernelBuilder(configuration), m_uses(uses) {}

  std::size_t maxWorkGroup(const cl::Kernel&) const override { return configuration().device.maxWorkGroup; }

 protected:
  cl::Kernel compile(const KernelUse& use) const override {
    m_uses.push_back(use);
    return {};
  }

 private:
  std::vector<KernelUse>& m_uses;
};

}  // namespace

std::vector<KernelUse> kernelUses(Stage& stage, const Configuration& configuration) {
  return kernelUses([&](const KernelBuilder& builder) { stage.build(builder); }, configuration);
}

std::vector<KernelUse> kernelUses(const std::function<void(const KernelBuilder&)>& build,
                                  const Configuration& configuration) {
  std::vector<KernelUse> uses;
  build(RecordingKernelBuilder(configuration, uses));
  return uses;
}

}  // namespace quell
