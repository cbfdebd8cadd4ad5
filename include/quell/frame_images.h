/* The images of the buffer contract, each described once. Both APIs, validation, compile options, kernels, files and
 * the contract table of the documentation are made from these lists, so that a new image is a new last line here (the
 * C API's structs grow at their end) and whatever makes use of it.
 *
 * Columns:
 *   name, NAME    of the member; the same for macros
 *   least, most   channels
 *   kind          VALUES, floats or halves that are computed with, or IDENTIFIERS, which are compared bit by bit and
 *                 may be 32-bit unsigned
 *   presence      REQUIRED or OPTIONAL
 *   files         (stem, channels, samples, role): files of its own (data/README.md), "" where there are none, with
 *                 samples stored as HALF, FLOAT or UINT (32 bits); what --channels calls the image. Tools hold as many
 *                 channels in memory.
 *   texts         (absent, unit, range, broken): what counts without it ("" where it is required), space and unit,
 *                 range, what a value that is not finite means
 *
 * In the common subset of OpenCL C, C99 and C++. */
#ifndef QUELL_FRAME_IMAGES_H
#define QUELL_FRAME_IMAGES_H

/* clang-format off */
/* What the caller hands over for one frame. */
#define QUELL_FRAME_IMAGES(IMAGE)                                                                                      \
  /* Linear radiance with emission included, 1 to 4 channels (one is spread to RGB, a missing third is 0, a fourth
     ignored), one sample per pixel or more. Radiance minus emission is clamped to [0, 65504]. */                      \
  IMAGE(radiance, RADIANCE, 1, 4, VALUES, REQUIRED,                                                                    \
        ("color", "RGB", HALF, "color"),                                                                               \
        ("", "linear, emission included", "clamped to 0 .. 65504", "missing sample"))                                  \
  /* Glossy radiance, layouts and values as radiance. With it, two signals are filtered side by side: radiance is then
     the diffuse part alone (with emission), and the output is the sum of both. */                                     \
  IMAGE(glossyRadiance, GLOSSYRADIANCE, 1, 4, VALUES, OPTIONAL,                                                        \
        ("glossy_radiance", "RGB", HALF, "glossy"),                                                                    \
        ("one signal", "linear, of the glossy lobe", "clamped to 0 .. 65504", "missing sample"))                       \
  /* Shading normal of any length from 1e-18 to 1e18. A zero normal marks background, which passes through
     unfiltered. */                                                                                                    \
  IMAGE(normalWorld, NORMALWORLD, 3, 4, VALUES, REQUIRED,                                                              \
        ("shading_normal", "RGB", HALF, "normal"),                                                                     \
        ("", "world, any length", "0 marks background", "pixel passes through"))                                       \
  /* Half is accepted only while the camera is within 32 scene units of the world origin on every axis
     (kHalfPositionRange). Either this or viewDepth. */                                                                \
  IMAGE(positionWorld, POSITIONWORLD, 3, 4, VALUES, OPTIONAL,                                                          \
        ("world_position", "RGB", FLOAT, "position"),                                                                  \
        ("`viewDepth`", "world, scene units", "below 1e18 from the camera", "pixel passes through"))                   \
  /* Depth along the view axis; perspective cameras only. Of background any value. */                                  \
  IMAGE(viewDepth, VIEWDEPTH, 1, 1, VALUES, OPTIONAL,                                                                  \
        ("", "Y", FLOAT, "depth"),                                                                                     \
        ("`positionWorld`", "along the view axis, scene units", "positive in front", "pixel passes through"))          \
  /* Diffuse albedo. Light is divided by 0.01 to 2 in a channel; what becomes of channels below: docs/buffers.md. */   \
  IMAGE(albedo, ALBEDO, 1, 4, VALUES, OPTIONAL,                                                                        \
        ("albedo", "RGB", HALF, "albedo"),                                                                             \
        ("1", "reflectance", "0 .. 1", "counts as 0"))                                                                 \
  /* Tint of the glossy lobe. With one signal irradiance is (radiance - emission) / (albedo + gloss colour), with two
     (radiance - emission) / albedo and glossyRadiance / gloss colour; a factor that is not given is 1. With one
     signal a gloss colour that exceeds 1 together with albedo is taken for one without Fresnel term: f0 of it. */     \
  IMAGE(glossColor, GLOSSCOLOR, 1, 4, VALUES, OPTIONAL,                                                                \
        ("gloss_color", "RGB", HALF, "gloss_color"),                                                                   \
        ("1", "reflectance", "0 .. 1", "counts as 0"))                                                                 \
  /* Roughness of the glossy lobe, 0: mirror. Read by edge stops (setting `roughnessSigma`), by features that are made
     of it (setting `features` of bmfr) and where light is divided by F_beta. */                                       \
  IMAGE(roughness, ROUGHNESS, 1, 1, VALUES, OPTIONAL,                                                                  \
        ("roughness", "Y", HALF, "roughness"),                                                                         \
        ("not looked at", "perceptual: alpha of GGX is its square", "0 .. 1", "counts as 1 or 0"))                     \
  /* Fresnel reflectance at normal incidence. Read where light is divided by F_beta (setting `demodulate`), and where a
     gloss colour lacks it; there it is 0.04 without the image. */                                                     \
  IMAGE(f0, F0, 1, 4, VALUES, OPTIONAL,                                                                                \
        ("f0", "RGB", HALF, "f0"),                                                                                     \
        ("1, of a gloss colour that lacks it 0.04", "reflectance at normal incidence", "0 .. 1", "counts as 0"))  \
  /* Emitted radiance and visible sky, added back unfiltered, no more of it than radiance has. */                      \
  IMAGE(emission, EMISSION, 1, 4, VALUES, OPTIONAL,                                                                    \
        ("emission", "RGB", HALF, "emission"),                                                                         \
        ("0", "linear", "0 .. 65504", "missing sample"))                                                               \
  /* Motion vectors: where this pixel's surface point was in the frame before, minus this pixel, without jitter (0 for
     a scene and a camera at rest); the first two channels are read. Where given they win over the matrices, for the
     background, too, and objects that move keep their history. A vector that leads out of the frame before: no history
     for this pixel. */                                                                                                \
  IMAGE(motion, MOTION, 2, 4, VALUES, OPTIONAL,                                                                        \
        ("motion", "RG", HALF, "motion"),                                                                              \
        ("the matrices", "pixels, x right, y down: previous minus current pixel", "any", "no history for the pixel"))  \
  /* Which object a pixel shows: 32-bit unsigned, or floats (whole numbers are exact up to 2^24, halves up to 2^11).
     History of another object is discarded. */                                                                        \
  IMAGE(objectId, OBJECTID, 1, 1, IDENTIFIERS, OPTIONAL,                                                               \
        ("object_id", "Y", UINT, "object_id"),                                                                         \
        ("one object", "any number, 32-bit unsigned too, compared bit by bit", "any", "a number like others"))         \
  /* How far the ray of the glossy signal went from the surface to what it hit; what is not above 0 counts as not known.
     Carried, but not read yet. */                                                                                     \
  IMAGE(hitDistance, HITDISTANCE, 1, 1, VALUES, OPTIONAL,                                                              \
        ("hit_distance", "Y", HALF, "hit_distance"),                                                                   \
        ("not looked at", "scene units, of the glossy ray", "above 0", "counts as not known"))

/* What the denoiser hands back; at least one of them. */
#define QUELL_OUTPUT_IMAGES(IMAGE)                                                                                     \
  /* Before tone map and TAA. */                                                                                       \
  IMAGE(linear, LINEAR, 3, 4, VALUES, OPTIONAL,                                                                        \
        ("", "RGB", HALF, ""),                                                                                         \
        ("`display`", "linear radiance", "0 .. 65504, always finite", "never"))                                        \
  /* Encoded for display. */                                                                                           \
  IMAGE(display, DISPLAY, 3, 4, VALUES, OPTIONAL,                                                                      \
        ("", "RGB", HALF, ""),                                                                                         \
        ("`linear`", "gamma 2.2, after TAA if the method has it", "0 .. 1, always finite", "never"))
/* clang-format on */

#endif
