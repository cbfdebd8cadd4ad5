// The caller's images as a kernel has them: those among its ports, with where they lie.
//
// A kernel is compiled with NAME_FORMAT, NAME_CHANNELS and NAME_STRIDE of the images among its ports alone, so that a
// use of any other does not compile.
#ifndef QUELL_COMMON_FRAME_IMAGES_H
#define QUELL_COMMON_FRAME_IMAGES_H

#include "common/frame_image_params.h"
#include "common/image_access.h"

#define QUELL_IMAGE_POINTER(name, NAME, least, most, kind, presence, files, texts) __global const uchar* name;

typedef struct FrameImages {
  QUELL_FRAME_IMAGES(QUELL_IMAGE_POINTER)
  FrameImageParams views;
} FrameImages;

#define QUELL_NO_BUFFER(name, access, element, extent, touched, when)
#define QUELL_NO_OUTPUT(name, NAME, share, when)
#define QUELL_BIND_IMAGE(name, NAME, share, when) QUELL_IF_FORMAT(NAME##_FORMAT, images.name = name##Data;)

// Declares `images`, the images among the ports of a stage; first thing in its kernel.
#define BIND_FRAME_IMAGES(STEM, imageParams) \
  FrameImages images;                        \
  images.views = (imageParams);              \
  STEM##_PORTS(QUELL_NO_BUFFER, QUELL_BIND_IMAGE, QUELL_NO_OUTPUT)

// Pixels of the image `name`; see loadPixels().
#define LOAD_IMAGE(name, NAME, x, y, lanes) LOAD_PIXELS(NAME, images.name, images.views.name, x, y, lanes)

// Pixels of the image `name` from a column a lane; see gatherPixels().
#define GATHER_IMAGE(name, NAME, column, y) GATHER_PIXELS(NAME, images.name, images.views.name, column, y)

#endif
