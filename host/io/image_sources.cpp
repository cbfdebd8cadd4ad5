#include "host/io/image_sources.hpp"

#include <algorithm>

namespace quell::io {

std::vector<ImageSource> imageSources(int signals) {
  std::vector<ImageSource> sources;
  for (const auto& input : kInputs<FrameData>) {
    ImageSource source{input.member, input.files, input.required()};
    if (input.member == &FrameData::viewDepth) continue;
    if (input.member == &FrameData::glossyRadiance) {
      if (signals == 1) continue;
      source.required = true;
    }
    if (input.member == &FrameData::positionWorld) source.required = true;
    sources.push_back(source);
  }
  // Radiance is the first image.
  if (signals == 2) {
    ImageSource combined = sources.front();
    combined.image = &FrameData::combined;
    sources.push_back(combined);
    sources.front().files.stem = "diffuse_irradiance";
    sources.front().files.role = "diffuse";
  } else {
    std::rotate(sources.begin(), sources.begin() + 1, sources.end());
  }
  return sources;
}

ExrType exrTypeOf(FileSamples samples) {
  return samples == FileSamples::HALF    ? ExrType::Half
         : samples == FileSamples::FLOAT ? ExrType::Float
                                         : ExrType::Uint;
}

void writeImage(const std::string& path, const Image& image, const ImageFiles& files) {
  writeExr(path, image, exrTypeOf(files.samples));
}

}  // namespace quell::io
