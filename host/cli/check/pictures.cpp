#include "host/cli/check/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/metrics/color_map.hpp"
#include "host/metrics/display_encoding.hpp"

namespace quell::cli {
namespace {

/// Images of light and reflectance; others have values of any range.
bool isColor(const std::string& image) {
  for (const char* name : {"radiance", "glossyRadiance", "albedo", "glossColor", "emission", "f0"})
    if (image == name) return true;
  return false;
}

const io::Image& imageOf(const io::FrameData& frame, const std::string& name) {
  for (const auto& facts : kInputs<io::FrameData>)
    if (name == facts.name && !(frame.*facts.member).empty()) return frame.*facts.member;
  return frame.noisy();
}

/// Every channel from its least to its greatest value; grey for one.
io::Image stretched(const io::Image& image) {
  io::Image picture(image.width, image.height, 3);
  for (int c = 0; c < 3; ++c) {
    const int source = std::min(c, image.channels - 1);
    float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
    for (std::size_t i = std::size_t(source); i < image.pixels.size(); i += std::size_t(image.channels)) {
      if (!std::isfinite(image.pixels[i])) continue;
      least = std::min(least, image.pixels[i]);
      most = std::max(most, image.pixels[i]);
    }
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        picture.at(x, y, c) = (image.at(x, y, source) - least) / std::max(most - least, 1e-30f);
  }
  return picture;
}

io::Image visible(const io::FrameData& frame, const std::string& name) {
  const io::Image& image = imageOf(frame, name);
  const bool color = isColor(name) || &image == &frame.noisy();
  if (color && image.channels >= 3) return metrics::encodeForDisplay(image);
  return stretched(image);
}

}  // namespace

io::Image pictureOf(const io::FrameData& frame, const check::MappedFinding& found) {
  const io::Image image = visible(frame, found.finding.image);
  const check::Map& map = found.map;
  io::Image picture(map.values.empty() ? image.width : 2 * image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) picture.at(x, y, c) = image.at(x, y, c);
  if (map.values.empty()) return picture;
  io::Image values(map.width, map.height, 1);
  values.pixels = map.values;
  const io::Image colors = metrics::colorizeMap(values);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        picture.at(image.width + x, y, c) =
            colors.at(x * map.width / image.width, y * map.height / image.height, c);
  return picture;
}

}  // namespace quell::cli
