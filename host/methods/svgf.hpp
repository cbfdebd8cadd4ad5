// svgf: Spatiotemporal Variance-Guided Filtering, Schied et al. 2017.
#pragma once

#include "host/methods/method.hpp"

namespace quell {

Method svgfMethod();

}  // namespace quell
