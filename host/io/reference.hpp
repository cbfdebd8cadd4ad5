// Converged renderings to compare a frame with, and which of them fits a sequence.
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

/// Whether a file of this name is one.
bool isReferenceName(const std::string& name);

/// Two independent converged renderings of one frame (linear, 3 channels). Their mean is the reference.
/// With one half only, `b` is empty.
struct Reference {
  Image a;
  Image b;
  ReferenceKind kind = ReferenceKind::Centre;
};

/// Throws Error(InvalidArgument) unless the sequence has this reference.
void requireReference(const FrameSequence& sequence, int frame, ReferenceKind kind);

/// The references of a sequence: which kind its frames are compared with, and that of the latest frame.
class References {
 public:
  /// Looks which files there are.
  explicit References(const FrameSequence& sequence);

  /// Of pixel centres if any frame has such a reference, unless rays are jittered, whose outputs are both antialiased.
  ReferenceKind kind() const { return m_kind; }

  /// Reads no pixels.
  bool has(int frame) const;
  /// Nothing where has() is false. Throws what FrameSequence::reference() throws.
  const std::optional<Reference>& of(int frame);

 private:
  const FrameSequence& m_sequence;
  ReferenceKind m_kind;
  std::optional<int> m_frame;
  std::optional<Reference> m_reference;
};

}  // namespace quell::io
