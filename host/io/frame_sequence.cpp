#include "host/io/frame_sequence.hpp"

#include <filesystem>

#include "host/io/bmfr_sequence.hpp"
#include "host/io/cycles_sequence.hpp"
#include "host/io/file_error.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {

std::unique_ptr<FrameSequence> openSequence(const std::string& directory, int signals) {
  std::error_code failure;
  if (!std::filesystem::is_directory(directory, failure))
    throwFileError("open sequence", directory, "a directory of frames", "no such directory");
  if (hasFile(directory, kCyclesCameraFile)) return std::make_unique<CyclesSequence>(directory, signals);
  if (hasFile(directory, kBmfrCameraFile) && signals != 1)
    throwFileError("open sequence", directory, std::string("two signals beside ") + kCyclesCameraFile,
                   std::string("the layout of ") + kBmfrCameraFile + ", which has one");
  if (hasFile(directory, kBmfrCameraFile)) return std::make_unique<BmfrSequence>(directory);
  throwFileError("open sequence", directory,
                 std::string(kCyclesCameraFile) + " (beside color_0000.exr, ...) or " + kBmfrCameraFile +
                     " (beside color0.exr, ...)",
                 "neither");
}

}  // namespace quell::io
