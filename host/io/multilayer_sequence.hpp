// Multilayer OpenEXR files as Blender's Cycles writes them: all passes of a frame in one file, named
// <view layer>.<pass>.<channel>.
//
// Needed: Combined, Normal, and Position or Depth. Read where a file has them: the passes of the other images of the
// contract (quell/frame_images.h). Two signals need DiffDir, DiffInd, GlossDir, GlossInd, DiffCol and GlossCol besides.
//
// The camera comes from camera.json beside the files (camera_file.hpp), whose frame numbers are those of the file names, or
// from the headers of the files (exr_camera.hpp). Without, it follows from Position and Depth: each is a linear function of the other, up to the pixel.
// Alpha of Combined is kept beside the frame.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/io/camera_fit.hpp"
#include "host/io/declared_cameras.hpp"
#include "host/io/frame_files.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::io {

/// Whether the file is there and has a channel that ends with .Combined.R.
bool isMultilayerFile(const std::string& path);

/// The multilayer files of a directory; empty where there are none. Throws Error(FileError) naming both where there are
/// two sequences.
FrameFiles findMultilayerFiles(const std::string& directory);

class MultilayerSequence final : public FrameSequence {
 public:
  /// `name` is what messages call the sequence. Throws Error(FileError): no view layer or several, a pass that is missing
  /// (names it), a gap in the numbers, no camera.json and not both of Position and Depth.
  MultilayerSequence(std::string name, FrameFiles files, int signals,
                     MissingFrames missing = MissingFrames::Refuse);

  std::string name() const override { return m_name; }
  int width() const override { return m_width; }
  int height() const override { return m_height; }
  std::vector<int> frames() const override { return m_frames; }
  /// Throws Error(InvalidArgument) for a frame that is not there or an image of another size, Error(FileError) for an
  /// unreadable file. Where no camera can be found (all surfaces in one plane, or none at all), the frame has that of the
  /// last one before that has one, else standInCamera(), and a warning.
  FrameData read(int frame) const override;
  std::string fileOf(int frame, const ImageFiles&) const override { return m_files.path(frame); }
  bool hasReference(int frame, ReferenceKind kind) const override;
  Reference reference(int frame, ReferenceKind kind) const override;

 private:
  void openCameras(const std::string& directory);
  void requirePasses() const;
  std::vector<std::string> channelsOf(const std::string& pass, const std::string& letters) const;
  bool hasPass(const std::string& pass, const std::string& letters) const;
  bool hasImage(const ImageFiles& files) const;
  Image readImage(int frame, const ImageFiles& files) const;
  Image readPositions(int frame, const Matrix4& worldToClip) const;
  const FoundCamera& foundCamera(int frame) const;
  std::optional<Matrix4> headerCamera(int frame, const Image& positions) const;
  std::optional<int> lastFrameWithCamera(int frame) const;  ///< up to this one
  Matrix4 worldToClipOf(int frame) const;
  void setCamera(FrameData& data) const;

  std::string m_name;
  FrameFiles m_files;
  std::vector<int> m_frames;
  DeclaredCameras m_cameras;                   ///< empty: found from the passes
  bool m_headerCameras = false;                ///< in the headers of the files
  mutable std::optional<std::size_t> m_form;   ///< which of headerCameras() the first frame shows to be meant
  mutable std::map<int, FoundCamera> m_found;  ///< by frame; looking takes longer than reading
  std::vector<std::string> m_channels;
  std::string m_layer;
  int m_width = 0;
  int m_height = 0;
  int m_signals = 1;
};

}  // namespace quell::io
