// What `quell denoise` writes for other programs besides the denoised frame.
#pragma once

#include <memory>
#include <string>

#include "host/cli/common/denoise_session.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/io/exr_passes.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

struct FurtherOutputs {
  bool pfm = false;  ///< denoised_%04d.pfm
  bool accumulated =
      false;  ///< accumulated_%04d.exr: linear, the history of the method quell before its filter
  bool multilayer = false;  ///< multilayer_%04d.exr: what was read, and what was made of it

  bool any() const { return pfm || accumulated || multilayer; }
};

/// The settings that make a denoiser hand out its history: those of the method quell without filter and antialiasing. What
/// is set for that method stays.
Settings accumulationSettings(const Settings& settings, const io::FrameSequence& sequence);

class FurtherOutputWriter {
 public:
  /// `accumulation`: of accumulationSettings(), prepared for frames of the sequence; null where nothing wants it.
  FurtherOutputWriter(FurtherOutputs outputs, const OutputFiles& files, const io::FrameSequence& sequence,
                      int signals, std::unique_ptr<DenoiseSession> accumulation);

  /// Frames in order, each after its denoised image has been written. Throws Error(FileError).
  void write(const io::FrameData& frame, const DenoisedFrame& denoised);
  /// A frame before those, which the history takes in.
  void preroll(const io::FrameData& frame);

 private:
  void writeMultilayer(const io::FrameData& frame, const DenoisedFrame& denoised,
                       const io::Image& accumulated) const;

  FurtherOutputs m_outputs;
  const OutputFiles& m_files;
  const io::FrameSequence& m_sequence;
  int m_signals;
  std::unique_ptr<DenoiseSession> m_accumulation;
};

}  // namespace quell::cli
