// Frames whose images are channels of OpenEXR files, as renderers name them (channel_names.hpp): all in one file for each
// frame, of one part or several, or a file for each pass.
//
// Needed: color, normal, and position or depth. Read where there are any: the other images of the contract
// (quell/frame_images.h). Two signals need diffuse, glossy, albedo and gloss_color besides; what they do not explain of the
// colour stays in the picture (light_remainder.hpp).
//
// The camera comes from camera.json beside the files (camera_file.hpp), whose frame numbers are those of the file names, or
// from the headers of the files (exr_camera.hpp). Without, it follows from positions, and best from position and depth:
// each is a linear function of the other, up to the pixel; distances along rays (ray_depth.hpp) and positions alone
// (position_depth.hpp) do as well. Motion is turned to that of the contract
// (motion_kind.hpp). Alpha of the colour is kept beside the frame.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/io/camera_fit.hpp"
#include "host/io/channel_files.hpp"
#include "host/io/declared_cameras.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::io {

/// Those that are no references (reference.hpp), unless there are no others.
std::vector<FrameFiles> withoutReferences(std::vector<FrameFiles> sequences);

/// The multilayer files of a directory; empty where there are none. Throws Error(FileError) naming both where there are
/// two sequences.
FrameFiles findMultilayerFiles(const std::string& directory, const ChannelOptions& options = {});

class MultilayerSequence final : public FrameSequence {
 public:
  /// `name` is what messages call the sequence. Throws what ChannelFiles throws, and Error(FileError): an image that is
  /// missing (names it), no camera.json and not both of position and depth.
  MultilayerSequence(std::string name, std::vector<PassFiles> passes, const SequenceOptions& options);

  std::string name() const override { return m_name; }
  int width() const override { return m_files.windows().data.width; }
  int height() const override { return m_files.windows().data.height; }
  std::vector<int> frames() const override { return m_files.frames(); }
  /// Throws Error(InvalidArgument) for a frame that is not there or an image of another size, Error(FileError) for an
  /// unreadable file. Where no camera can be found (all surfaces in one plane, or none at all), the frame has that of the
  /// last one before that has one, else standInCamera(), and a warning.
  FrameData read(int frame) const override;
  void requireReadable(const std::vector<int>& frames) const override;
  std::string fileOf(int frame, const ImageFiles& files) const override;
  std::vector<std::string> describeChannels() const override { return describe(m_files.map()); }
  bool hasReference(int frame, ReferenceKind kind) const override;
  Reference reference(int frame, ReferenceKind kind) const override;

 private:
  void openCameras(const std::string& directory);
  void requireImages() const;
  Image readOne(int frame, const char* image) const;
  Image readPositions(OpenFiles& files, FrameData& data) const;
  void readMotion(FrameData& data) const;
  DepthKind depthKind() const;
  /// For cameras that follow from it.
  Image viewDepth(int frame, const Image& positions) const;
  const FoundCamera& foundCamera(int frame) const;
  std::optional<Matrix4> headerCamera(int frame, const Image& positions) const;
  std::optional<int> lastFrameWithCamera(int frame) const;  ///< up to this one
  Matrix4 worldToClipOf(int frame) const;
  void setCamera(FrameData& data) const;

  std::string m_name;
  ChannelFiles m_files;
  DeclaredCameras m_cameras;                   ///< empty: found from the passes
  bool m_headerCameras = false;                ///< in the headers of the files
  mutable std::optional<std::size_t> m_form;   ///< which of headerCameras() the first frame shows to be meant
  mutable std::map<int, FoundCamera> m_found;  ///< by frame; looking takes longer than reading
  int m_signals = 1;
};

}  // namespace quell::io
