// Renders a scene into a directory.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/render/sequence_writer.hpp"

namespace quell::render {

struct RenderOptions {
  SequenceSettings settings;
  int frameCount = 30;               ///< frames 0 to frameCount - 1, in [1, 10000]
  std::string output;                ///< directory
  std::vector<int> referenceFrames;  ///< with referenceSamples > 0; empty: the scene's default
  std::string device;                ///< as for chooseDevice()
  std::string cacheDirectory;        ///< for compiled kernels; empty: none
};

struct RenderReport {
  std::string device;
  int framesRendered = 0;
  int framesKept = 0;  ///< there already and whole
  int halvesRendered = 0;
  int halvesKept = 0;
};

/// Called after each piece of work with how much of all is done, in (0, 1], and what it was.
using RenderProgress = std::function<void(double share, const std::string& what)>;

/// The last frame, and the one that the scene names besides, if it is among the frames.
std::vector<int> defaultReferenceFrames(const SceneEntry& scene, int frameCount);

/// Frames and halves that are in the directory and whole are kept. Throws Error(InvalidArgument) for an unknown scene,
/// sizes, counts or frames out of range or a directory with another rendering, Error(FileError) for files that cannot
/// be written, and what PathTracer throws.
RenderReport renderSequence(const RenderOptions& options, const RenderProgress& progress = {});

}  // namespace quell::render
