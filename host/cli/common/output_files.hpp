// What commands leave on disk.
#pragma once

#include <optional>
#include <string>

#include "host/cli/common/denoise_session.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Makes a directory, unless it is there, and those that it lies in. Throws Error(FileError) that names the command.
void createDirectory(const char* command, const std::string& path);

/// Unless `path` is empty; indented by two. Throws Error(FileError).
template <class Json>
void writeJson(const std::string& path, const Json& value) {
  if (!path.empty()) io::writeTextFile(path, value.dump(2) + "\n");
}

struct OutputFormats {
  bool png = true;                          ///< display_%04d.png
  bool exr = false;                         ///< display_%04d.exr
  io::ExrType samples = io::ExrType::Half;  ///< of denoised_%04d.exr and display_%04d.exr
};

/// Display-encoded pictures side by side, 3 channels: noisy | denoised | reference, the last only where there is one.
/// `noisy` is linear, and shown through the transform of the denoised frame.
io::Image comparisonSheet(const io::Image& noisy, const DenoisedFrame& denoised,
                          const io::Reference* reference);

/// What the denoise command leaves in its output directory.
class OutputFiles {
 public:
  /// Creates the directory. Throws Error(FileError).
  OutputFiles(std::string directory, OutputFormats formats);

  /// denoised_%04d.exr (linear, before tone map and TAA, ZIP) and the display image in the chosen formats. The OpenEXR
  /// files have the alpha, the windows and the attributes of the frame's colour.
  void write(const io::FrameData& frame, const DenoisedFrame& denoised) const;

  /// PREFIX_%04d.exr: a linear picture of the frame, 3 channels, as denoised_%04d.exr is written.
  void writeLinear(const std::string& prefix, const io::FrameData& frame, const io::Image& picture) const;

  /// comparison_%04d.png: noisy | denoised | reference, side by side.
  void writeComparison(const io::FrameData& noisy, const DenoisedFrame& denoised,
                       const io::Reference& reference) const;

  /// NAME_%04d.exr, floats without loss: channel Y, or R, G and B, or else plane0, plane1, ...
  void writeBuffer(int frame, const BufferContent& content) const;

  /// tiles_%04d.png: the display image, darkened where `map` says that nothing was filtered.
  void writeTiles(int frame, const DenoisedFrame& denoised, const BackgroundMap& map) const;

  /// PREFIX_%04d.EXTENSION in the directory.
  std::string path(const std::string& prefix, int frame, const char* extension) const;
  /// Of linear pictures.
  io::ExrType samples() const { return m_formats.samples; }

 private:
  std::string m_directory;
  OutputFormats m_formats;
};

}  // namespace quell::cli
