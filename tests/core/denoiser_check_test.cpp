// Checks of frames in device buffers, in C++ and in C.
#include <catch2/catch.hpp>
#include <string>

#include "tests/core/c_denoiser.hpp"

namespace quell::tests {
namespace {

struct CheckedBuffers {
  explicit CheckedBuffers(const ImageSetup& setup = {})
      : buffers(device, setup),
        denoiser(device.context, device.device, device.queue, Settings(), testOptions()) {}

  OpenDevice device;
  FrameBuffers buffers;
  Denoiser denoiser;
};

Frame transposedCamera(Frame frame) {
  const Matrix4 given = frame.camera.worldToClip;
  for (std::size_t i = 0; i < 16; ++i) frame.camera.worldToClip[i] = given[4 * (i % 4) + i / 4];
  return frame;
}

}  // namespace

TEST_CASE("frames in order have no findings, whatever their layouts, prepared or not", "[core]") {
  ImageSetup setup;
  setup.radiance = setup.albedo = setup.emission = packedHalf(4);
  setup.objectId = interleaved(1, ComponentFormat::UInt32);
  setup.normalWorld = setup.positionWorld = interleaved(3);
  CheckedBuffers checked(setup);
  for (int number = 0; number < 3; ++number) {
    checked.buffers.upload(number);
    const FrameCheck check = checked.denoiser.checkFrame(checked.buffers.frame);
    CHECK(check.worst() == Severity::Note);
    REQUIRE_FALSE(check.figures.empty());
    CHECK(check.figures[0].name == "surface share");
  }
}

TEST_CASE("frames are compared with the one checked before, unless the history was reset", "[core]") {
  ImageSetup setup;
  setup.size = {64, 36};  // enough to tell noise by
  CheckedBuffers checked(setup);
  const auto kindsOf = [&] {
    std::string kinds;
    for (const Finding& finding : checked.denoiser.checkFrame(checked.buffers.frame).findings)
      if (finding.severity > Severity::Note) kinds += finding.kind + " ";
    return kinds;
  };
  CHECK(kindsOf() == "");
  CHECK(kindsOf().find("noise-frozen") != std::string::npos);  // the same buffers once more
  checked.denoiser.resetHistory();
  CHECK(kindsOf() == "");
}

TEST_CASE("what is wrong with a frame is said in C++ and in C alike", "[core][c]") {
  CheckedBuffers checked;
  const Frame frame = transposedCamera(checked.buffers.frame);
  const FrameCheck check = checked.denoiser.checkFrame(frame);
  REQUIRE(check.worst() == Severity::Wrong);
  CHECK(check.findings[0].kind == "camera-transposed");
  CHECK_THAT(toSentence(check.findings[0]), Catch::Contains("transpose") && Catch::Contains("px"));

  quell_denoiser* made = nullptr;
  REQUIRE(quellCreateDenoiser(checked.device.context(), checked.device.device(), checked.device.queue(),
                              nullptr, nullptr, &made) == QUELL_SUCCESS);
  const DenoiserHandle denoiser(made);
  const quell_frame given = toC(frame);
  quell_frame_check found;
  QUELL_INIT(found);
  REQUIRE(quellCheckFrame(made, &given, 0, nullptr, &found) == QUELL_SUCCESS);
  CHECK(found.worst == QUELL_WRONG);
  REQUIRE(found.findingCount == check.findings.size());
  quell_finding finding;
  QUELL_INIT(finding);
  REQUIRE(quellGetFinding(made, 0, &finding) == QUELL_SUCCESS);
  CHECK(finding.severity == QUELL_WRONG);
  CHECK(finding.kind == check.findings[0].kind);
  CHECK(finding.sentence == toSentence(check.findings[0]));
  CHECK(finding.pixels == check.findings[0].pixels);
  quell_check_figure figure;
  QUELL_INIT(figure);
  REQUIRE(found.figureCount == check.figures.size());
  REQUIRE(quellGetCheckFigure(made, 1, &figure) == QUELL_SUCCESS);
  CHECK(figure.name == check.figures[1].name);
  CHECK(figure.value == check.figures[1].value);
}

TEST_CASE("a check refuses what denoise would", "[core]") {
  CheckedBuffers checked;
  Frame frame = checked.buffers.frame;
  frame.normalWorld.channels = 2;
  CHECK_THROWS_AS(checked.denoiser.checkFrame(frame), Error);
  frame = checked.buffers.frame;
  frame.size.height += 1;
  CHECK_THROWS_WITH(checked.denoiser.checkFrame(frame),
                    Catch::Contains("checkFrame") && Catch::Contains("bytes"));
}

}  // namespace quell::tests
