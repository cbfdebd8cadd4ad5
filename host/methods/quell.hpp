// quell: history that follows changes of light, then a filter guided by its variance.
#pragma once

#include "host/methods/method.hpp"

namespace quell {

Method quellMethod();

}  // namespace quell
