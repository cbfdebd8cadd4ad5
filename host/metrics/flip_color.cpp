#include "host/metrics/flip_color.hpp"

#include <cmath>

namespace quell::metrics {
namespace {

using ColorMatrix = std::array<Color, 3>;  // rows

/// Linear RGB to CIE XYZ and back: exact for the primaries of Rec. ITU-R BT.709 and D65 at (0.3127, 0.3290).
constexpr ColorMatrix kXyzFromLinear = {{{506752.0 / 1228815.0, 87881.0 / 245763.0, 12673.0 / 70218.0},
                                         {87098.0 / 409605.0, 175762.0 / 245763.0, 12673.0 / 175545.0},
                                         {7918.0 / 409605.0, 87881.0 / 737289.0, 1001167.0 / 1053270.0}}};
constexpr ColorMatrix kLinearFromXyz = {{{12831.0 / 3959.0, -329.0 / 214.0, -1974.0 / 3959.0},
                                         {-851781.0 / 878810.0, 1648619.0 / 878810.0, 36519.0 / 878810.0},
                                         {705.0 / 12673.0, -2585.0 / 12673.0, 705.0 / 667.0}}};

// Scales and offset of CIE 1976 L*a*b*, shared by its linearised form YCxCz (paper: color pipeline).
constexpr double kLightnessScale = 116.0;
constexpr double kLightnessOffset = 16.0;
constexpr double kRedGreenScale = 500.0;
constexpr double kYellowBlueScale = 200.0;
/// Where L*a*b* changes from the cube root to a straight line, relative to white (CIE 15).
constexpr double kLabDelta = 6.0 / 29.0;

// Piecewise response of sRGB, IEC 61966-2-1.
constexpr double kSrgbToeEnd = 0.04045;
constexpr double kSrgbToeSlope = 12.92;
constexpr double kSrgbOffset = 0.055;
constexpr double kSrgbExponent = 2.4;

/// Chroma is scaled by L* over its largest value.
constexpr double kHuntScale = 0.01;

Color transform(const ColorMatrix& matrix, const Color& v) {
  Color result{};
  for (std::size_t r = 0; r < 3; ++r)
    result[r] = matrix[r][0] * v[0] + matrix[r][1] * v[1] + matrix[r][2] * v[2];
  return result;
}

const Color& whiteXyz() {
  static const Color white = transform(kXyzFromLinear, {1.0, 1.0, 1.0});
  return white;
}

/// XYZ relative to the white point.
Color relativeXyz(const Color& linear) {
  Color xyz = transform(kXyzFromLinear, linear);
  for (std::size_t i = 0; i < 3; ++i) xyz[i] /= whiteXyz()[i];
  return xyz;
}

double srgbToLinear(double srgb) {
  if (srgb <= kSrgbToeEnd) return srgb / kSrgbToeSlope;
  return std::pow((srgb + kSrgbOffset) / (1.0 + kSrgbOffset), kSrgbExponent);
}

double labResponse(double t) {
  if (t > kLabDelta * kLabDelta * kLabDelta) return std::cbrt(t);
  return t / (3.0 * kLabDelta * kLabDelta) + kLightnessOffset / kLightnessScale;
}

}  // namespace

Color linearFromSrgb(const Color& srgb) {
  return {srgbToLinear(srgb[0]), srgbToLinear(srgb[1]), srgbToLinear(srgb[2])};
}

Color ycxczFromLinear(const Color& linear) {
  const Color xyz = relativeXyz(linear);
  return {kLightnessScale * xyz[1] - kLightnessOffset, kRedGreenScale * (xyz[0] - xyz[1]),
          kYellowBlueScale * (xyz[1] - xyz[2])};
}

Color linearFromYcxcz(const Color& ycxcz) {
  const double y = (ycxcz[0] + kLightnessOffset) / kLightnessScale;
  const double x = y + ycxcz[1] / kRedGreenScale;
  const double z = y - ycxcz[2] / kYellowBlueScale;
  return transform(kLinearFromXyz, {x * whiteXyz()[0], y * whiteXyz()[1], z * whiteXyz()[2]});
}

Color labFromLinear(const Color& linear) {
  const Color xyz = relativeXyz(linear);
  const double fx = labResponse(xyz[0]), fy = labResponse(xyz[1]), fz = labResponse(xyz[2]);
  return {kLightnessScale * fy - kLightnessOffset, kRedGreenScale * (fx - fy), kYellowBlueScale * (fy - fz)};
}

Color huntAdjusted(const Color& lab) {
  return {lab[0], kHuntScale * lab[0] * lab[1], kHuntScale * lab[0] * lab[2]};
}

double hyabDistance(const Color& labA, const Color& labB) {
  return std::abs(labA[0] - labB[0]) + std::hypot(labA[1] - labB[1], labA[2] - labB[2]);
}

}  // namespace quell::metrics
