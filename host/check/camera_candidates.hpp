// What positions and matrices may be instead of what the contract says.
#pragma once

#include <optional>
#include <vector>

#include "host/check/context.hpp"

namespace quell::check {

/// Another reading of position and camera, as a matrix that takes positions as they are given to clip space.
struct CameraCandidate {
  const char* kind;   ///< of the finding
  const char* image;  ///< what is wrong
  const char* is;     ///< "the matrices are transposed"
  const char* cure;
  std::optional<Matrix4> (*matrix)(const Context&);
};

/// All that are known; simple ones first, since the first of equals wins.
const std::vector<CameraCandidate>& cameraCandidates();

}  // namespace quell::check
