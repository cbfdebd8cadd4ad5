// Which kernels are compiled as one program: a compiler reads its own headers once a program, whatever that holds.
#pragma once

#include <string>
#include <tuple>
#include <vector>

namespace quell {

/// One compilation of a kernel.
struct KernelUse {
  std::string stem;     ///< the kernel function, and kernels/<stem>.cl
  std::string options;  ///< as for the compiler: flags, then "-D NAME=VALUE" each
};

inline bool operator==(const KernelUse& a, const KernelUse& b) {
  return a.stem == b.stem && a.options == b.options;
}
inline bool operator<(const KernelUse& a, const KernelUse& b) {
  return std::tie(a.stem, a.options) < std::tie(b.stem, b.options);
}

/// kernels/<stem>.cl with all that it includes.
const std::string& kernelSource(const std::string& stem);

/// Kernels of one program, each of another stem; one at least.
struct ProgramGroup {
  std::vector<KernelUse> kernels;

  /// The sources one after the other. Headers have guards; no two kernel files define the same name (scripts/lint-kernels).
  std::string source() const;
  /// The options of all kernels, each once.
  std::string options() const;
  /// The stems, for reports.
  std::string name() const;
};

/// As few groups as first fit finds, in the order of `uses`; equal uses count once. Kernels share a program if every option
/// means the same to both: given with one value, or given to one while the other does not ask whether it is (#ifdef). Those
/// with options for the layout of images stay alone: layouts change more often than settings do, and would have the others
/// compiled again.
std::vector<ProgramGroup> groupKernels(const std::vector<KernelUse>& uses);

}  // namespace quell
