// bmfr: Blockwise Multi-Order Feature Regression, Koskela et al. 2019.
#pragma once

#include "host/methods/method.hpp"

namespace quell {

Method bmfrMethod();

}  // namespace quell
