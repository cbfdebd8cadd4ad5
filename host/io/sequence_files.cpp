#include "host/io/sequence_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <quell/camera.hpp>

#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "open sequence";

}  // namespace

bool hasFile(const std::string& directory, const std::string& name) {
  std::error_code failure;
  return fs::is_regular_file(fs::path(directory) / name, failure);
}

std::string joinPath(const std::string& directory, const std::string& name) {
  return (fs::path(directory) / name).string();
}

std::vector<int> framesOf(const std::vector<FrameFiles>& required, MissingFrames missing) {
  std::vector<int> frames = required.front().frames();
  if (missing == MissingFrames::Refuse || frames.empty()) {
    required.front().requireNoGaps();
    for (const FrameFiles& files : required) files.requireAll(frames);
    return frames;
  }
  const auto lacksOne = [&](int frame) {
    return std::any_of(required.begin(), required.end(),
                       [frame](const FrameFiles& files) { return !files.has(frame); });
  };
  std::vector<int> whole = frames;
  whole.erase(std::remove_if(whole.begin(), whole.end(), lacksOne), whole.end());
  if (whole.empty())
    for (const FrameFiles& files : required) files.requireAll(frames);
  return whole;
}

bool hasAll(const FrameFiles& files, const std::vector<int>& frames) {
  const bool any = std::any_of(frames.begin(), frames.end(), [&](int frame) { return files.has(frame); });
  if (any) files.requireAll(frames);
  return any;
}

void markGap(FrameData& frame, const std::vector<int>& frames, const std::string& missingFile) {
  frame.afterGap =
      frame.number > frames.front() && !std::binary_search(frames.begin(), frames.end(), frame.number - 1);
  if (!frame.afterGap) return;
  frame.warnings.push_back({FrameWarning::Kind::MissingFrames, missingFile,
                            fmt::format("frames {} to {} without gaps", frames.front(), frames.back()),
                            missingText(frames), "goes on after each gap as after a cut, without history"});
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
