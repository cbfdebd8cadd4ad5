// OpenEXR files that stay open: their headers are checked once, however many images are read.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/io/exr_header.hpp"
#include "host/io/image.hpp"

namespace quell::io {

/// An image with where it lies.
struct PlacedImage {
  Image image;
  PictureWindows windows;
};

class ExrFile {
 public:
  /// Throws Error(FileError) as readExrHeader() does.
  explicit ExrFile(std::string path);
  ExrFile(ExrFile&&) noexcept;
  ~ExrFile();

  const std::string& path() const { return m_path; }
  const ExrHeader& header() const;

  /// Channels of these names (ExrHeader::channels), of whatever parts; for none of them as readExrRgb() has them. Parts with
  /// other windows than the first of these are placed by window. Throws Error(FileError): damaged, or one is missing.
  PlacedImage read(const std::vector<std::string>& channels = {}) const;
  /// As readExr() without channels has them.
  PlacedImage readKnown() const;

  /// Where such an image lies, of a file that has it. Throws as read(), but looks at no pixels.
  PictureWindows windowsOf(const std::vector<std::string>& channels) const;

 private:
  struct Open;
  std::string m_path;
  std::unique_ptr<Open> m_open;
};

/// Files that are opened when they are first asked for, and closed with this.
class OpenFiles {
 public:
  const ExrFile& at(const std::string& path) { return m_files.try_emplace(path, path).first->second; }
  /// Throws besides what requireAllLines() throws.
  const ExrFile& whole(const std::string& path) {
    const auto [file, isNew] = m_files.try_emplace(path, path);
    if (isNew) requireAllLines(path);
    return file->second;
  }

 private:
  std::map<std::string, ExrFile> m_files;
};

}  // namespace quell::io
