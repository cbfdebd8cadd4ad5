// What a check of a frame finds out: Denoiser::checkFrame(), `quell check`.
#pragma once

#include <quell/api.h>

#include <cstddef>
#include <string>
#include <vector>

namespace quell {

/// How bad it is.
enum class Severity {
  Note,      ///< worth knowing; the frame is as the contract says
  Doubtful,  ///< may be meant, and costs quality where it isn't
  Wrong,     ///< against the contract (quell/frame_images.h)
};

/// "note", "doubtful" or "wrong".
QUELL_API const char* toString(Severity severity);

/// One thing that is odd about a frame.
struct Finding {
  std::string
      kind;  ///< for example "camera-transposed"; stable across releases, docs/check.md lists them all
  Severity severity = Severity::Note;  ///< how bad it is
  std::string image;                   ///< the member of Frame that it is about, "camera" for its matrices
  std::string expected;                ///< what the contract says
  std::string got;                     ///< what was measured, with units
  std::string cure;                    ///< what most likely sets it right
  std::size_t pixels = 0;              ///< how many show it; 0 where it is about the frame as a whole
};

/// Finding::got with the number of pixels, where there is one.
QUELL_API std::string gotText(const Finding& finding);

/// "normalWorld: expected ..., got ... (N pixels); CURE".
QUELL_API std::string toSentence(const Finding& finding);

/// Something measured, whether or not it is odd.
struct CheckFigure {
  std::string name;    ///< for example "surface share"
  double value = 0.0;  ///< in `unit`
  std::string unit;    ///< for example "%" or "px"; empty: a plain number
};

/// What Denoiser::checkFrame() has found.
struct FrameCheck {
  std::vector<CheckFigure> figures;  ///< in the order in which they were measured
  std::vector<Finding> findings;     ///< causes before what follows from them

  /// Of the findings; Note if there are none.
  QUELL_API Severity worst() const;
};

}  // namespace quell
