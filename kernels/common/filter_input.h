// What filters need of the pixels at hand, from the caller's images: irradiance of each signal and its weight as a
// filter tap.
#ifndef QUELL_COMMON_FILTER_INPUT_H
#define QUELL_COMMON_FILTER_INPUT_H

#include "common/material.h"

typedef struct Sample {
  float3L irradiance;
  floatL weight;
  intL present;
} Sample;

QUELL_INLINE Sample makeSample(Signal signal, intL validSurface) {
  Sample sample;
  sample.irradiance = divideSignal(signal.value, signal.factor, &sample.weight);
  sample.present = signal.finite && sample.weight > 0.0f && validSurface;
  return sample;
}

#endif
