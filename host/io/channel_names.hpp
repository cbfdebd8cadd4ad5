// What renderers call the channels of each image: the one table, and how its entries and --channels are written.
//
// A source is written as
//   NAME            a pass, whose channels end with R G B, X Y Z, ... after a dot or nothing; or one channel
//   NAME,NAME,NAME  channels by their names, as many as the image has
//   NAME+NAME       the sum of passes
//   NAME:KIND       for depth and motion, what the numbers mean (depth_kind.hpp, motion_kind.hpp)
// and, in the table alone, alternatives with | between them, the first that a file has.
#pragma once

#include <string>
#include <vector>

#include "host/io/depth_kind.hpp"
#include "host/io/motion_kind.hpp"

namespace quell::io {

/// An image as --channels names it.
struct NamedImage {
  const char* name;
  int channels;
  const char* cost;  ///< what it costs to be without; empty: required, or nothing that shows
};

/// All of them. "diffuse" and "glossy" are light before albedo and gloss colour, of two signals.
const std::vector<NamedImage>& namedImages();
/// Nothing for an unknown name.
const NamedImage* findNamedImage(const std::string& name);

/// What the numbers of an image mean where renderers differ.
struct NumberKind {
  DepthKind depth = DepthKind::View;
  MotionKind motion;
};

/// Channels of one image, or of a renderer's way to name them.
struct ChannelSource {
  std::vector<std::vector<std::string>> terms;  ///< summed up; one name: a pass or channel, several: channels
  NumberKind kind;
};

/// Alternatives for an image (NamedImage::name), in order of preference. Throws Error(InvalidArgument) for a text of another
/// form.
std::vector<ChannelSource> parseSources(const std::string& image, const std::string& text);

/// Names for --renderer, without "auto".
const std::vector<std::string>& rendererNames();

/// What a renderer calls an image; none where it has no name for it.
std::vector<ChannelSource> sourcesOf(const std::string& renderer, const std::string& image);

}  // namespace quell::io
