// The channels of a frame, wherever they are: one file with all of them, or a file for each pass.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/io/channel_map.hpp"
#include "host/io/exr_file.hpp"
#include "host/io/frame_files.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::io {

/// The image that files stand for: their windows, attributes and alpha are the frame's.
constexpr const char* kColor = factsOf(&FrameData::radiance).files.role;

/// Files that hold passes of the same frames.
struct PassFiles {
  std::string name;  ///< their channels are called NAME.CHANNEL; empty: as they are in the file
  FrameFiles files;
};

/// Sequences as passes, named as the files are without number and what separates it: ALBEDO_0001.exr and 0001_ALBEDO.exr
/// are ALBEDO.
std::vector<PassFiles> passFilesOf(std::vector<FrameFiles> sequences);

class ChannelFiles {
 public:
  /// Looks into the first file of each pass. `name` is what messages call the sequence. Throws what findChannels() throws,
  /// and Error(FileError): a gap, or a frame without one of the files that are needed.
  ChannelFiles(std::string name, std::vector<PassFiles> passes, const ChannelOptions& options,
               MissingFrames missing);

  const ChannelMap& map() const { return m_map; }
  const std::vector<int>& frames() const { return m_frames; }
  const PictureWindows& windows() const { return m_windows; }
  bool has(const std::string& image) const { return m_map.has(image); }
  /// What the image's numbers mean; the default where there is none.
  NumberKind kindOf(const std::string& image) const;
  /// Throws Error(FileError) that says how the image may be called, what would do as well and which channels there are.
  void require(const std::string& image, const std::string& otherwise = {}) const;
  /// Of the colour where `image` has none; the one that it would have for a frame that is not there.
  std::string fileOf(int frame, const std::string& image = kColor) const;
  /// Where the files lie.
  const std::string& directory() const;

  /// An image that there is, of data.number, within the windows; see readWithin(). Its terms are summed up. `files` are
  /// those of the frame.
  Image read(OpenFiles& files, FrameData& data, const std::string& image) const;
  /// As FrameSequence::requireReadable(), of one frame.
  void requireReadable(int frame) const;
  /// Windows and attributes of the frame's colour. Throws Error(FileError) where its windows are not those of the first
  /// frame.
  ExrOrigin origin(OpenFiles& files, int frame) const;

  /// The half of a reference that lies beside the frame's colour: ref_a_NAME of a file NAME, or ref_a_color_NNNN.exr, as
  /// referenceStem() has them. Empty where there is none.
  std::string referenceFile(int frame, ReferenceKind kind, char half) const;
  /// Its channels of the colour's names, else R G B, within the windows.
  Image readReference(const std::string& path) const;

 private:
  /// A channel's pass, and its name in the files of that.
  struct Place {
    std::size_t pass;
    std::string name;
  };
  /// Channels that follow each other in one pass, from the `first` of an image's on.
  struct PassChannels {
    std::size_t pass;
    std::size_t first;
    std::vector<std::string> names;
  };
  std::vector<PassChannels> byPass(const std::vector<std::string>& channels) const;
  Image readTerm(OpenFiles& files, FrameData& data, const std::vector<std::string>& channels) const;
  std::vector<std::string> referenceChannels(const ExrFile& file) const;
  const PassFiles& passOf(const std::string& image) const;
  void lookInto(const PassFiles& pass, std::size_t index, std::vector<std::string>& views);

  std::string m_name;
  ChannelOptions m_options;
  std::vector<PassFiles> m_passes;
  std::vector<std::string> m_channels;
  std::map<std::string, Place> m_places;
  ChannelMap m_map;
  std::vector<int> m_frames;
  PictureWindows m_windows;
};

}  // namespace quell::io
