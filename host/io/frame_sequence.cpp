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

}  // namespace

std::unique_ptr<FrameSequence> openSequence(const std::string& directory, int signals) {
  std::error_code failure;
  if (isMultilayerFile(directory)) return std::make_unique<MultilayerSequence>(directory, false, signals);
  if (!std::filesystem::is_directory(directory, failure))
    throwFileError("open sequence", directory, "a directory of frames or a multilayer OpenEXR file",
                   "no such directory");
  // Separate files may lie beside a multilayer one: they come first.
  const std::string multilayer = hasFile(directory, kBmfrCameraFile) || hasColorFiles(directory)
                                     ? std::string()
                                     : findMultilayerFile(directory);
  if (!multilayer.empty()) return std::make_unique<MultilayerSequence>(multilayer, true, signals);
  if (hasFile(directory, kCyclesCameraFile)) return std::make_unique<CyclesSequence>(directory, signals);
  if (hasFile(directory, kBmfrCameraFile) && signals != 1)
    throwFileError("open sequence", directory, std::string("two signals beside ") + kCyclesCameraFile,
                   std::string("the layout of ") + kBmfrCameraFile + ", which has one");
  if (hasFile(directory, kBmfrCameraFile)) return std::make_unique<BmfrSequence>(directory);
  throwFileError("open sequence", directory,
                 std::string(kCyclesCameraFile) + " (beside color_0000.exr, ...) or " + kBmfrCameraFile +
                     " (beside color0.exr, ...) or multilayer files such as 0001.exr",
                 "none of them");
}

}  // namespace quell::io
