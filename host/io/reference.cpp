#include "host/io/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <quell/error.hpp>

#include "host/io/frame_sequence.hpp"

namespace quell::io {
namespace {

struct KindFacts {
  const char* name;
  const char* filePrefix;
};

const KindFacts& factsOf(ReferenceKind kind) {
  static constexpr KindFacts kCentre{"centre", "ref"};
  static constexpr KindFacts kAntialiased{"antialiased", "ref_aa"};
  return kind == ReferenceKind::Centre ? kCentre : kAntialiased;
}

bool anyFrameHas(const FrameSequence& sequence, ReferenceKind kind) {
  const std::vector<int> frames = sequence.frames();
  return std::any_of(frames.begin(), frames.end(),
                     [&](int frame) { return sequence.hasReference(frame, kind); });
}

}  // namespace

const char* toString(ReferenceKind kind) { return factsOf(kind).name; }

std::string referenceStem(ReferenceKind kind, char half, const std::string& stem) {
  return fmt::format("{}_{}_{}", factsOf(kind).filePrefix, half, stem);
}

bool isReferenceName(const std::string& name) {
  for (const ReferenceKind kind : {ReferenceKind::Centre, ReferenceKind::Antialiased})
    for (const char half : {'a', 'b'})
      if (name.rfind(referenceStem(kind, half, ""), 0) == 0) return true;
  return false;
}

void requireReference(const FrameSequence& sequence, int frame, ReferenceKind kind) {
  if (sequence.hasReference(frame, kind)) return;
  throw Error(ErrorCode::InvalidArgument,
              {"read reference", sequence.name(), fmt::format("a frame with a reference, {}", toString(kind)),
               std::to_string(frame)});
}

References::References(const FrameSequence& sequence) : m_sequence(sequence) {
  const bool centre = anyFrameHas(sequence, ReferenceKind::Centre);
  const bool antialiased = anyFrameHas(sequence, ReferenceKind::Antialiased);
  const bool wanted = !centre || sequence.jittered();
  m_kind = antialiased && wanted ? ReferenceKind::Antialiased : ReferenceKind::Centre;
}

bool References::has(int frame) const { return m_sequence.hasReference(frame, m_kind); }

const std::optional<Reference>& References::of(int frame) {
  if (m_frame == frame) return m_reference;
  m_reference.reset();
  if (has(frame)) m_reference = m_sequence.reference(frame, m_kind);
  m_frame = frame;
  return m_reference;
}

}  // namespace quell::io
