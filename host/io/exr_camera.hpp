// The camera that a renderer has written into the header of an OpenEXR file.
#pragma once

#include <optional>
#include <quell/camera.hpp>
#include <vector>

#include "host/io/exr_header.hpp"
#include "host/io/image.hpp"

namespace quell::io {

/// World to clip, cut to the data window, by the attributes worldToNDC, or worldToCamera with the screen window, in all the
/// ways in which renderers write them: for row or column vectors; NDC from -1 to 1 or 0 to 1, y up or down, the longer side
/// beyond 1 or not; the view axis along z or against it. The way of OpenEXR's documentation comes first. Empty without these
/// attributes; else as many for all frames of a renderer, in the same order.
std::vector<Matrix4> headerCameras(const ExrHeader& header);

/// Which of them puts the positions (3 channels) at their pixels; the first one for an empty image or one without
/// surfaces; nothing if none does.
std::optional<std::size_t> fittingCamera(const std::vector<Matrix4>& cameras, const Image& positionWorld);

}  // namespace quell::io
