// How the display image is made of radiance: tone maps and encodings, as compile options TONE_MAP and DISPLAY_ENCODING.
#ifndef QUELL_COMMON_DISPLAY_MODES_H
#define QUELL_COMMON_DISPLAY_MODES_H

#define QUELL_TONE_MAP_CLAMP 0
#define QUELL_TONE_MAP_REINHARD 1
#define QUELL_TONE_MAP_ACES 2
#define QUELL_TONE_MAP_NONE 3

#define QUELL_ENCODING_GAMMA 0
#define QUELL_ENCODING_SRGB 1
#define QUELL_ENCODING_LINEAR 2

// Columns of a stage's options; see common/ports.h.
#define DISPLAY_OPTIONS(OPTION) OPTION(TONE_MAP) OPTION(DISPLAY_ENCODING)

#endif
