// The schema of images (quell/frame_images.h) as tables, for code that treats all images alike.
#pragma once

#include <quell/frame_images.h>

#include <cstddef>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace quell {

// Enumerators as the schema spells them.
enum class ImageKind { VALUES, IDENTIFIERS };
enum class ImagePresence { REQUIRED, OPTIONAL };
enum class FileSamples { HALF, FLOAT, UINT };

struct ImageFiles {
  const char* stem;      ///< empty: no files of its own
  const char* channels;  ///< names, one letter each
  FileSamples samples;
  const char* role;  ///< what --channels calls it; empty: an output
};

struct ImageTexts {
  const char* absent;
  const char* unit;
  const char* range;
  const char* broken;
};

/// What the schema says about an image; see there.
struct ImageFacts {
  const char* name;
  int leastChannels;
  int mostChannels;
  ImageKind kind;
  ImagePresence presence;
  ImageFiles files;
  ImageTexts texts;

  constexpr bool required() const { return presence == ImagePresence::REQUIRED; }
  constexpr bool identifiers() const { return kind == ImageKind::IDENTIFIERS; }
  constexpr bool hasFiles() const { return files.stem[0] != '\0'; }
  constexpr int fileChannels() const { return static_cast<int>(std::string_view(files.channels).size()); }
};

/// An image, and the member of a struct that stands for it there.
template <class Owner, class Image>
struct ImageMember : ImageFacts {
  Image Owner::*member;
};

#define QUELL_IMAGE_FILES(stem, channels, samples, role) \
  { stem, channels, FileSamples::samples, role }
#define QUELL_IMAGE_TEXTS(absent, unit, range, broken) \
  { absent, unit, range, broken }
#define QUELL_IMAGE_MEMBER(name, NAME, least, most, kind, presence, files, texts)          \
  {{#name, least, most, ImageKind::kind, ImagePresence::presence, QUELL_IMAGE_FILES files, \
    QUELL_IMAGE_TEXTS texts},                                                              \
   &Owner::name},

/// The inputs of a struct that has a member for each of them: Frame, quell_frame, io::FrameData. The same order for all.
template <class Owner>
inline constexpr ImageMember<Owner, decltype(Owner::radiance)> kInputs[] = {
    QUELL_FRAME_IMAGES(QUELL_IMAGE_MEMBER)};

/// The outputs: Output, quell_output.
template <class Owner>
inline constexpr ImageMember<Owner, decltype(Owner::linear)> kOutputs[] = {
    QUELL_OUTPUT_IMAGES(QUELL_IMAGE_MEMBER)};

#undef QUELL_IMAGE_MEMBER
#undef QUELL_IMAGE_TEXTS
#undef QUELL_IMAGE_FILES

/// What the schema says about one member.
template <class Owner, class Image>
constexpr const ImageFacts& factsOf(Image Owner::*member) {
  const ImageFacts* found = nullptr;
  for (const auto& input : kInputs<Owner>)
    if (input.member == member) found = &input;
  return *found;
}

/// Calls work(facts, one.*image, other.*image) for every input of two structs.
template <class One, class Other, class Work>
void forEachInput(One& one, Other& other, Work&& work) {
  constexpr auto& ones = kInputs<std::remove_const_t<One>>;
  constexpr auto& others = kInputs<std::remove_const_t<Other>>;
  for (std::size_t i = 0; i < std::size(ones); ++i)
    work(static_cast<const ImageFacts&>(ones[i]), one.*ones[i].member, other.*others[i].member);
}

}  // namespace quell
