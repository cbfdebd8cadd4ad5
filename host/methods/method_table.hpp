// What a method's table is written with.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/core/schedule.hpp"
#include "host/core/stage.hpp"
#include "host/methods/common_settings.hpp"

namespace quell {

/// Buffers of the image's size that are kept for the next frame, that are not, and buffers of `count` floats.
BufferSpec history(const std::string& name, Element element, int planes);
BufferSpec transient(const std::string& name, Element element, int planes);
BufferSpec elements(const std::string& name, std::size_t count);

/// `names` and then `more`.
std::vector<std::string> joinedNames(std::vector<std::string> names, const std::vector<std::string>& more);

/// The buffers that the edge stops of atrous read: guides, viewDepth and, where the caller has it, roughness.
std::vector<std::string> filterGuideNames(const Configuration& configuration);

/// Adds the buffer that keeps F_beta from the first stage to remodulate, where light is divided by it; its name, or
/// none.
std::vector<std::string> addFBeta(Schedule& schedule, const Configuration& configuration);

/// Adds the buffer that keeps object ids for the next frame, where the caller has them; its name, or none.
std::vector<std::string> addObjectIds(Schedule& schedule, const Configuration& configuration);

/// The histories of these buffers: "<name>.prev".
std::vector<std::string> previousNames(std::vector<std::string> names);

/// Adds one line to the table.
void addStage(Schedule& schedule, std::unique_ptr<Stage> stage, std::vector<std::string> reads,
              std::vector<std::string> writes);

/// Adds the lines from filtered irradiance to the caller's images: remodulate and, with `taa`,
/// temporal_antialiasing, and the buffers between them. Reads guides and, with `taa`, pixelPrev and
/// reprojectionMask. With `skip` background has a stage of its own, and surfaces is read.
void addOutputStages(Schedule& schedule, const Configuration& configuration, const std::string& filtered,
                     const AntialiasingSettings& antialiasing, bool skip = false);

}  // namespace quell
