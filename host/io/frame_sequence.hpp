// A sequence of noisy frames with their feature buffers, wherever they come from (files, or made up).
#pragma once

#include <memory>
#include <optional>
#include <quell/camera.hpp>
#include <string>
#include <vector>

#include "host/core/image_schema.hpp"
#include "host/io/image.hpp"
#include "host/io/reference.hpp"

namespace quell::io {

/// What a user should know about a frame that can be denoised all the same.
struct FrameWarning {
  /// Of each kind a sequence's first is worth telling.
  enum class Kind { Camera };
  Kind kind;
  std::string file;
  std::string expected;
  std::string got;
  std::string remedy;  ///< what is done about it, and what would cure it
};

/// One frame in host memory. Images share one size; an absent optional one is empty.
struct FrameData {
  int number = 0;  ///< frame number within its sequence, >= 0
  Camera camera;
  /// What they hold stands in quell/frame_images.h; channels as in files. Object ids are whole numbers up to 2^24.
#define QUELL_IMAGE(name, ...) Image name;
  QUELL_FRAME_IMAGES(QUELL_IMAGE)
#undef QUELL_IMAGE
  Image combined;  ///< 3 channels, linear radiance as a whole; only where two signals were asked for
  Image alpha;     ///< 1 channel, of the file of the light as a whole; empty where it has none
  std::vector<FrameWarning> warnings;
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
  virtual std::vector<int> frames() const = 0;  ///< frame numbers present, ascending, without gaps
  virtual FrameData read(int frame) const = 0;  ///< throws Error(FileError | InvalidArgument)
  /// The file that an image of a frame comes from, for messages.
  virtual std::string fileOf(int /*frame*/, const ImageFiles& /*files*/) const { return name(); }

  /// Whether there is a converged rendering of this kind; false for a frame that is not there. Reads no pixels.
  virtual bool hasReference(int frame, ReferenceKind kind) const = 0;
  /// That rendering. Throws Error(InvalidArgument) where there is none, Error(FileError) where it cannot be read.
  virtual Reference reference(int frame, ReferenceKind kind) const = 0;

  /// Whether the primary rays of some frame leave the centres of their pixels, as far as the files say.
  virtual bool jittered() const { return false; }

  /// The limits that ship with the data; nothing where it has none (the denoiser then derives its own).
  virtual std::optional<HistoryLimits> historyLimits() const { return std::nullopt; }
};

/// Opens a directory in a supported layout, or one multilayer file; which one is found by looking (see
/// cycles_sequence.hpp, bmfr_sequence.hpp and multilayer_sequence.hpp). `signals`: 1, or 2 for diffuse and glossy light
/// apart. Throws Error(FileError) saying what was looked for, or which layout has no two signals.
std::unique_ptr<FrameSequence> openSequence(const std::string& directory, int signals = 1);

}  // namespace quell::io
