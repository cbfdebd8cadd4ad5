// Which channels of a frame's files are which image, found by looking and by what the user says.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/io/channel_names.hpp"
#include "host/io/exr_header.hpp"

namespace quell::io {

/// What a user says about channels.
struct ChannelOptions {
  std::vector<std::string>
      channels;  ///< IMAGE=SOURCE, see channel_names.hpp; go before what the renderer calls them
  std::string renderer = "auto";  ///< one of rendererNames(); auto: whose names explain most images
  std::string layer;              ///< view layer; empty: the one that has all that is needed
  std::string view;               ///< of stereo pictures; empty: the one that there is

  /// Whether they say anything.
  bool given() const { return !channels.empty() || renderer != "auto" || !layer.empty() || !view.empty(); }
};

/// Throws Error(InvalidArgument) for an image, a form or a renderer that there is not.
void requireChannelOptions(const ChannelOptions& options);

/// Channels of an image, as the files name them.
struct ImageChannels {
  std::vector<std::vector<std::string>> terms;  ///< summed up; of each as many as the image has
  NumberKind kind;
};

/// The images that a sequence's files have.
struct ChannelMap {
  std::string renderer;                         ///< whose names they are; empty: the user's alone
  std::string layer;                            ///< empty: none
  std::string view;                             ///< empty: none
  std::map<std::string, ImageChannels> images;  ///< by NamedImage::name

  bool has(const std::string& image) const { return images.count(image) > 0; }
};

/// Looks for all images. Throws Error(FileError) that names `path`: several view layers or views and none chosen, or a chosen
/// one that there is not; no color, no normal, or neither position nor depth, and what there is in their place. `views`
/// are those that headers speak of.
ChannelMap findChannels(const std::string& path, const std::vector<std::string>& channels,
                        const std::vector<std::string>& views, const ChannelOptions& options);

/// Throws Error(FileError) unless the map has the image, saying how it may be called, what else would do (", or ..."), and
/// which channels there are.
void requireImage(const std::string& path, const std::string& image, const ChannelMap& map,
                  const std::vector<std::string>& channels, const ChannelOptions& options,
                  const std::string& otherwise = {});

/// Whether some renderer's names explain color, normal, and position or depth, whatever the layer and the view.
bool hasFrameChannels(const std::vector<std::string>& channels, const std::vector<std::string>& views,
                      const ChannelOptions& options);

/// "Layer.Combined.RGBA Layer.Depth.Z", the first few of many.
std::string channelList(const std::vector<std::string>& channels);

/// Each image found with its channels, and what is missing and costs quality, each a line.
std::vector<std::string> describe(const ChannelMap& map);

}  // namespace quell::io
