// Views of stereo pictures: which channels are of which.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace quell::io {

/// Channels of one view by their names without it, with the names that files have for them.
struct ViewChannels {
  std::string view;  ///< empty: the files have none
  std::map<std::string, std::string> stored;
};

/// A channel is of the view that stands before its last dot, PASS.left.R or left.R: those in `declared` (what headers say,
/// the first of them being that of channels without a view), and left and right. Without any, all channels are of no view.
/// Throws Error(FileError) naming `path` and the views: `wanted` is none of them, or empty and there are several.
ViewChannels channelsOfView(const std::string& path, const std::vector<std::string>& channels,
                            const std::vector<std::string>& declared, const std::string& wanted);

}  // namespace quell::io
