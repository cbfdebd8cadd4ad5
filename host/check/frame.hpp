// A frame in host memory, as checks look at it.
#pragma once

#include <quell/frame_images.h>

#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <quell/camera.hpp>

namespace quell::check {

/// Row-major, interleaved floats of someone else; pixel (0, 0) is top left. Absent images have no channels.
struct Image {
  const float* values = nullptr;
  int width = 0;
  int height = 0;
  int channels = 0;

  bool present() const { return channels != 0; }
  float at(int x, int y, int c) const {
    return values[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels) +
                  std::size_t(c)];
  }
};

/// The images of quell/frame_images.h, all of one size; position or depth may be the only one of the two.
struct Frame {
  int number = 0;  ///< frames of consecutive numbers are compared
  Camera camera;
  bool cameraKnown = true;   ///< false: the matrices only stand in for one that is not known
  bool demodulated = false;  ///< as quell::Frame::demodulated
#define QUELL_IMAGE(name, ...) Image name;
  QUELL_FRAME_IMAGES(QUELL_IMAGE)
#undef QUELL_IMAGE

  int width() const { return radiance.width; }
  int height() const { return radiance.height; }
};

/// The first three channels; one channel counts for all.
inline glm::dvec3 vectorAt(const Image& image, int x, int y) {
  const int second = image.channels >= 3 ? 1 : 0;
  return {double(image.at(x, y, 0)), double(image.at(x, y, second)), double(image.at(x, y, 2 * second))};
}

inline bool isFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool isZero(const glm::dvec3& v) { return v == glm::dvec3(0.0); }

/// Of linear RGB, Rec. ITU-R BT.709.
inline double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

/// 0 where the image is absent.
inline double luminanceAt(const Image& image, int x, int y) {
  return image.present() ? luminance(vectorAt(image, x, y)) : 0.0;
}

}  // namespace quell::check
