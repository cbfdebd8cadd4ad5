#include "host/check/albedo_exponent.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace quell::check {
namespace {

constexpr int kTile = 8;
/// Least cosine between normals of one surface, least albedo, and least pixels of a tile.
constexpr double kSameNormal = 0.95, kLeastAlbedo = 0.02;
/// Glossy light goes with its own colour: pixels that have more than this share of albedo as gloss colour are left out if
/// the others suffice.
constexpr double kMostGloss = 0.1;
/// Largest standard error of an exponent that says something.
constexpr double kSureError = 0.2;
constexpr std::size_t kLeastPixels = 24;
constexpr double kLeastExponent = -1.0, kMostExponent = 4.0;
constexpr int kBisections = 40;

struct Pixel {
  double light;      // as a share of the tile's
  double logAlbedo;  // above the tile's mean
};
using Tile = std::vector<Pixel>;

/// How much more of the light is where albedo is high than this exponent explains, and how sensitive that is to it.
struct Score {
  double value = 0.0, information = 0.0;
};

Score scoreOf(const Tile& tile, double exponent) {
  double sum = 0.0, mean = 0.0, square = 0.0;
  Score score;
  for (const Pixel& pixel : tile) {
    const double weight = std::exp(exponent * pixel.logAlbedo);
    sum += weight;
    mean += weight * pixel.logAlbedo;
    square += weight * pixel.logAlbedo * pixel.logAlbedo;
    score.value += pixel.light * pixel.logAlbedo;
  }
  mean /= sum;
  score.value -= mean;
  score.information = square / sum - mean * mean;
  return score;
}

Tile tileAt(const Frame& frame, double mostGloss, int left, int top) {
  Tile tile;
  std::optional<glm::dvec3> first;
  double light = 0.0, logAlbedo = 0.0;
  for (int y = top; y < top + kTile; ++y) {
    for (int x = left; x < left + kTile; ++x) {
      const glm::dvec3 normal = vectorAt(frame.normalWorld, x, y);
      const double albedo = luminanceAt(frame.albedo, x, y);
      const double here = luminanceAt(frame.radiance, x, y) - luminanceAt(frame.emission, x, y);
      if (!isFinite(normal) || isZero(normal) || !(albedo >= kLeastAlbedo)) continue;
      if (!(here >= 0.0) || !std::isfinite(here)) continue;
      if (!(luminanceAt(frame.glossColor, x, y) <= mostGloss * albedo)) continue;
      if (!first) first = glm::normalize(normal);
      if (glm::dot(glm::normalize(normal), *first) < kSameNormal) continue;
      tile.push_back({here, std::log(albedo)});
      light += here;
      logAlbedo += tile.back().logAlbedo;
    }
  }
  if (tile.size() < kLeastPixels || !(light > 0.0)) return {};
  for (Pixel& pixel : tile) {
    pixel.light /= light;
    pixel.logAlbedo -= logAlbedo / double(tile.size());
  }
  return tile;
}

/// Of the tiles' pixels with no more gloss colour than this share of albedo.
std::optional<Exponent> exponentOf(const Context& context, double mostGloss) {
  std::vector<Tile> tiles;
  for (int top = 0; top + kTile <= context.size.height; top += kTile)
    for (int left = 0; left + kTile <= context.size.width; left += kTile)
      if (Tile tile = tileAt(context.now, mostGloss, left, top); !tile.empty())
        tiles.push_back(std::move(tile));
  double low = kLeastExponent, high = kMostExponent;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    double sum = 0.0;
    for (const Tile& tile : tiles) sum += scoreOf(tile, middle).value;
    (sum > 0.0 ? low : high) = middle;
  }
  double information = 0.0, squares = 0.0;
  for (const Tile& tile : tiles) {
    const Score score = scoreOf(tile, low);
    information += score.information;
    squares += score.value * score.value;
  }
  if (!(std::sqrt(squares) <= kSureError * information) || !(information > 0.0)) return std::nullopt;
  return Exponent{low, std::sqrt(squares) / information};
}

}  // namespace

std::optional<Exponent> albedoExponent(const Context& context) {
  const auto matt = exponentOf(context, kMostGloss);
  return matt ? matt : exponentOf(context, std::numeric_limits<double>::infinity());
}

}  // namespace quell::check
