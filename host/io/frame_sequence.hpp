// A sequence of noisy frames with their feature buffers, wherever they come from (files, or made up).
#pragma once

#include <memory>
#include <optional>
#include <quell/camera.hpp>
#include <string>
#include <vector>

#include "host/core/image_schema.hpp"
#include "host/io/channel_map.hpp"
#include "host/io/frame_files.hpp"
#include "host/io/image.hpp"
#include "host/io/reference.hpp"

namespace quell::io {

/// What a user should know about a frame that can be denoised all the same.
struct FrameWarning {
  /// Of each kind a sequence's first is worth telling.
  enum class Kind { Camera, CameraConvention, MissingFrames, Windows };
  Kind kind;
  std::string file;
  std::string expected;
  std::string got;
  std::string remedy;  ///< what is done about it, and what would cure it
};

/// One frame in host memory. Images share one size; an absent optional one is empty.
struct FrameData {
  int number = 0;  ///< frame number within its sequence
  Camera camera;
  /// What they hold stands in quell/frame_images.h; channels as in files. Object ids are whole numbers up to 2^24.
#define QUELL_IMAGE(name, ...) Image name;
  QUELL_FRAME_IMAGES(QUELL_IMAGE)
#undef QUELL_IMAGE
  Image combined;    ///< 3 channels, linear radiance as a whole; only where two signals were asked for
  Image alpha;       ///< 1 channel, of the file of the light as a whole; empty where it has none
  ExrOrigin origin;  ///< windows and attributes of that file, for what is made from the frame
  std::vector<FrameWarning> warnings;
  bool afterGap = false;      ///< the frame before is missing: what is older is no history
  bool repeatsNoise = false;  ///< noise and view are those of the frame before: history is no further sample
  /// True where light is already divided by albedo and gloss colour (two signals, and the layout published with
  /// the BMFR paper).
  bool demodulated = false;

  /// The noisy picture of the frame, or what comes nearest to it.
  const Image& noisy() const { return combined.empty() ? radiance : combined; }
  /// True if the denoised frame may be compared with a reference picture.
  bool comparable() const { return !demodulated || !combined.empty(); }
};

/// How far apart a surface point and the history sample found for it may be, as published with a data set.
/// Both are limits of squared Euclidean distances; a sample at or beyond a limit is rejected.
struct HistoryLimits {
  double positionSquared = 0.0;  ///< scene units squared, > 0
  double normalSquared = 0.0;    ///< of unit normals, in (0, 4]
};

/// Reads frames one at a time, so that memory does not grow with the length of the sequence.
class FrameSequence {
 public:
  virtual ~FrameSequence() = default;
  virtual std::string name() const = 0;         ///< for messages, for example the directory
  virtual int width() const = 0;                ///< pixels, >= 1
  virtual int height() const = 0;               ///< pixels, >= 1
  virtual std::vector<int> frames() const = 0;  ///< frame numbers present, ascending
  virtual FrameData read(int frame) const = 0;  ///< throws Error(FileError | InvalidArgument)
  /// Looks into the headers of all files of these frames, so that what is unlike the first frame is known before
  /// anything is made of the others. Throws what read() throws of windows, channels and headers.
  virtual void requireReadable(const std::vector<int>& /*frames*/) const {}
  /// The file that an image of a frame comes from, for messages.
  virtual std::string fileOf(int /*frame*/, const ImageFiles& /*files*/) const { return name(); }

  /// Whether there is a converged rendering of this kind; false for a frame that is not there. Reads no pixels.
  virtual bool hasReference(int frame, ReferenceKind kind) const = 0;
  /// That rendering. Throws Error(InvalidArgument) where there is none, Error(FileError) where it cannot be read.
  virtual Reference reference(int frame, ReferenceKind kind) const = 0;

  /// Whether the primary rays of some frame leave the centres of their pixels, as far as the files say.
  virtual bool jittered() const { return false; }

  /// Which channels the images come from, and which images are missing and cost quality, to be told once; each a line.
  virtual std::vector<std::string> describeChannels() const { return {}; }

  /// The limits that ship with the data; nothing where it has none (the denoiser then derives its own).
  virtual std::optional<HistoryLimits> historyLimits() const { return std::nullopt; }
};

/// What to open, and how.
struct SequenceOptions {
  SequenceOptions(int numberOfSignals = 1, MissingFrames missingFrames = MissingFrames::Refuse)
      : signals(numberOfSignals), missing(missingFrames) {}

  int signals;  ///< 1, or 2 for diffuse and glossy light apart
  MissingFrames missing;
  /// Further files of the sequence whose first one is opened, as shells make them of a glob.
  std::vector<std::string> furtherFiles;
  ChannelOptions
      channels;  ///< anything but the default: files are read by their channels, whatever the layout
};

/// Opens a directory in a supported layout, one multilayer file, or a pattern of files (frame_files.hpp): numbered
/// multilayer files, or those of the colour in the layout of separate files. Which one it is is found by looking (see
/// cycles_sequence.hpp, bmfr_sequence.hpp and multilayer_sequence.hpp); where `options.channels` says anything, files are
/// read by their channels. Throws Error(FileError) saying what was looked for, which layout has no two signals, or which
/// two sequences lie in one directory.
std::unique_ptr<FrameSequence> openSequence(const std::string& path, const SequenceOptions& options = {});

}  // namespace quell::io
