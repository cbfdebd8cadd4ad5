#include "host/io/sequence_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <quell/camera.hpp>

#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "open sequence";

[[noreturn]] void refuseWindows(const std::string& path, const PictureWindows& got,
                                const PictureWindows& expected) {
  const auto text = [](const PictureWindows& windows) {
    if (windows.data == windows.display) return toString(windows.data);
    return fmt::format("{} in a picture of {}", toString(windows.data), toString(windows.display));
  };
  throw Error(ErrorCode::InvalidArgument, {"read image", path, text(expected), text(got)});
}

}  // namespace

bool hasFile(const std::string& directory, const std::string& name) {
  std::error_code failure;
  return fs::is_regular_file(fs::path(directory) / name, failure);
}

std::vector<std::string> listEntries(const std::string& directory,
                                     const std::function<bool(const fs::directory_entry& entry)>& wanted) {
  std::error_code failure;
  std::vector<std::string> names;
  const fs::directory_iterator end;
  for (fs::directory_iterator entry(directory, failure); !failure && entry != end; entry.increment(failure))
    if (wanted(*entry)) names.push_back(entry->path().filename().string());
  if (failure) throwFileError(kStage, directory, "a readable directory", failure.message());
  std::sort(names.begin(), names.end());
  return names;
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

void requireWithin(const ExrFile& file, const std::vector<std::string>& channels,
                   const PictureWindows& picture) {
  const PictureWindows windows = file.windowsOf(channels);
  if (windows.data == picture.data) return;
  if (windows.display != picture.display || intersection(windows.data, picture.data).width == 0)
    refuseWindows(file.path(), windows, picture);
}

Image readWithin(const ExrFile& file, const std::vector<std::string>& channels, const PictureWindows& picture,
                 std::vector<FrameWarning>& warnings) {
  requireWithin(file, channels, picture);
  PlacedImage read = file.read(channels);
  const PixelWindow &data = read.windows.data, &wanted = picture.data;
  if (data == wanted) return std::move(read.image);
  const PixelWindow common = intersection(data, wanted);
  const std::int64_t outside =
      std::int64_t(wanted.width) * wanted.height - std::int64_t(common.width) * common.height;
  if (outside > 0)
    warnings.push_back({FrameWarning::Kind::Windows, file.path(), "a data window of " + toString(wanted),
                        toString(data),
                        fmt::format("goes on with zeros, which are background, in {} pixels; files without "
                                    "cropping (autocrop, regions) would have them",
                                    outside)});
  return placed(read.image, data, wanted);
}

std::vector<std::string> channelsOfLetters(const std::string& letters) {
  std::vector<std::string> channels;
  if (letters != "RGB")
    for (const char letter : letters) channels.emplace_back(1, letter);
  return channels;
}

void requireWindows(const std::string& path, const PictureWindows& windows, const PictureWindows& expected) {
  if (windows.data != expected.data || windows.display != expected.display)
    refuseWindows(path, windows, expected);
}

ExrOrigin originOf(const ExrFile& file, const PictureWindows& expected) {
  requireWindows(file.path(), file.header().windows, expected);
  return {file.header().windows, file.header().attributes};
}

}  // namespace quell::io
