// Frames written with the channel names of renderers: imitations, made of the built-in sequence.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/exr_parts.hpp"
#include "tests/support/multilayer_files.hpp"

namespace quell::tests {

/// One renderer's way to write frame 1 into a directory.
struct RendererFiles {
  std::string renderer;
  bool hasEmission;  ///< its files have emission
  bool hasCamera;    ///< view depth beside positions: a camera follows
  std::function<void(const std::string& directory, const io::FrameData&)> write;
};

namespace renderers {

inline void mitsuba(const std::string& directory, const io::FrameData& frame) {
  Planes planes;
  addPlanes(planes, "", frame.radiance, "RGB");
  addPlanes(planes, "albedo", frame.albedo, "RGB");
  addPlanes(planes, "n", frame.normalWorld, "XYZ");
  addPlanes(planes, "p", frame.positionWorld, "XYZ");
  addPlanes(planes, "d", multilayer::depthOf(frame), "T");
  writePlanes(directory + "/frame_0001.exr", planes);
}

inline void luxcore(const std::string& directory, const io::FrameData& frame) {
  const auto write = [&](const std::string& output, const io::Image& image, const std::string& letters) {
    Planes planes;
    addPlanes(planes, "", image, letters);
    writePlanes(directory + "/" + output + "_0001.exr", planes);
  };
  write("RGB", frame.radiance, "RGB");
  write("ALBEDO", frame.albedo, "RGB");
  write("AVG_SHADING_NORMAL", frame.normalWorld, "RGB");
  write("POSITION", frame.positionWorld, "RGB");
  write("DEPTH", multilayer::depthOf(frame), "Y");
  write("EMISSION", frame.emission, "RGB");
}

inline void pbrt(const std::string& directory, const io::FrameData& frame) {
  Planes planes;
  addPlanes(planes, "", frame.radiance, "RGB");
  addPlanes(planes, "Albedo", frame.albedo, "RGB");
  addPlanes(planes, "P", frame.positionWorld, "XYZ");
  addPlanes(planes, "N", io::Image(multilayer::kWidth, multilayer::kHeight, 3, 0.5f), "XYZ");
  addPlanes(planes, "Ns", frame.normalWorld, "XYZ");
  for (const char* variance : {"Variance", "RelativeVariance"})
    addPlanes(planes, variance, frame.albedo, "RGB");
  writePlanes(directory + "/render1.exr", planes);
}

inline void arnold(const std::string& directory, const io::FrameData& frame) {
  Planes planes;
  addPlanes(planes, "", frame.radiance, "RGB");
  planes["A"] = io::Image(multilayer::kWidth, multilayer::kHeight, 1, 0.75f);
  planes["Z"] = multilayer::depthOf(frame);
  addPlanes(planes, "albedo", frame.albedo, "RGB");
  addPlanes(planes, "N", frame.normalWorld, "XYZ");
  addPlanes(planes, "P", frame.positionWorld, "XYZ");
  addPlanes(planes, "emission", frame.emission, "RGB");
  addPlanes(planes, "background", io::Image(multilayer::kWidth, multilayer::kHeight, 3), "RGB");
  writePlanes(directory + "/beauty.0001.exr", planes);
}

inline void karma(const std::string& directory, const io::FrameData& frame) {
  Planes beauty, depth, rest;
  addPlanes(beauty, "", frame.radiance, "RGB");
  depth["hitPz"] = multilayer::depthOf(frame);
  addPlanes(rest, "N", frame.normalWorld, "xyz");
  addPlanes(rest, "P", frame.positionWorld, "xyz");
  addPlanes(rest, "albedo", frame.albedo, "rgb");
  addPlanes(rest, "directemission", frame.emission, "rgb");
  writeParts(directory + "/shot.1.exr", {{"C", beauty}, {"hitPz", depth}, {"rest", rest}});
}

inline void renderman(const std::string& directory, const io::FrameData& frame) {
  Planes planes;
  addPlanes(planes, "Ci", frame.radiance, "rgb");
  addPlanes(planes, "albedo", frame.albedo, "rgb");
  addPlanes(planes, "__Nworld", frame.normalWorld, "rgb");
  addPlanes(planes, "__Pworld", frame.positionWorld, "rgb");
  planes["__depth"] = multilayer::depthOf(frame);
  writePlanes(directory + "/a.0001.exr", planes);
}

inline void cyclesOfBlender5(const std::string& directory, const io::FrameData& frame) {
  const auto part = [](const std::string& pass, const io::Image& image, const std::string& letters) {
    WrittenPart written{"ViewLayer." + pass, {}};
    addPlanes(written.planes, written.name, image, letters);
    return written;
  };
  writeParts(directory + "/0001.exr",
             {part("Combined", frame.radiance, "RGB"), part("Depth", multilayer::depthOf(frame), "V"),
              part("Diffuse Color", frame.albedo, "RGB"), part("Emission", frame.emission, "RGB"),
              part("Normal", frame.normalWorld, "XYZ"), part("Position", frame.positionWorld, "XYZ")});
}

}  // namespace renderers

inline std::vector<RendererFiles> rendererFiles() {
  return {{"cycles", true, true, renderers::cyclesOfBlender5}, {"mitsuba", false, false, renderers::mitsuba},
          {"luxcore", true, false, renderers::luxcore},        {"pbrt", false, false, renderers::pbrt},
          {"arnold", true, true, renderers::arnold},           {"karma", true, true, renderers::karma},
          {"renderman", false, true, renderers::renderman}};
}

}  // namespace quell::tests
