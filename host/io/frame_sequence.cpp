#include "host/io/frame_sequence.hpp"

#include <filesystem>

#include "host/io/bmfr_sequence.hpp"
#include "host/io/cycles_sequence.hpp"
#include "host/io/file_error.hpp"
#include "host/io/frame_names.hpp"
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

std::unique_ptr<FrameSequence> openFrameFiles(const std::string& name, FrameFiles files,
                                              const SequenceOptions& options) {
  std::vector<PassFiles> passes = {{{}, std::move(files)}};
  return std::make_unique<MultilayerSequence>(name, std::move(passes), options);
}

/// Folders that hold a pass each, as Blender's File Output nodes make them: Normal/0001.exr.
std::vector<PassFiles> passFoldersOf(const std::string& directory) {
  const auto isFolder = [](const std::filesystem::directory_entry& entry) {
    std::error_code dangling;
    return entry.is_directory(dangling);
  };
  std::vector<PassFiles> passes;
  for (const std::string& folder : listEntries(directory, isFolder)) {
    std::vector<FrameFiles> sequences = withoutReferences(FrameDirectory(joinPath(directory, folder)).all());
    if (sequences.size() == 1) passes.push_back({folder, std::move(sequences.front())});
  }
  return passes;
}

/// Frames that are channels of files, all in one or a file for each pass; nothing where there are no files.
std::unique_ptr<FrameSequence> openChannels(const std::string& directory, const SequenceOptions& options) {
  FrameFiles multilayer = findMultilayerFiles(directory, options.channels);
  if (!multilayer.empty()) return openFrameFiles(directory, std::move(multilayer), options);
  std::vector<PassFiles> passes = passFilesOf(withoutReferences(FrameDirectory(directory).all()));
  if (passes.empty()) passes = passFoldersOf(directory);
  if (passes.empty()) return nullptr;
  // One sequence alone lacks passes; a message about its own channels is clearer without its name before them.
  if (passes.size() == 1) return openFrameFiles(directory, std::move(passes.front().files), options);
  return std::make_unique<MultilayerSequence>(directory, std::move(passes), options);
}

std::unique_ptr<FrameSequence> openDirectory(const std::string& directory, const SequenceOptions& options) {
  // Separate files may lie beside a multilayer one: they come first.
  const bool bmfr = hasFile(directory, kBmfrCameraFile), colors = hasColorFiles(directory);
  if (options.channels.given() || (!bmfr && !colors))
    if (auto sequence = openChannels(directory, options)) return sequence;
  if (hasFile(directory, kCyclesCameraFile))
    return std::make_unique<CyclesSequence>(directory, options.signals, options.missing);
  if (!bmfr)
    throwFileError("open sequence", directory,
                   std::string(kCyclesCameraFile) + " (beside color_0000.exr, ...) or " + kBmfrCameraFile +
                       " (beside color0.exr, ...) or multilayer files such as 0001.exr",
                   FrameDirectory(directory).all().empty() ? "no numbered OpenEXR files" : "none of them");
  if (options.signals != 1) refuseSignals(directory);
  return std::make_unique<BmfrSequence>(directory, options.missing);
}

/// The files that a pattern stands for, or that are listed; those of the colour stand for the other buffers beside them.
std::unique_ptr<FrameSequence> openFiles(const std::string& pattern, FrameFiles files,
                                         const SequenceOptions& options) {
  const std::string directory = files.directory(), stem = factsOf(&FrameData::radiance).files.stem;
  if (files.prefix() == stem + "_")
    return std::make_unique<CyclesSequence>(directory, options.signals, options.missing, std::move(files));
  if (files.prefix() != stem || !hasFile(directory, kBmfrCameraFile))
    return openFrameFiles(pattern, std::move(files), options);
  if (options.signals != 1) refuseSignals(directory);
  return std::make_unique<BmfrSequence>(directory, options.missing, std::move(files));
}

bool isExr(const std::string& path) {
  return lowerCase(std::filesystem::path(path).extension().string()) == ".exr";
}

}  // namespace

std::unique_ptr<FrameSequence> openSequence(const std::string& path, const SequenceOptions& options) {
  requireChannelOptions(options.channels);
  if (!options.furtherFiles.empty()) {
    std::vector<std::string> paths = options.furtherFiles;
    paths.insert(paths.begin(), path);
    FrameFiles files = listedFiles(paths);
    const std::string pattern = files.pattern();
    return openFiles(pattern, std::move(files), options);
  }
  std::error_code failure;
  if (std::filesystem::is_directory(path, failure)) return openDirectory(path, options);
  const bool exists = std::filesystem::exists(path, failure);
  if (exists && isExr(path)) return openFrameFiles(path, oneFile(path), options);
  if (!exists && isFramePattern(path)) return openFiles(path, findFrameFiles(path), options);
  throwFileError("open sequence", path, "a directory of frames or a multilayer OpenEXR file",
                 exists ? "a file that is none" : "no such directory");
}

}  // namespace quell::io
