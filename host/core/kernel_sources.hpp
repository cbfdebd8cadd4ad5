// Kernel sources embedded in the library: stem of kernels/<stem>.cl -> source with its includes inlined.
#pragma once

#include <map>
#include <string>

namespace quell {

const std::map<std::string, std::string>& kernelSources();

}  // namespace quell
