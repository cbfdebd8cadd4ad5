// Which motion counts as one, and what it does to history.
#ifndef QUELL_COMMON_MOTION_PARAMS_H
#define QUELL_COMMON_MOTION_PARAMS_H

// A surface moves where its motion vector leads farther than this from where the matrices do, pixels. More than half
// floats and a camera's rounding are off by.
#define QUELL_MOVING_PX 0.25f
// How far the history of a surface that turns may lag behind, as a share of the normal limit (its square root): 4.5
// degrees with the default. Source: scene moving-objects, bmfr, error of moving pixels over that at rest: 1.5 without such
// a limit, 1.3 with 1, 1.2 with 0.5, 1.1 with 0.25. The error of svgf hardly depends on it.
#define QUELL_TURN_SHARE 0.25f
// Squared difference of unit normals that counts as none: rounding.
#define QUELL_LEAST_TURN_SQUARED 1e-8f

#endif
