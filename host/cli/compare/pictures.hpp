// The pictures that `quell compare` reads: OpenEXR, PNG, PFM and raw samples, placed by their windows.
#pragma once

#include <quell/frame.hpp>
#include <string>
#include <vector>

#include "host/io/image.hpp"
#include "host/io/pixel_window.hpp"

namespace quell::cli {

/// By name: PNG, and what the denoise command writes for display, hold encoded values; the rest is linear.
bool isEncoded(const std::string& path);

/// One or two file names joined by a comma. Names may have commas themselves: what exists as a file is one.
std::vector<std::string> splitReference(const std::string& text);

/// Pictures of one size, compared where all of them have pixels.
class PictureSet {
 public:
  /// Reads headers alone. `size`: of raw files, {0, 0}: that of the first picture. Throws Error(InvalidArgument) naming the
  /// file whose display window differs from the first one's, or that has no pixels in common with those before;
  /// Error(FileError).
  PictureSet(const std::vector<std::string>& paths, Size size);

  /// One of the pictures, 3 channels, cut to common(). Throws Error(FileError).
  io::Image read(const std::string& path) const;

  /// What all pictures cover, and the whole of the first one.
  const io::PixelWindow& common() const { return m_common; }
  const io::PixelWindow& whole() const { return m_first.display; }

 private:
  io::PictureWindows windowsOf(const std::string& path) const;

  Size m_size;
  io::PictureWindows m_first;
  io::PixelWindow m_common;
};

}  // namespace quell::cli
