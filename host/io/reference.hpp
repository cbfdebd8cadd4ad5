// Converged renderings to compare a frame with, and which of them fits which output.
#pragma once

#include <optional>
#include <string>

#include "host/io/image.hpp"

namespace quell::io {

class FrameSequence;

/// Where the primary rays of a reference went, and with that what it measures.
enum class ReferenceKind {
  Centre,       ///< through pixel centres, as those of unjittered noisy frames: denoised light
  Antialiased,  ///< all over the pixel (box filter, 1 px): the picture that people look at
};

/// "centre" or "antialiased", as reports say it.
const char* toString(ReferenceKind kind);

/// What the file of one half, 'a' or 'b', of a reference is called where `stem` names the image that it belongs to, for
/// example ref_aa_b_color.
std::string referenceStem(ReferenceKind kind, char half, const std::string& stem);

/// Two independent converged renderings of one frame (linear, 3 channels). Their mean is the reference.
/// With one half only, `b` is empty.
struct Reference {
  Image a;
  Image b;
  ReferenceKind kind = ReferenceKind::Centre;
};

/// Throws Error(InvalidArgument) unless the sequence has this reference.
void requireReference(const FrameSequence& sequence, int frame, ReferenceKind kind);

/// What the outputs of one frame are compared with.
struct FrameReferences {
  Reference linear;                  ///< for the noisy input, too
  std::optional<Reference> another;  ///< for the display output where that takes another kind
  const Reference& display() const { return another ? *another : linear; }
};

/// The references of a sequence: which kinds its outputs are compared with, and those of the latest frame.
class References {
 public:
  /// Looks which files there are.
  explicit References(const FrameSequence& sequence);

  /// Of pixel centres if any frame has such a reference.
  ReferenceKind linearKind() const { return m_linearKind; }
  /// After temporal antialiasing: antialiased where rays are jittered and any frame has such a reference, else as for
  /// linear output.
  ReferenceKind displayKind() const { return m_displayKind; }

  /// True if the frame has what both outputs are compared with; reads no pixels.
  bool has(int frame) const;
  /// Nothing where has() is false. Throws what FrameSequence::reference() throws.
  const std::optional<FrameReferences>& of(int frame);

 private:
  const FrameSequence& m_sequence;
  ReferenceKind m_linearKind;
  ReferenceKind m_displayKind;
  std::optional<int> m_frame;
  std::optional<FrameReferences> m_references;
};

}  // namespace quell::io
