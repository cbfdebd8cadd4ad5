// atrous: edge-avoiding a-trous wavelets, Dammertz et al. 2010.
#pragma once

#include "host/methods/method.hpp"

namespace quell {

Method atrousMethod();

}  // namespace quell
