// The programs of a pipeline.
#pragma once

#include <map>
#include <vector>

#include "host/core/program_cache.hpp"
#include "host/core/program_groups.hpp"

namespace quell {

/// Programs that somebody holds, by the kernels that are taken from them.
class ProgramShelf {
 public:
  /// Null where there is none.
  SharedProgram find(const KernelUse& use) const;
  void put(const ProgramGroup& group, const SharedProgram& program);

  /// All that will be asked for: what is missing is compiled in groups, other programs go.
  void expect(const std::vector<KernelUse>& uses);
  /// What to compile for this kernel: the group that was expected, else it alone.
  ProgramGroup groupOf(const KernelUse& use) const;

 private:
  std::map<KernelUse, SharedProgram> m_programs;
  std::vector<ProgramGroup> m_expected;
};

}  // namespace quell
