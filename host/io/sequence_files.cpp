#include "host/io/sequence_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <quell/camera.hpp>

#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "open sequence";

/// The frame whose file is called `name`, if there is one: the digits before ".exr" must give back the name.
std::optional<int> frameOf(const std::string& name, const FrameFileName& fileName) {
  const std::size_t end = name.rfind('.');
  if (end == std::string::npos) return std::nullopt;
  std::size_t begin = end;
  while (begin > 0 && name[begin - 1] >= '0' && name[begin - 1] <= '9') --begin;
  int frame = 0;
  const auto parsed = std::from_chars(name.data() + begin, name.data() + end, frame);
  if (parsed.ec != std::errc() || fileName(frame) != name) return std::nullopt;
  return frame;
}

}  // namespace

bool hasFile(const std::string& directory, const std::string& name) {
  std::error_code failure;
  return fs::is_regular_file(fs::path(directory) / name, failure);
}

std::string joinPath(const std::string& directory, const std::string& name) {
  return (fs::path(directory) / name).string();
}

std::vector<int> findFrames(const std::string& directory, const FrameFileName& fileName) {
  std::error_code failure;
  std::vector<int> frames;
  const fs::directory_iterator end;
  for (fs::directory_iterator entry(directory, failure); !failure && entry != end; entry.increment(failure))
    if (const auto frame = frameOf(entry->path().filename().string(), fileName)) frames.push_back(*frame);
  if (failure) throwFileError(kStage, directory, "a readable directory", failure.message());
  std::sort(frames.begin(), frames.end());
  if (frames.empty())
    throwFileError(kStage, directory, fmt::format("at least one frame such as {}", fileName(0)), "none");
  const int count = int(frames.size());
  for (int i = 1; i < count; ++i)
    if (frames[i] != frames[i - 1] + 1)
      throwFileError(kStage, joinPath(directory, fileName(frames[i - 1] + 1)),
                     fmt::format("frames {} to {} without gaps", frames.front(), frames.back()),
                     fmt::format("no frame {}", frames[i - 1] + 1));
  return frames;
}

void requireFrameFiles(const std::string& directory, const FrameFileName& fileName,
                       const std::vector<int>& frames) {
  for (int frame : frames)
    if (!hasFile(directory, fileName(frame)))
      throwFileError(kStage, joinPath(directory, fileName(frame)),
                     fmt::format("this buffer for each of the {} frames", frames.size()), "no such file");
}

bool hasFrameFiles(const std::string& directory, const FrameFileName& fileName,
                   const std::vector<int>& frames) {
  const bool any = std::any_of(frames.begin(), frames.end(),
                               [&](int frame) { return hasFile(directory, fileName(frame)); });
  if (any) requireFrameFiles(directory, fileName, frames);
  return any;
}

void requireFrame(const std::string& directory, const std::vector<int>& frames, int frame) {
  if (std::binary_search(frames.begin(), frames.end(), frame)) return;
  throw Error(ErrorCode::InvalidArgument,
              {"read frame", directory, fmt::format("a frame from {} to {}", frames.front(), frames.back()),
               std::to_string(frame)});
}

std::array<double, 2> requireJitter(const std::string& path, const char* name, int frame,
                                    std::array<double, 2> jitterPx) {
  for (const double component : jitterPx)
    if (!(std::abs(component) <= kMaxJitterPx))
      throwFileError(
          kStage, path,
          fmt::format("{} of frame {} at most {} pixel off the pixel centre", name, frame, kMaxJitterPx),
          fmt::format("{}, {} off", jitterPx[0], jitterPx[1]));
  return jitterPx;
}

Image readChannelsOfSize(const std::string& path, const std::vector<std::string>& channels, int width,
                         int height) {
  Image image = readExr(path, channels);
  requireSize(image, width, height, path);
  return image;
}

Image readLettersOfSize(const std::string& path, const std::string& letters, int width, int height) {
  if (letters != "RGB") {
    std::vector<std::string> channels;
    for (const char letter : letters) channels.emplace_back(1, letter);
    return readChannelsOfSize(path, channels, width, height);
  }
  Image image = readExrRgb(path);
  requireSize(image, width, height, path);
  return image;
}

}  // namespace quell::io
