// How a file has its motion vectors, and those of the contract from them.
#pragma once

#include <string>

#include "host/io/image.hpp"

namespace quell::io {

/// By default as quell/frame_images.h has them: pixels, y down, from this frame's place to that of the frame before.
struct MotionKind {
  enum class Unit {
    Px,
    Ndc,  ///< 2 is the width, and the height, of the picture
    Uv    ///< 1 is the width, and the height, of the picture
  };
  Unit unit = Unit::Px;
  bool yUp = false;
  bool fromPrevious = false;  ///< this frame's place minus that of the frame before
};

/// Words with '/' between them, as in --channels motion=NAME:uv/y-up: "px", "ndc" or "uv"; "y-down" or "y-up"; "to-previous"
/// or "from-previous". Throws Error(InvalidArgument) that lists them.
MotionKind parseMotionKind(const std::string& text);
/// The words that differ from the default; empty for the default.
std::string toString(const MotionKind& kind);

/// Turns vectors of this kind (2 channels) of a picture of so many pixels to those of the contract.
void toContract(Image& motion, const MotionKind& kind, int pictureWidth, int pictureHeight);

}  // namespace quell::io
