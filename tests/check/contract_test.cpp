// What renderers hand over instead of what the contract says: each told by its name, and what is right told to be right.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/check/plane_frames.hpp"
#include "tests/support/check_kinds.hpp"

namespace quell::tests {
namespace {

using Twist = std::function<void(io::FrameData&)>;

struct Row {
  const char* name;
  const char* kind;  ///< of the only finding; "" where there is none
  Severity severity;
  Twist twist;
  bool depth = false;
};

void each(io::Image& image, const std::function<float(float)>& change) {
  for (float& value : image.pixels) value = change(value);
}

void cameras(io::FrameData& frame, const std::function<void(Matrix4&)>& change) {
  change(frame.camera.worldToClip);
  change(frame.camera.worldToClipPrev);
}

void negateRow(Matrix4& matrix, std::size_t row) {
  for (std::size_t i = 4 * row; i < 4 * row + 4; ++i) matrix[i] = -matrix[i];
}

double angleOf(const io::FrameData& frame) { return -0.2 + 0.02 * frame.number; }

void rayDistance(io::FrameData& frame) {
  for (int y = 0; y < kPlaneHeight; ++y)
    for (int x = 0; x < kPlaneWidth; ++x) {
      const double u = ((x + 0.5) / kPlaneWidth * 2 - 1) * kPlaneWidth / kPlaneHeight,
                   v = 1 - (y + 0.5) / kPlaneHeight * 2;
      frame.viewDepth.at(x, y, 0) *= float(std::sqrt(1.0 + u * u + v * v));
    }
}

void viewNormals(io::FrameData& frame) {
  for (int y = 0; y < kPlaneHeight; ++y)
    for (int x = 0; x < kPlaneWidth; ++x) {
      frame.normalWorld.at(x, y, 0) = float(-std::sin(angleOf(frame)));
      frame.normalWorld.at(x, y, 2) = float(std::cos(angleOf(frame)));
    }
}

void viewPositions(io::FrameData& frame) {
  const float c = float(std::cos(angleOf(frame))), s = float(std::sin(angleOf(frame)));
  for (std::size_t i = 0; i < frame.positionWorld.pixels.size(); i += 3) {
    float* p = &frame.positionWorld.pixels[i];
    const float x = p[0] - float(0.3 + 0.05 * frame.number), y = p[1] - 0.8f, z = p[2] - 5.0f;
    p[0] = c * x - s * z;
    p[1] = y;
    p[2] = s * x + c * z;
  }
}

void leftHanded(io::FrameData& frame) {
  for (std::size_t i = 0; i < frame.positionWorld.pixels.size(); i += 3)
    frame.positionWorld.pixels[i] *= -1.0f;
  cameras(frame, [](Matrix4& m) {
    for (std::size_t row = 0; row < 4; ++row) m[4 * row] = -m[4 * row];
  });
}

std::vector<Row> depthRows() {
  const auto change = [](float (*of)(float)) { return [of](io::FrameData& f) { each(f.viewDepth, of); }; };
  return {
      {"view depth", "", Severity::Note, [](io::FrameData&) {}, true},
      {"ray distance", "depth-ray", Severity::Wrong, rayDistance, true},
      {"hyperbolic", "depth-hyperbolic", Severity::Wrong,
       change([](float d) { return 100.0f / 99.9f * (1.0f - 0.1f / d); }), true},
      {"reversed", "depth-reversed", Severity::Wrong, change([](float d) { return 0.1f / d; }), true},
      {"negative", "depth-negative", Severity::Wrong, change([](float d) { return -d; }), true},
  };
}

std::vector<Row> geometryRows() {
  return {
      {"right", "", Severity::Note, [](io::FrameData&) {}},
      {"transposed", "camera-transposed", Severity::Wrong, [](io::FrameData& f) { cameras(f, transpose); }},
      {"rows bottom up", "image-flipped-y", Severity::Wrong, turnOver},
      {"rows bottom up, NDC too", "rows-bottom-up", Severity::Note,
       [](io::FrameData& f) {
         turnOver(f);
         cameras(f, [](Matrix4& m) { negateRow(m, 1); });
       }},
      {"normals of length 4", "normal-length", Severity::Note,
       [](io::FrameData& f) { each(f.normalWorld, [](float n) { return 4 * n; }); }},
      {"packed normals", "normals-packed", Severity::Wrong,
       [](io::FrameData& f) { each(f.normalWorld, [](float n) { return n * .5f + .5f; }); }},
      {"view-space normals", "normals-view-space", Severity::Wrong, viewNormals},
      {"positions summed", "position-sum", Severity::Wrong,
       [](io::FrameData& f) { each(f.positionWorld, [](float p) { return 4 * p; }); }},
      {"view-space positions", "position-view-space", Severity::Wrong, viewPositions},
      {"left-handed", "left-handed", Severity::Note, leftHanded},
      {"reversed z", "reversed-z", Severity::Note,
       [](io::FrameData& f) { cameras(f, [](Matrix4& m) { negateRow(m, 2); }); }},
      {"frozen previous camera", "previous-camera-frozen", Severity::Wrong,
       [](io::FrameData& f) { f.camera.worldToClipPrev = f.camera.worldToClip; }},
  };
}

std::vector<Row> lightRows() {
  return {
      {"albedo 0", "albedo-zero", Severity::Doubtful,
       [](io::FrameData& f) { each(f.albedo, [](float) { return 0.0f; }); }},
      {"albedo in bytes", "albedo-above-1", Severity::Wrong,
       [](io::FrameData& f) { each(f.albedo, [](float a) { return 255 * a; }); }},
      {"albedo sRGB", "albedo-srgb", Severity::Doubtful,
       [](io::FrameData& f) { each(f.albedo, [](float a) { return std::pow(a, 1 / 2.2f); }); }},
      {"radiance summed", "radiance-sum", Severity::Wrong,
       [](io::FrameData& f) {
         for (int earlier = 0; earlier < f.number; ++earlier) {
           const io::FrameData frame = planeFrame(earlier);
           for (std::size_t i = 0; i < f.radiance.pixels.size(); ++i)
             f.radiance.pixels[i] += frame.radiance.pixels[i];
         }
       }},
  };
}

check::Result resultOf(const Row& row) {
  io::FrameData before = planeFrame(2, row.depth), now = planeFrame(3, row.depth);
  row.twist(before);
  row.twist(now);
  return checked(before, now);
}

void checkRows(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    INFO(row.name);
    const check::Result result = resultOf(row);
    CHECK(kindsOf(result) == (*row.kind == '\0' ? "" : row.kind + std::string(" ")));
    for (const check::MappedFinding& found : result.findings) CHECK(found.finding.severity == row.severity);
  }
}

}  // namespace

TEST_CASE("kinds of depth are told by the surfaces that they make") { checkRows(depthRows()); }
TEST_CASE("wrong cameras, positions and normals are named, conventions without harm are notes") {
  checkRows(geometryRows());
}
TEST_CASE("albedo and radiance in other units are named") { checkRows(lightRows()); }

}  // namespace quell::tests
