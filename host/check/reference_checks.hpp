// Whether the converged renderings of a frame can measure it.
#pragma once

#include <vector>

#include "host/check/context.hpp"

namespace quell::check {

/// `noisy`: light as a whole, of the same frame; `b` may be absent. All have 3 channels and one size.
std::vector<Finding> checkReference(const Image& noisy, const Image& a, const Image& b);

}  // namespace quell::check
