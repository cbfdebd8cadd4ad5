#include "host/io/motion_kind.hpp"

#include <quell/error.hpp>
#include <sstream>

namespace quell::io {
namespace {

struct Word {
  const char* word;
  void (*apply)(MotionKind& kind);
};

constexpr Word kWords[] = {
    {"px", [](MotionKind& kind) { kind.unit = MotionKind::Unit::Px; }},
    {"ndc", [](MotionKind& kind) { kind.unit = MotionKind::Unit::Ndc; }},
    {"uv", [](MotionKind& kind) { kind.unit = MotionKind::Unit::Uv; }},
    {"y-down", [](MotionKind& kind) { kind.yUp = false; }},
    {"y-up", [](MotionKind& kind) { kind.yUp = true; }},
    {"to-previous", [](MotionKind& kind) { kind.fromPrevious = false; }},
    {"from-previous", [](MotionKind& kind) { kind.fromPrevious = true; }},
};

/// Pixels for each unit along a side of so many pixels.
float pixelsOf(MotionKind::Unit unit, int side) {
  return unit == MotionKind::Unit::Px   ? 1.0f
         : unit == MotionKind::Unit::Uv ? float(side)
                                        : 0.5f * float(side);
}

}  // namespace

MotionKind parseMotionKind(const std::string& text) {
  MotionKind kind;
  std::istringstream words(text);
  bool known = !text.empty() && text.back() != '/';
  for (std::string word; std::getline(words, word, '/');) {
    bool found = false;
    for (const Word& one : kWords) {
      if (word != one.word) continue;
      one.apply(kind);
      found = true;
    }
    known = known && found;
  }
  if (known) return kind;
  std::string all;
  for (const Word& one : kWords) all += (all.empty() ? "" : ", ") + std::string(one.word);
  throw Error(
      ErrorCode::InvalidArgument,
      {"open sequence", "--channels", "a kind of motion: words of " + all + ", with / between them", text});
}

std::string toString(const MotionKind& kind) {
  std::string text;
  const auto add = [&](const char* word) { text += (text.empty() ? "" : "/") + std::string(word); };
  if (kind.unit == MotionKind::Unit::Ndc) add("ndc");
  if (kind.unit == MotionKind::Unit::Uv) add("uv");
  if (kind.yUp) add("y-up");
  if (kind.fromPrevious) add("from-previous");
  return text;
}

void toContract(Image& motion, const MotionKind& kind, int pictureWidth, int pictureHeight) {
  const float sign = kind.fromPrevious ? -1.0f : 1.0f;
  const float x = sign * pixelsOf(kind.unit, pictureWidth);
  const float y = (kind.yUp ? -sign : sign) * pixelsOf(kind.unit, pictureHeight);
  if (x == 1.0f && y == 1.0f) return;
  for (std::size_t i = 0; i + 1 < motion.pixels.size(); i += 2) {
    motion.pixels[i] *= x;
    motion.pixels[i + 1] *= y;
  }
}

}  // namespace quell::io
