// The schema of images: what its columns promise to each other and to programs that were built before.
#include "host/core/image_schema.hpp"

#include <quell/quell.h>

#include <catch2/catch.hpp>
#include <cstddef>
#include <quell/frame.hpp>
#include <set>
#include <string>

namespace quell::tests {

TEST_CASE("the schema of images agrees with itself", "[core]") {
  std::set<std::string> names, stems;
  for (const auto& image : kInputs<Frame>) {
    CAPTURE(image.name);
    CHECK(names.insert(image.name).second);
    CHECK((!image.hasFiles() || stems.insert(image.files.stem).second));
    const std::string channels = image.files.channels;
    CHECK((channels == "RGB" || channels == "RG" || channels == "Y"));  // what writeExr() writes
    CHECK(image.fileChannels() >= image.leastChannels);
    CHECK(image.fileChannels() <= image.mostChannels);
    CHECK(image.files.role[0] != '\0');
    CHECK(image.required() == std::string(image.texts.absent).empty());
    CHECK(image.identifiers() == (image.files.samples == FileSamples::UINT));
  }
}

// Programs pass structs of the header that they were built with: members keep their places, new ones come last.
TEST_CASE("images of the C API stay where they are", "[core][c]") {
  constexpr std::size_t kFirst = offsetof(quell_frame, radiance), kView = sizeof(quell_image_view);
  CHECK(offsetof(quell_frame, glossyRadiance) == kFirst + kView);
  CHECK(offsetof(quell_frame, normalWorld) == kFirst + 2 * kView);
  CHECK(offsetof(quell_frame, positionWorld) == kFirst + 3 * kView);
  CHECK(offsetof(quell_frame, viewDepth) == kFirst + 4 * kView);
  CHECK(offsetof(quell_frame, albedo) == kFirst + 5 * kView);
  CHECK(offsetof(quell_frame, glossColor) == kFirst + 6 * kView);
  CHECK(offsetof(quell_frame, roughness) == kFirst + 7 * kView);
  CHECK(offsetof(quell_frame, f0) == kFirst + 8 * kView);
  CHECK(offsetof(quell_frame, emission) == kFirst + 9 * kView);
  CHECK(offsetof(quell_frame, motion) == kFirst + 10 * kView);
  CHECK(offsetof(quell_frame, objectId) == kFirst + 11 * kView);
  CHECK(offsetof(quell_frame, hitDistance) == kFirst + 12 * kView);
  CHECK(offsetof(quell_output, display) == offsetof(quell_output, linear) + kView);
}

}  // namespace quell::tests
