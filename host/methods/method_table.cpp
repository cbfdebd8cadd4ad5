#include "host/methods/method_table.hpp"

#include "host/core/frame_images.hpp"
#include "host/stages/background.hpp"
#include "host/stages/remodulate.hpp"
#include "host/stages/temporal_antialiasing.hpp"

namespace quell {

BufferSpec history(const std::string& name, Element element, int planes) {
  return {name, element, planes, 0, true};
}
BufferSpec transient(const std::string& name, Element element, int planes) {
  return {name, element, planes, 0, false};
}
BufferSpec elements(const std::string& name, std::size_t count) {
  return {name, Element::Float32, 0, count, false};
}

std::vector<std::string> joinedNames(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

std::vector<std::string> filterGuideNames(const Configuration& configuration) {
  std::vector<std::string> names = {"guides", "viewDepth"};
  if (configuration.frame.roughness.present()) names.push_back("roughness");
  return names;
}

std::vector<std::string> addFBeta(Schedule& schedule, const Configuration& configuration) {
  if (!dividesByFBeta(configuration)) return {};
  schedule.buffers.push_back(transient("fBeta", Element::Float32, 3));
  return {"fBeta"};
}

std::vector<std::string> addObjectIds(Schedule& schedule, const Configuration& configuration) {
  if (!configuration.frame.objectId.present()) return {};
  schedule.buffers.push_back(history("objectIds", Element::UInt32, 1));
  return {"objectIds"};
}

std::vector<std::string> previousNames(std::vector<std::string> names) {
  for (std::string& name : names) name += ".prev";
  return names;
}

void addStage(Schedule& schedule, std::unique_ptr<Stage> stage, std::vector<std::string> reads,
              std::vector<std::string> writes) {
  schedule.stages.push_back({std::move(stage), std::move(reads), std::move(writes)});
}

void addOutputStages(Schedule& schedule, const Configuration& configuration, const std::string& filtered,
                     const AntialiasingSettings& antialiasing, bool skip) {
  using Names = std::vector<std::string>;
  const bool encodes = configuration.output.display.present() && antialiasing.taa;
  const Names surfaces = skip ? Names{kSurfacesBuffer} : Names{};
  if (encodes) {
    schedule.buffers.push_back(transient("encoded", Element::Float32, 3));
    schedule.buffers.push_back(history("antialiased", Element::Float32, 3));
  }
  if (skip)
    addStage(schedule, std::make_unique<Background>(encodes), surfaces,
             encodes ? Names{"encoded", "antialiased"} : Names{});
  addStage(schedule, std::make_unique<Remodulate>(filtered, encodes, skip),
           joinedNames(joinedNames({filtered, "guides"}, surfaces),
                       dividesByFBeta(configuration) ? Names{"fBeta"} : Names{}),
           encodes ? Names{"encoded"} : Names{});
  if (!encodes) return;
  addStage(schedule, std::make_unique<TemporalAntialiasing>(antialiasing.taaNewestWeight, skip),
           joinedNames({"encoded", "antialiased.prev", "pixelPrev", "reprojectionMask"}, surfaces),
           {"antialiased"});
}

}  // namespace quell
