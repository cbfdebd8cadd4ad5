// Normals that a renderer wrote in another way than the contract says (quell/frame_images.h).
#pragma once

#include <optional>
#include <string>

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Says so if the normals are packed to 0..1, or of length 0 where light falls on a surface. `file` is where they come
/// from. Nothing for normals in order, of whatever length.
std::optional<io::FrameWarning> checkNormals(const io::FrameData& frame, const std::string& file);

}  // namespace quell::cli
