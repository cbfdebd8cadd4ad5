#include "tests/oracle/gram_sums_oracle.hpp"

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

GramTile sumTile(const GramInputs& inputs, int number) {
  const std::vector<BlockPixel> pixels = tilePixels(inputs, number);
  GramTile tile(inputs.list);
  for (const BlockPixel pixel : pixels) tile.range.include(inputs.guides, pixel.x, pixel.y);
  const FitRecord scaling = scalingOf(tile.range);
  for (const BlockPixel pixel : pixels) addPixel(inputs, scaling, pixel, 1.0, tile.sums);
  return tile;
}

// Planes of a tile: low ends of the ranges, high ends, and all of them.
int lowPlane(const FeatureNames& list) { return QUELL_GRAM_SUMS_OF(list.count()); }
int highPlane(const FeatureNames& list) { return lowPlane(list) + int(list.scaled.size()); }
int planeCount(const FeatureNames& list) {
  return QUELL_GRAM_PLANES_OF(list.count(), int(list.scaled.size()));
}

}  // namespace

GramMatrix emptySums(const FeatureNames& list) {
  const Eigen::Index columns = list.count() + QUELL_FIT_CHANNELS;
  return GramMatrix::Zero(columns, columns);
}

std::vector<GramTile> gramSumsOracle(const GramInputs& inputs) {
  std::vector<GramTile> tiles;
  for (int tile = 0; tile < gramTileCount(inputs.params); ++tile) tiles.push_back(sumTile(inputs, tile));
  return tiles;
}

GramTile unpackTile(const Planes& tiles, const GramParams& params, int tile, const FeatureNames& list) {
  const auto value = [&](int plane) { return tiles.values[elementOf(plane, params.tileStride, tile)]; };
  GramTile unpacked(list);
  const int columns = int(unpacked.sums.cols());
  for (int a = 0; a < columns; ++a)
    for (int b = a; b < columns; ++b)
      unpacked.sums(a, b) = unpacked.sums(b, a) = value(QUELL_GRAM_INDEX_OF(columns, a, b));
  for (std::size_t i = 0; i < list.scaled.size(); ++i) {
    unpacked.range.low[i] = value(lowPlane(list) + int(i));
    unpacked.range.high[i] = value(highPlane(list) + int(i));
  }
  return unpacked;
}

Planes packTiles(const std::vector<GramTile>& tiles) {
  const int count = int(tiles.size());
  const FeatureNames& list = tiles.front().range.list;
  Planes packed({count * planeCount(list), 1}, 1);
  for (int tile = 0; tile < count; ++tile) {
    const GramTile& from = tiles[std::size_t(tile)];
    const int columns = int(from.sums.cols());
    const auto store = [&](int plane, double value) {
      packed.values[elementOf(plane, count, tile)] = float(value);
    };
    for (int a = 0; a < columns; ++a)
      for (int b = a; b < columns; ++b) store(QUELL_GRAM_INDEX_OF(columns, a, b), from.sums(a, b));
    for (std::size_t i = 0; i < list.scaled.size(); ++i) {
      store(lowPlane(list) + int(i), from.range.low[i]);
      store(highPlane(list) + int(i), from.range.high[i]);
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

void addPixel(const GramInputs& inputs, const FitRecord& scaling, BlockPixel pixel, double factor,
              GramMatrix& sums) {
  Eigen::VectorXd columns(sums.cols());
  columns.head(inputs.list.count()) = features(inputs.guides, scaling, pixel.x, pixel.y).transpose();
  for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
    columns[inputs.list.count() + c] = inputs.irradiance.at(c, pixel.x, pixel.y);
  sums +=
      factor * double(inputs.guides.at(QUELL_GUIDE_WEIGHT, pixel.x, pixel.y)) * columns * columns.transpose();
}

}  // namespace quell::tests
