// Ports: what a stage reads and writes, and the options that it is compiled with, declared once in kernels/<stem>_ports.h.
// The kernel expands the list to its arguments; the host to a table (host/core/ports.hpp) from which follow the binding
// of arguments, the check of a method's rows, buffers, bytes moved, dumps and documentation.
//
//   #define <STEM>_OPTIONS(OPTION, SIZE)   compile options, -D name=value; sizes that only the host needs
//   #define <STEM>_PORTS(PORT, IMAGE, OUTPUT)
//     PORT(name, access, element, extent, touched, when)      a buffer of the method
//     IMAGE(name, NAME, share, when)                          an image of the caller, see quell/frame_images.h
//     OUTPUT(name, NAME, share, when)                          one that is written
//
// access   READ; PREVIOUS, read of the frame before (the port <buffer>Prev); WRITE; UPDATE, read and written; SCRATCH, of
//          use to this stage alone; TABLE, read of a table that the runtime provides.
// element  FLOAT, HALF, UCHAR, INT or FLOAT4.
// extent   planes of the image's size that the buffer has, or RECORDS(count) elements.
// touched  share of the extent that a frame touches, each element counted once: ALL, PLANES(count) of it, ELEMENTS(count)
//          of RECORDS, or what depends on the frame: SURFACES (work-items that show a surface), HISTORIES (that have a history; on surfaces alone where the stage leaves out background), SHORT_HISTORIES (that
//          have too short a one), CHANGED (whose light has changed), NEAR_SURFACES (background next to a surface),
//          WHERE_REPROJECTED (SURFACES, and the background if it is antialiased), LOOKED_UP (unknown, 0 is counted). The
//          `share` of an image likewise. What a stage leaves out because it is background need not be said.
// when     whether there is such a port, in terms of the options and HAS(image); ALWAYS. An absent buffer is a null pointer, an
//          absent image no argument: most frames have four of a dozen, and each argument takes host time at every launch.
//
// A use without a port does not compile; nor does a port of another element.
#ifndef QUELL_COMMON_PORTS_H
#define QUELL_COMMON_PORTS_H

#ifdef __OPENCL_C_VERSION__

#define QUELL_TYPE_FLOAT float
#define QUELL_TYPE_HALF half
#define QUELL_TYPE_UCHAR uchar
#define QUELL_TYPE_INT int
#define QUELL_TYPE_FLOAT4 float4

#define QUELL_POINTER_READ(type) __global const type*
#define QUELL_POINTER_PREVIOUS(type) __global const type*
#define QUELL_POINTER_TABLE(type) __global const type*
#define QUELL_POINTER_WRITE(type) __global type*
#define QUELL_POINTER_UPDATE(type) __global type*
#define QUELL_POINTER_SCRATCH(type) __global type*

#define QUELL_PORT_ARGUMENT(name, access, element, extent, touched, when) \
  QUELL_POINTER_##access(QUELL_TYPE_##element) name,
#define QUELL_IMAGE_ARGUMENT(name, NAME, share, when) \
  QUELL_IF_FORMAT(NAME##_FORMAT, __global const uchar* name##Data, )
#define QUELL_OUTPUT_ARGUMENT(name, NAME, share, when) NAME##_ARGUMENT name##Data,

// What stands for an image of any format but 0, which is an absent one.
#define QUELL_IF_FORMAT(format, ...) QUELL_IF_FORMAT_NUMBER(format, __VA_ARGS__)
#define QUELL_IF_FORMAT_NUMBER(format, ...) QUELL_IF_FORMAT_##format(__VA_ARGS__)
#define QUELL_IF_FORMAT_0(...)
#define QUELL_IF_FORMAT_1(...) __VA_ARGS__
#define QUELL_IF_FORMAT_2(...) __VA_ARGS__
#define QUELL_IF_FORMAT_3(...) __VA_ARGS__

// The arguments of a stage's kernel, in front of its parameters.
#define STAGE_ARGUMENTS(STEM) STEM##_PORTS(QUELL_PORT_ARGUMENT, QUELL_IMAGE_ARGUMENT, QUELL_OUTPUT_ARGUMENT)

#endif

#include "common/demodulate_modes.h"

// Groups of ports that several stages have.

// Light and what it is divided by.
#define LIGHT_IMAGES(IMAGE, share)                     \
  IMAGE(radiance, RADIANCE, share, ALWAYS)             \
  IMAGE(glossyRadiance, GLOSSYRADIANCE, share, ALWAYS) \
  IMAGE(emission, EMISSION, share, ALWAYS)             \
  IMAGE(albedo, ALBEDO, share, ALWAYS)                 \
  IMAGE(glossColor, GLOSSCOLOR, share, ALWAYS)

// Whether a gloss colour may lack the Fresnel term, and F0 says what it lacks; see common/material.h.
#define F0_DIMS_GLOSS                                                                            \
  (QUELL_SIGNALS == 1 && !DEMODULATED && DEMODULATE == QUELL_DEMODULATE_ALBEDO && HAS(albedo) && \
   HAS(glossColor))

// Which work-items show a surface, for a stage that leaves out the others; see common/surfaces.h.
#define SURFACES_PORT(PORT) PORT(surfaces, READ, UCHAR, RECORDS(surfaceItems), ALL, SKIP)

#endif
