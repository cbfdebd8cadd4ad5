#include "host/core/bound_kernel.hpp"

#include <cstring>

namespace quell {

void BoundKernel::bind(const std::vector<Argument>& arguments, const void* params, std::size_t size) {
  m_bound.resize(arguments.size());
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Argument& argument = arguments[i];
    if (argument.own && m_bound[i] == argument.memory) continue;
    m_kernel.setArg(static_cast<cl_uint>(i), sizeof(cl_mem), &argument.memory);
    m_bound[i] = argument.own ? std::optional(argument.memory) : std::nullopt;
  }
  if (m_params.size() == size && std::memcmp(m_params.data(), params, size) == 0) return;
  m_kernel.setArg(static_cast<cl_uint>(arguments.size()), size, params);
  const auto* bytes = static_cast<const unsigned char*>(params);
  m_params.assign(bytes, bytes + size);
}

}  // namespace quell
