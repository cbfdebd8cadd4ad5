// With which power of albedo light goes.
#pragma once

#include <optional>

#include "host/check/context.hpp"

namespace quell::check {

struct Exponent {
  double value;          ///< 1 for linear albedo, 2.2 where it is encoded for display
  double standardError;  ///< by the spread between tiles
};

/// Estimated within tiles, where light is much the same, by Poisson regression of light on the logarithm of albedo, which
/// is unbiased for any noise whose mean is right. Glossy light makes it smaller. Nothing without
/// texture enough.
std::optional<Exponent> albedoExponent(const Context& context);

}  // namespace quell::check
