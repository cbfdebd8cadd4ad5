#include "host/cli/compare/pictures.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <quell/error.hpp>

#include "host/io/exr_image.hpp"
#include "host/io/plain_image.hpp"
#include "host/io/png_image.hpp"

namespace quell::cli {
namespace {

namespace fs = std::filesystem;

enum class Format { Exr, Png, Pfm, Raw };

Format formatOf(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension == ".png"   ? Format::Png
         : extension == ".pfm" ? Format::Pfm
         : extension == ".raw" ? Format::Raw
                               : Format::Exr;
}

io::PictureWindows windowsOfSize(int width, int height) {
  const io::PixelWindow whole{0, 0, width, height};
  return {whole, whole};
}

bool isFile(const std::string& path) {
  std::error_code failure;
  return fs::exists(path, failure);
}

}  // namespace

bool isEncoded(const std::string& path) {
  return formatOf(path) == Format::Png || fs::path(path).filename().string().rfind("display_", 0) == 0;
}

std::vector<std::string> splitReference(const std::string& text) {
  if (text.find(',') == std::string::npos || isFile(text)) return {text};
  for (std::size_t comma = text.find(','); comma != std::string::npos; comma = text.find(',', comma + 1))
    if (isFile(text.substr(0, comma)) && isFile(text.substr(comma + 1)))
      return {text.substr(0, comma), text.substr(comma + 1)};
  return {text.substr(0, text.find(',')), text.substr(text.find(',') + 1)};
}

PictureSet::PictureSet(const std::vector<std::string>& paths, Size size) : m_size(size) {
  m_first = windowsOf(paths.front());
  m_size = {m_first.display.width, m_first.display.height};
  m_common = io::intersection(m_first.data, m_first.display);
  for (const std::string& path : paths) {
    const io::PixelWindow common = io::intersection(m_common, windowsOf(path).data);
    if (common.width == 0)
      throw Error(ErrorCode::InvalidArgument,
                  {"compare", path, "pixels within " + io::toString(m_common), "none"});
    m_common = common;
  }
}

io::PictureWindows PictureSet::windowsOf(const std::string& path) const {
  io::PictureWindows windows = m_first;
  if (formatOf(path) == Format::Exr) {
    windows = io::readExrHeader(path).windows;
  } else if (formatOf(path) == Format::Raw) {
    if (m_size.width <= 0)
      throw Error(ErrorCode::InvalidArgument,
                  {"compare", path, "--size WIDTHxHEIGHT of raw samples", "none"});
    windows = windowsOfSize(m_size.width, m_size.height);
  } else {
    const io::Image image = formatOf(path) == Format::Png ? io::readPng(path) : io::readPfm(path);
    windows = windowsOfSize(image.width, image.height);
  }
  if (m_first.display.width == 0 || windows.display == m_first.display) return windows;
  // Programs that know no windows leave the pixels of a crop alone.
  const bool sameSize =
      windows.data.width == m_first.data.width && windows.data.height == m_first.data.height;
  if (sameSize && windows.data == windows.display) return m_first;
  throw Error(ErrorCode::InvalidArgument,
              {"compare", path, io::toString(m_first.display) + " as the first reference",
               io::toString(windows.display)});
}

io::Image PictureSet::read(const std::string& path) const {
  io::Image image;
  switch (formatOf(path)) {
    case Format::Png:
      image = io::readPng(path);
      break;
    case Format::Pfm:
      image = io::readPfm(path);
      break;
    case Format::Raw:
      image = io::readRaw(path, m_size.width, m_size.height);
      break;
    case Format::Exr:
      image = io::readExrRgb(path);
  }
  return io::placed(image, windowsOf(path).data, m_common);
}

}  // namespace quell::cli
