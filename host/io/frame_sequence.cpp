#include "host/io/frame_sequence.hpp"

#include <filesystem>

#include "host/io/bmfr_sequence.hpp"
#include "host/io/cycles_sequence.hpp"
#include "host/io/file_error.hpp"
#include "host/io/multilayer_sequence.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

bool hasColorFiles(const std::string& directory) {
  std::error_code failure;
  const std::filesystem::directory_iterator end;
  for (std::filesystem::directory_iterator entry(directory, failure); !failure && entry != end;
       entry.increment(failure))
    if (entry->path().filename().string().rfind("color_", 0) == 0) return true;
  return false;
}

[[noreturn]] void refuseSignals(const std::string& directory) {
  throwFileError("open sequence", directory, std::string("two signals beside ") + kCyclesCameraFile,
                 std::string("the layout of ") + kBmfrCameraFile + ", which has one");
}

std::unique_ptr<FrameSequence> openDirectory(const std::string& directory, int signals,
                                             MissingFrames missing) {
  // Separate files may lie beside a multilayer one: they come first.
  const FrameFiles multilayer = hasFile(directory, kBmfrCameraFile) || hasColorFiles(directory)
                                    ? FrameFiles()
                                    : findMultilayerFiles(directory);
  if (!multilayer.empty())
    return std::make_unique<MultilayerSequence>(directory, multilayer, signals, missing);
  if (hasFile(directory, kCyclesCameraFile))
    return std::make_unique<CyclesSequence>(directory, signals, missing);
  if (!hasFile(directory, kBmfrCameraFile))
    throwFileError("open sequence", directory,
                   std::string(kCyclesCameraFile) + " (beside color_0000.exr, ...) or " + kBmfrCameraFile +
                       " (beside color0.exr, ...) or multilayer files such as 0001.exr",
                   "none of them");
  if (signals != 1) refuseSignals(directory);
  return std::make_unique<BmfrSequence>(directory, missing);
}

/// The files that a pattern stands for; those of the colour stand for the other buffers beside them.
std::unique_ptr<FrameSequence> openFiles(const std::string& pattern, int signals, MissingFrames missing) {
  FrameFiles files = findFrameFiles(pattern);
  const std::string directory = files.directory(), stem = factsOf(&FrameData::radiance).files.stem;
  if (files.prefix() == stem + "_")
    return std::make_unique<CyclesSequence>(directory, signals, missing, std::move(files));
  if (files.prefix() != stem || !hasFile(directory, kBmfrCameraFile))
    return std::make_unique<MultilayerSequence>(pattern, std::move(files), signals, missing);
  if (signals != 1) refuseSignals(directory);
  return std::make_unique<BmfrSequence>(directory, missing, std::move(files));
}

}  // namespace

std::unique_ptr<FrameSequence> openSequence(const std::string& path, int signals, MissingFrames missing) {
  std::error_code failure;
  if (isMultilayerFile(path)) return std::make_unique<MultilayerSequence>(path, oneFile(path), signals);
  if (std::filesystem::is_directory(path, failure)) return openDirectory(path, signals, missing);
  if (!std::filesystem::exists(path, failure) && isFramePattern(path))
    return openFiles(path, signals, missing);
  throwFileError("open sequence", path, "a directory of frames or a multilayer OpenEXR file",
                 std::filesystem::exists(path, failure) ? "a file that is none" : "no such directory");
}

}  // namespace quell::io
