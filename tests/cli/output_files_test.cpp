#include "host/cli/common/output_files.hpp"

#include <ImfStandardAttributes.h>

#include <catch2/catch.hpp>

#include "tests/support/exr_parts.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell;
using namespace quell::tests;

TEST_CASE("outputs have the windows, the alpha and the attributes of the frame's colour") {
  const TemporaryDirectory directory;
  io::FrameData frame;
  frame.number = 3;
  frame.alpha = noiseImage(6, 4, 1, 1);
  frame.origin.windows = {{10, 20, 6, 4}, {0, 0, 64, 48}};
  Imf::Header header(boxOf(frame.origin.windows.display), boxOf(frame.origin.windows.data));
  Imf::addComments(header, "shot 12");
  frame.origin.attributes = std::make_shared<const Imf::Header>(header);
  const cli::DenoisedFrame denoised{noiseImage(6, 4, 3, 2), noiseImage(6, 4, 3, 3)};
  const cli::OutputFiles files(directory.path(), cli::OutputFormats{false, true, io::ExrType::Float});
  files.write(frame, denoised);
  for (const char* name : {"denoised_0003.exr", "display_0003.exr"}) {
    const io::ExrHeader written = io::readExrHeader(directory.file(name));
    CHECK(written.windows.data == frame.origin.windows.data);
    CHECK(written.windows.display == frame.origin.windows.display);
    CHECK(Imf::comments(*written.attributes) == "shot 12");
    CHECK(samePixels(io::readExr(directory.file(name), {"A"}), frame.alpha));
  }
  CHECK(samePixels(io::readExrRgb(directory.file("denoised_0003.exr")), denoised.linear));
}
