// Inputs that a stage of their own (host/stages/import_image.hpp) brings into packed buffers of floats before other stages
// read them: OpenCL image objects, sums, and other kinds of depth than view depth.
#pragma once

#include <quell/frame.hpp>
#include <string>

#include "host/core/schedule.hpp"

namespace quell {

bool isImported(const Frame& frame, const ImageView Frame::*input);

/// The image as stages read it; its memory is that of the caller's unless it is imported.
ImageView viewForStages(const Frame& frame, const ImageView Frame::*input);

/// The method's buffer that holds an imported image, and how large it is.
std::string importedBuffer(const char* image);
Extent importedExtent(const Frame& frame, const ImageView Frame::*input);

/// Whether a stage of the table reads the image.
bool readsImage(const Schedule& table, const Configuration& configuration, const ImageView Frame::*input);

/// Bytes of a texel of an image object: what its view says (see resolveImageObjects), else those of four floats.
std::size_t texelBytes(const ImageView& view);

}  // namespace quell
