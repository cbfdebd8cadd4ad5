// OpenEXR files of one part or several with any channel names, windows and attributes, as renderers write them.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include <map>
#include <string>
#include <vector>

#include "host/io/pixel_window.hpp"

namespace quell::tests {

/// Planes of one part by channel name; all of one size.
using Planes = std::map<std::string, io::Image>;

struct WrittenPart {
  std::string name;
  Planes planes;
  std::string view = {};
};

inline Imath::Box2i boxOf(const io::PixelWindow& window) {
  return {{window.x, window.y}, {window.x + window.width - 1, window.y + window.height - 1}};
}

/// Adds `letters` of an image under "NAME.", or bare for an empty name.
inline void addPlanes(Planes& planes, const std::string& name, const io::Image& image,
                      const std::string& letters) {
  for (std::size_t c = 0; c < letters.size(); ++c) {
    io::Image plane(image.width, image.height, 1);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) plane.at(x, y, 0) = image.at(x, y, int(c));
    planes[name + (name.empty() ? "" : ".") + letters[c]] = plane;
  }
}

inline void fillPart(const Planes& planes, Imf::Header& header, Imf::FrameBuffer& buffer) {
  for (const auto& [name, image] : planes) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, image.pixels.data(), header.dataWindow(), sizeof(float),
                                         sizeof(float) * std::size_t(image.width)));
  }
}

/// One part. The header says the windows, and attributes if any.
inline void writePlanes(const std::string& path, const Planes& planes, Imf::Header header) {
  Imf::FrameBuffer buffer;
  fillPart(planes, header, buffer);
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
}

inline void writePlanes(const std::string& path, const Planes& planes) {
  const io::Image& any = planes.begin()->second;
  writePlanes(path, planes, Imf::Header(any.width, any.height));
}

/// A window for each channel name's image: `data` within `display`.
inline void writePlanes(const std::string& path, const Planes& planes, const io::PictureWindows& windows) {
  writePlanes(path, planes, Imf::Header(boxOf(windows.display), boxOf(windows.data)));
}

inline void writeParts(const std::string& path, const std::vector<WrittenPart>& parts) {
  std::vector<Imf::Header> headers;
  std::vector<Imf::FrameBuffer> buffers(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const io::Image& any = parts[i].planes.begin()->second;
    Imf::Header header(any.width, any.height);
    header.setName(parts[i].name);
    header.setType(Imf::SCANLINEIMAGE);
    if (!parts[i].view.empty()) header.setView(parts[i].view);
    fillPart(parts[i].planes, header, buffers[i]);
    headers.push_back(header);
  }
  Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Imf::OutputPart part(file, int(i));
    part.setFrameBuffer(buffers[i]);
    part.writePixels(parts[i].planes.begin()->second.height);
  }
}

}  // namespace quell::tests
