// The colour spaces of FLIP (flip.hpp), one colour at a time, in double precision.
#pragma once

#include <array>

namespace quell::metrics {

using Color = std::array<double, 3>;

/// sRGB (IEC 61966-2-1) to linear RGB with the same primaries; per component, in [0, 1].
Color linearFromSrgb(const Color& srgb);

/// Linear RGB to Y Cx Cz, an opponent space linear in XYZ; white is (100, 0, 0), black (-16, 0, 0).
Color ycxczFromLinear(const Color& linear);

/// The inverse of ycxczFromLinear().
Color linearFromYcxcz(const Color& ycxcz);

/// Linear RGB to CIE L*a*b* relative to the white point of linear RGB (1, 1, 1); L* in [0, 100].
Color labFromLinear(const Color& linear);

/// Hunt effect: chroma looks stronger the brighter it is. a* and b* times 0.01 L* (paper: color pipeline).
Color huntAdjusted(const Color& lab);

/// HyAB distance: |difference of L*| plus the Euclidean distance in (a*, b*). Lab units, >= 0.
double hyabDistance(const Color& labA, const Color& labB);

}  // namespace quell::metrics
