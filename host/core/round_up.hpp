// Multiples.
#pragma once

namespace quell {

/// The least multiple of `multiple` (>= 1) that is at least `value` (>= 0); whole numbers of one type.
template <class Number>
constexpr Number roundUp(Number value, Number multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

}  // namespace quell
