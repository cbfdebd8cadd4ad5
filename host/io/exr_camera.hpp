// The camera that a renderer has written into the header of an OpenEXR file.
#pragma once

#include <optional>
#include <quell/camera.hpp>
#include <vector>

#include "host/io/exr_header.hpp"
#include "host/io/image.hpp"

namespace quell::io {

/// World to clip of the display window by the attributes worldToNDC, or worldToCamera with the screen window, in all the
/// ways in which renderers write them: for row or column vectors; NDC from -1 to 1 or 0 to 1, y up or down, the longer side
/// beyond 1 or not; the view axis along z or against it. The way of OpenEXR's documentation comes first. Empty without these
/// attributes.
std::vector<Matrix4> headerCameras(const ExrHeader& header);

/// The first of them, cut to the data window, that puts the positions (3 channels) at their pixels; for an empty image the
/// first one; else nothing.
std::optional<Matrix4> headerCamera(const ExrHeader& header, const Image& positionWorld);

}  // namespace quell::io
