#include "tests/oracle/gram_sums_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/accumulate_noisy_params.h"

namespace quell::tests {
namespace {

// Where a number lies in the device's buffer: planes of one number per tile.
std::size_t elementOf(int plane, int tiles, int tile) {
  return std::size_t(plane) * std::size_t(tiles) + std::size_t(tile);
}

// Reflections at the image's edges; an edge pixel is followed by itself.
int mirror(int i, int size) {
  while (i < 0 || i >= size) i = i < 0 ? -1 - i : 2 * size - 1 - i;
  return i;
}

std::array<double, 3> positionAt(const GramInputs& inputs, BlockPixel pixel) {
  std::array<double, 3> position;
  for (int axis = 0; axis < 3; ++axis)
    position[std::size_t(axis)] = inputs.guides.at(QUELL_GUIDE_POSITION + axis, pixel.x, pixel.y);
  return position;
}

GramTile sumTile(const GramInputs& inputs, int number) {
  const std::vector<BlockPixel> pixels = tilePixels(inputs, number);
  GramTile tile;
  for (const BlockPixel pixel : pixels) {
    const std::array<double, 3> position = positionAt(inputs, pixel);
    tile.range.include(position, position);
  }
  const FitRecord scaling = scalingOf(tile.range);
  for (const BlockPixel pixel : pixels) addPixel(inputs, scaling, pixel, 1.0, tile.sums);
  return tile;
}

}  // namespace

PositionRange::PositionRange() {
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
}

void PositionRange::include(const std::array<double, 3>& lowest, const std::array<double, 3>& highest) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], lowest[axis]);
    high[axis] = std::max(high[axis], highest[axis]);
  }
}

std::vector<GramTile> gramSumsOracle(const GramInputs& inputs) {
  std::vector<GramTile> tiles;
  for (int tile = 0; tile < gramTileCount(inputs.params); ++tile) tiles.push_back(sumTile(inputs, tile));
  return tiles;
}

GramTile unpackTile(const Planes& tiles, const GramParams& params, int tile) {
  const auto value = [&](int plane) { return tiles.values[elementOf(plane, params.tileStride, tile)]; };
  GramTile unpacked;
  for (int a = 0; a < QUELL_FIT_COLUMNS; ++a)
    for (int b = a; b < QUELL_FIT_COLUMNS; ++b)
      unpacked.sums(a, b) = unpacked.sums(b, a) = value(QUELL_GRAM_INDEX(a, b));
  for (int axis = 0; axis < 3; ++axis) {
    unpacked.range.low[std::size_t(axis)] = value(QUELL_GRAM_LOW + axis);
    unpacked.range.high[std::size_t(axis)] = value(QUELL_GRAM_HIGH + axis);
  }
  return unpacked;
}

Planes packTiles(const std::vector<GramTile>& tiles) {
  const int count = int(tiles.size());
  Planes packed({count * QUELL_GRAM_PLANES, 1}, 1);
  for (int tile = 0; tile < count; ++tile) {
    const GramTile& from = tiles[std::size_t(tile)];
    const auto store = [&](int plane, double value) {
      packed.values[elementOf(plane, count, tile)] = float(value);
    };
    for (int a = 0; a < QUELL_FIT_COLUMNS; ++a)
      for (int b = a; b < QUELL_FIT_COLUMNS; ++b) store(QUELL_GRAM_INDEX(a, b), from.sums(a, b));
    for (int axis = 0; axis < 3; ++axis) {
      store(QUELL_GRAM_LOW + axis, from.range.low[std::size_t(axis)]);
      store(QUELL_GRAM_HIGH + axis, from.range.high[std::size_t(axis)]);
    }
  }
  return packed;
}

std::vector<BlockPixel> tilePixels(const GramInputs& inputs, int tile) {
  const GramParams& params = inputs.params;
  const int firstX = params.tileOffsetX + tile % params.tilesX * inputs.tileEdge;
  const int firstY = params.tileOffsetY + tile / params.tilesX * inputs.tileEdge;
  std::vector<BlockPixel> pixels;
  for (int y = firstY; y < firstY + inputs.tileEdge; ++y) {
    for (int x = firstX; x < firstX + inputs.tileEdge; ++x) {
      const BlockPixel pixel{mirror(x, params.planes.width), mirror(y, params.planes.height)};
      const bool inside = pixel.x == x && pixel.y == y;
      if (inputs.overlap && !inside) continue;
      if (inputs.guides.at(QUELL_GUIDE_WEIGHT, pixel.x, pixel.y) > 0.0f) pixels.push_back(pixel);
    }
  }
  return pixels;
}

FitRecord scalingOf(const PositionRange& range) {
  FitRecord record;
  record.scale.fill(1.0);
  if (range.empty()) return record;
  double centreSquared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    centreSquared += std::pow(0.5 * (range.low[axis] + range.high[axis]), 2);
  const double distance = std::sqrt(centreSquared);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = range.high[axis] - range.low[axis];
    // Rounding noise is divided by the distance instead.
    const double otherwise = distance > 0.0 ? distance : 1.0;
    record.anchor[axis] = range.low[axis];
    record.scale[axis] = 1.0 / (extent > double(QUELL_FIT_LEAST_RANGE) * distance ? extent : otherwise);
  }
  return record;
}

void addPixel(const GramInputs& inputs, const FitRecord& scaling, BlockPixel pixel, double factor,
              GramMatrix& sums) {
  Eigen::Matrix<double, QUELL_FIT_COLUMNS, 1> columns;
  columns.head<QUELL_FEATURES>() = features(inputs.guides, scaling, pixel.x, pixel.y).transpose();
  for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
    columns[QUELL_FEATURES + c] = inputs.irradiance.at(c, pixel.x, pixel.y);
  sums +=
      factor * double(inputs.guides.at(QUELL_GUIDE_WEIGHT, pixel.x, pixel.y)) * columns * columns.transpose();
}

}  // namespace quell::tests
