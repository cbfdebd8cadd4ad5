#include "host/io/exr_image.hpp"

#include "host/io/exr_file.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {

Image readExr(const std::string& path) { return ExrFile(path).readKnown().image; }

Image readExr(const std::string& path, const std::vector<std::string>& channels) {
  const ExrFile file(path);
  if (channels.empty()) throwFileError("read EXR", path, "channels of at least one name", "none");
  return file.read(channels).image;
}

Image readExrRgb(const std::string& path) { return ExrFile(path).read().image; }

}  // namespace quell::io
