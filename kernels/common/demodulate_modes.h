// What light is divided by before it is filtered: values of the compile option DEMODULATE and of the setting of that
// name.
#ifndef QUELL_COMMON_DEMODULATE_MODES_H
#define QUELL_COMMON_DEMODULATE_MODES_H

#define QUELL_DEMODULATE_NONE 0    // nothing: light is filtered as it is
#define QUELL_DEMODULATE_ALBEDO 1  // albedo and gloss colour
#define QUELL_DEMODULATE_F_BETA 2  // these, the gloss colour times F_beta (Zhuang et al. 2021, eq. (8))

#endif
