// Where the pixels of an image lie among those of the whole picture: OpenEXR's data window and display window.
#pragma once

#include <quell/camera.hpp>
#include <string>

#include "host/io/image.hpp"

namespace quell::io {

/// A rectangle of pixels; (x, y) is its top left one, y down.
struct PixelWindow {
  int x = 0;
  int y = 0;
  int width = 0;   ///< >= 1 unless there is no window
  int height = 0;  ///< >= 1 unless there is no window
};

inline bool operator==(const PixelWindow& a, const PixelWindow& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}
inline bool operator!=(const PixelWindow& a, const PixelWindow& b) { return !(a == b); }

/// Both windows of a picture.
struct PictureWindows {
  PixelWindow data;     ///< pixels that the file holds
  PixelWindow display;  ///< the whole picture, which cameras speak of
};

/// "96x54 pixels", or "96x54 pixels from (16, 9) on" where the window does not begin at the origin.
std::string toString(const PixelWindow& window);

/// Pixels that two windows share; width and height are 0 where there are none.
PixelWindow intersection(const PixelWindow& a, const PixelWindow& b);

/// The image, whose pixels lie at `from`, cut and filled with zeros so that it covers `to`.
Image placed(const Image& image, const PixelWindow& from, const PixelWindow& to);

/// The camera of the display window as one of the data window. Jitter, in pixels, stays as it is.
Camera cropped(Camera camera, const PictureWindows& windows);

}  // namespace quell::io
