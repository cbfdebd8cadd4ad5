// The grid of tiles of kernels/common/tiles.h.
#pragma once

#include <array>
#include <cstddef>
#include <quell/image_view.hpp>

namespace quell {

/// Tiles that cover so many pixels of a row or column.
int tilesAlong(int pixels);
/// Tiles of an image, all signals together.
int tileCount(Size size, int signals);
/// Work-items of a kernel that takes one a tile.
std::array<std::size_t, 2> tileRange(Size size);

}  // namespace quell
