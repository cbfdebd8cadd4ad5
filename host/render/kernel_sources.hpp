// Kernels of the path tracer: stem of kernels/render/<stem>.cl -> source with its includes inlined.
#pragma once

#include <map>
#include <string>

namespace quell {

const std::map<std::string, std::string>& renderKernelSources();

}  // namespace quell
