#include "tests/check/plane_frames.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace quell::tests {
namespace {

constexpr double kDistance = 5.0, kNear = 0.1, kEyeY = 0.8;

struct Pose {
  double x, sine, cosine;
};

Pose poseOf(int number) {
  const double angle = -0.2 + 0.02 * number;
  return {0.3 + 0.05 * number, std::sin(angle), std::cos(angle)};
}

Matrix4 matrixOf(const Pose& p) {
  constexpr double kAspect = double(kPlaneWidth) / kPlaneHeight;
  const double depth = p.sine * p.x + p.cosine * kDistance;
  return {p.cosine / kAspect,
          0,
          -p.sine / kAspect,
          -(p.cosine * p.x - p.sine * kDistance) / kAspect,
          0,
          1,
          0,
          -kEyeY,
          -p.sine,
          0,
          -p.cosine,
          depth - kNear,
          -p.sine,
          0,
          -p.cosine,
          depth};
}

}  // namespace

io::FrameData planeFrame(int number, bool depth) {
  io::FrameData frame;
  frame.number = number;
  const Pose pose = poseOf(number);
  frame.camera.worldToClip = matrixOf(pose);
  frame.camera.worldToClipPrev = matrixOf(poseOf(number - 1));
  io::Image rgb(kPlaneWidth, kPlaneHeight, 3), position = rgb;
  frame.radiance = frame.normalWorld = frame.albedo = rgb;
  io::Image distance(kPlaneWidth, kPlaneHeight, 1);
  std::mt19937 random(unsigned(number) + 1u);
  std::exponential_distribution<float> noise(1.0f);
  for (int y = 0; y < kPlaneHeight; ++y) {
    for (int x = 0; x < kPlaneWidth; ++x) {
      const double u = ((x + 0.5) / kPlaneWidth * 2.0 - 1.0) * kPlaneWidth / kPlaneHeight;
      const double v = 1.0 - (y + 0.5) / kPlaneHeight * 2.0;
      const double t = kDistance / (u * pose.sine + pose.cosine);
      const double worldX = pose.x + t * (u * pose.cosine - pose.sine), worldY = kEyeY + t * v;
      const bool light = ((int(std::floor(2.0 * worldX)) + int(std::floor(2.0 * worldY))) & 1) != 0;
      const float albedo = light ? 0.8f : 0.3f;
      const float irradiance = float(0.6 + 0.4 * std::sin(worldX)) * noise(random);
      for (int c = 0; c < 3; ++c) {
        frame.albedo.at(x, y, c) = albedo;
        frame.radiance.at(x, y, c) = albedo * irradiance;
      }
      frame.normalWorld.at(x, y, 2) = 1.0f;
      position.at(x, y, 0) = float(worldX);
      position.at(x, y, 1) = float(worldY);
      distance.at(x, y, 0) = float(t);
    }
  }
  (depth ? frame.viewDepth : frame.positionWorld) = depth ? distance : position;
  return frame;
}

void transpose(Matrix4& matrix) {
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = row + 1; column < 4; ++column)
      std::swap(matrix[4 * row + column], matrix[4 * column + row]);
}

void turnOver(io::FrameData& frame) {
  for (const auto& facts : kInputs<io::FrameData>) {
    io::Image& image = frame.*facts.member;
    const std::ptrdiff_t row = std::ptrdiff_t(image.width) * image.channels;
    for (int y = 0; y < image.height / 2; ++y)
      std::swap_ranges(image.pixels.begin() + row * y, image.pixels.begin() + row * (y + 1),
                       image.pixels.begin() + row * (image.height - 1 - y));
  }
}

}  // namespace quell::tests
