/* The images of the buffer contract, each described once. Both APIs, validation, compile options, kernels, files and
 * the contract table of the documentation are made from these lists, so that a new image is a new last line here (the
 * C API's structs grow at their end) and whatever makes use of it.
 *
 * Columns: name of the member; the same for macros; fewest and most channels; what its components are (VALUES, floats
 * or halves that are computed with, or IDENTIFIERS, which are compared bit by bit and may be 32-bit unsigned);
 * whether it must be there (REQUIRED, OPTIONAL); stem of its files (see data/README.md; "" where it has none) and pass
 * of Blender's Cycles ("" where it has none); space and unit; range; what a value that is not finite means.
 *
 * In the common subset of OpenCL C, C99 and C++. */
#ifndef QUELL_FRAME_IMAGES_H
#define QUELL_FRAME_IMAGES_H

/* clang-format off */
/* What the caller hands over for one frame. */
#define QUELL_FRAME_IMAGES(IMAGE)                                                                                      \
  IMAGE(radiance, RADIANCE, 1, 4, VALUES, REQUIRED, "color", "Combined",                                               \
        "linear, emission included", "clamped to 0 .. 65504", "missing sample")                                        \
  IMAGE(glossyRadiance, GLOSSYRADIANCE, 1, 4, VALUES, OPTIONAL, "glossy_radiance", "",                                 \
        "linear, of the glossy lobe", "clamped to 0 .. 65504", "missing sample")                                       \
  IMAGE(normalWorld, NORMALWORLD, 3, 4, VALUES, REQUIRED, "shading_normal", "Normal",                                  \
        "world, unit length", "0 marks background", "pixel passes through")                                            \
  IMAGE(positionWorld, POSITIONWORLD, 3, 4, VALUES, OPTIONAL, "world_position", "Position",                            \
        "world, scene units", "below 1e18 from the camera", "pixel passes through")                                    \
  IMAGE(viewDepth, VIEWDEPTH, 1, 1, VALUES, OPTIONAL, "", "Depth",                                                     \
        "along the view axis, scene units", "positive in front", "pixel passes through")                               \
  IMAGE(albedo, ALBEDO, 1, 4, VALUES, OPTIONAL, "albedo", "DiffCol",                                                   \
        "reflectance", "0 .. 1", "counts as 0: passes through")                                                        \
  IMAGE(glossColor, GLOSSCOLOR, 1, 4, VALUES, OPTIONAL, "gloss_color", "GlossCol",                                     \
        "reflectance", "0 .. 1", "counts as 0: passes through")                                                        \
  IMAGE(roughness, ROUGHNESS, 1, 1, VALUES, OPTIONAL, "roughness", "roughness",                                        \
        "perceptual: alpha of GGX is its square", "0 .. 1", "counts as 1 or 0")                                        \
  IMAGE(f0, F0, 1, 4, VALUES, OPTIONAL, "f0", "",                                                                      \
        "reflectance at normal incidence", "0 .. 1", "counts as 0")                                                    \
  IMAGE(emission, EMISSION, 1, 4, VALUES, OPTIONAL, "emission", "",                                                    \
        "linear", "0 .. 65504", "missing sample")                                                                      \
  IMAGE(motion, MOTION, 2, 4, VALUES, OPTIONAL, "motion", "Vector",                                                    \
        "pixels, x right, y down: previous minus current pixel", "any", "no history for the pixel")                    \
  IMAGE(objectId, OBJECTID, 1, 1, IDENTIFIERS, OPTIONAL, "object_id", "IndexOB",                                       \
        "any number, compared bit by bit", "any", "a number like others")

/* What the denoiser hands back; at least one of them. */
#define QUELL_OUTPUT_IMAGES(IMAGE)                                                                                     \
  IMAGE(linear, LINEAR, 3, 4, VALUES, OPTIONAL, "denoised", "",                                                        \
        "linear radiance", "0 .. 65504, always finite", "never")                                                       \
  IMAGE(display, DISPLAY, 3, 4, VALUES, OPTIONAL, "display", "",                                                       \
        "gamma 2.2, after TAA if the method has it", "0 .. 1, always finite", "never")
/* clang-format on */

#endif
