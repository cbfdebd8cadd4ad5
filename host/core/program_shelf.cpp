#include "host/core/program_shelf.hpp"

#include <algorithm>
#include <utility>

namespace quell {

SharedProgram ProgramShelf::find(const KernelUse& use) const {
  const auto found = m_programs.find(use);
  return found == m_programs.end() ? nullptr : found->second;
}

void ProgramShelf::put(const ProgramGroup& group, const SharedProgram& program) {
  for (const KernelUse& use : group.kernels) m_programs[use] = program;
}

void ProgramShelf::expect(const std::vector<KernelUse>& uses) {
  std::map<KernelUse, SharedProgram> kept;
  std::vector<KernelUse> missing;
  for (const KernelUse& use : uses) {
    if (SharedProgram program = find(use))
      kept[use] = std::move(program);
    else
      missing.push_back(use);
  }
  m_programs = std::move(kept);
  m_expected = groupKernels(missing);
}

ProgramGroup ProgramShelf::groupOf(const KernelUse& use) const {
  for (const ProgramGroup& group : m_expected)
    if (std::find(group.kernels.begin(), group.kernels.end(), use) != group.kernels.end()) return group;
  return {{use}};
}

}  // namespace quell
