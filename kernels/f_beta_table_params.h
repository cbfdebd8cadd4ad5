// Layout of the F_beta table, and the quadrature that fills it.
#ifndef QUELL_F_BETA_TABLE_PARAMS_H
#define QUELL_F_BETA_TABLE_PARAMS_H

#include "common/types.h"

// Texels along each axis (Zhuang et al. 2021, section 4.1). Texel (x, y) is the value at
//   cos(theta_o) = (x / 255)^2   and   roughness = y / 255,   alpha = roughness^2.
// Texels lie on the ends of both axes, so a lookup never extrapolates and a mirror is exact. Squares along x: F_beta
// changes over cos(theta_o) of about alpha near grazing, where even steps leave bilinear errors of 0.1.
#define QUELL_F_BETA_EDGE 256

// Floats of one table entry: scale and bias of texel (x, y), then those of texel (x + 1, y), or of the same texel in
// the last column. With the neighbour at hand a bilinear lookup is two loads of 16 bytes.
#define QUELL_F_BETA_ENTRY 4

// Samples of a texel: a Fibonacci lattice, hence a Fibonacci number, and the one before it, its generator. The error of
// a texel falls about as 1/N: 1.5e-4 with 1597, 8e-5 with 2584, 5e-5 with 4181.
// Simulators of devices cannot afford as many; what they check does not depend on the values.
#ifndef QUELL_F_BETA_SAMPLES
#define QUELL_F_BETA_SAMPLES 2584
#endif
#define QUELL_F_BETA_GENERATOR 1597

#endif
