// Fifty points spread evenly over a disc: the pattern of a sunflower's seeds (Vogel 1979). Point i lies at the angle
// i * pi * (3 - sqrt(5)) and at the radius sqrt((i + 1/2) / 50), in units of 1 / QUELL_SUNFLOWER_UNIT.
// Whole numbers, so that host and device round taps to the same pixels.
#ifndef QUELL_COMMON_SUNFLOWER_H
#define QUELL_COMMON_SUNFLOWER_H

#define QUELL_SUNFLOWER_POINTS 50
#define QUELL_SUNFLOWER_UNIT 1024

// clang-format off
#define QUELL_SUNFLOWER(POINT) \
  POINT(102, 0) POINT(-131, 120) POINT(20, -228) POINT(165, 215) POINT(-303, -54) POINT(287, -182) \
  POINT(-96, 357) POINT(-183, -352) POINT(397, 145) POINT(-413, 170) POINT(199, -425) POINT(147, 469) \
  POINT(-443, -257) POINT(520, -114) POINT(-317, 451) POINT(-73, -565) POINT(450, 379) POINT(-605, 25) \
  POINT(442, -439) POINT(-30, 639) POINT(-420, -503) POINT(665, 90) POINT(-564, 392) POINT(154, -685) \
  POINT(356, 622) POINT(-697, -222) POINT(677, -313) POINT(-293, 701) POINT(-262, -727) POINT(696, 366) \
  POINT(-773, 204) POINT(440, -684) POINT(140, 814) POINT(-663, -513) POINT(848, -70) POINT(-586, 633) \
  POINT(4, -875) POINT(596, 657) POINT(-895, -83) POINT(725, -550) POINT(-165, 907) POINT(-497, -790) \
  POINT(911, 250) POINT(-850, 436) POINT(336, -906) POINT(368, 905) POINT(-892, -423) POINT(954, -294) \
  POINT(-510, 870) POINT(-214, -996)
// clang-format on

#endif
