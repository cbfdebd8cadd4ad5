// Where the images of a frame come from in files, by the schema of images.
#pragma once

#include <string>
#include <vector>

#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::io {

/// One image of FrameData, its files and its role.
struct ImageSource {
  Image FrameData::*image;
  ImageFiles files;
  bool required;
};

/// All images of a frame whose light is kept as 1 or 2 signals. With two, radiance is the diffuse part, glossyRadiance
/// is required and `combined` is the light as a whole; with one, there is no glossyRadiance. Positions are required,
/// view depth in place of them is not among these. The light as a whole comes last.
std::vector<ImageSource> imageSources(int signals);

ExrType exrTypeOf(FileSamples samples);

/// Writes an image with the samples that its files have. Throws Error(FileError).
void writeImage(const std::string& path, const Image& image, const ImageFiles& files);

}  // namespace quell::io
