#include "host/io/channel_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <quell/error.hpp>
#include <set>

#include "host/io/channel_views.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

constexpr char kStage[] = "open sequence";
constexpr char kAuto[] = "auto";
/// Blender adds what its compositor makes as a layer of this name.
constexpr char kCompositorLayer[] = "Composite";
/// What may stand between a layer and a pass.
constexpr char kSeparators[] = "._-";

using Stored = std::map<std::string, std::string>;
using Names = std::vector<std::string>;
/// Sources by image.
using SourceTable = std::map<std::string, std::vector<ChannelSource>>;

/// How the channels of a pass of so many channels may end.
const Names& endings(int channels) {
  static const Names three = {"RGB", "XYZ", "rgb", "xyz"}, two = {"XY", "RG", "xy", "rg"},
                     one = {"Z", "V", "T", "Y", "R", "X", "I", "A", "z", "y", "r", "x", "a"};
  return channels == 3 ? three : channels == 2 ? two : one;
}

std::optional<Names> findAll(const Stored& stored, const Names& names) {
  Names found;
  for (const std::string& name : names) {
    const auto channel = stored.find(name);
    if (channel == stored.end()) return std::nullopt;
    found.push_back(channel->second);
  }
  return found;
}

std::optional<Names> findPass(const Stored& stored, const std::string& pass, int channels) {
  if (channels == 1)
    if (const auto bare = findAll(stored, {pass})) return bare;
  for (const char* separator : {".", ""}) {
    for (const std::string& letters : endings(channels)) {
      Names names;
      for (const char letter : letters) names.push_back(pass + separator + letter);
      if (const auto found = findAll(stored, names)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Names> findTerm(const Stored& stored, const std::string& prefix, const Names& term,
                              int channels) {
  if (term.size() == 1) return findPass(stored, prefix + term.front(), channels);
  if (int(term.size()) != channels) return std::nullopt;
  Names names;
  for (const std::string& name : term) names.push_back(prefix + name);
  return findAll(stored, names);
}

std::optional<ImageChannels> findSource(const Stored& stored, const Names& prefixes,
                                        const ChannelSource& source, int channels) {
  for (const std::string& prefix : prefixes) {
    ImageChannels found{{}, source.kind};
    for (const Names& term : source.terms)
      if (auto names = findTerm(stored, prefix, term, channels)) found.terms.push_back(std::move(*names));
    if (found.terms.size() == source.terms.size()) return found;
  }
  return std::nullopt;
}

/// What the user says of images; throws for what cannot be.
SourceTable userSources(const ChannelOptions& options) {
  SourceTable sources;
  for (const std::string& text : options.channels) {
    const std::size_t equals = text.find('=');
    const std::string image = text.substr(0, equals);
    const NamedImage* known = equals == std::string::npos ? nullptr : findNamedImage(image);
    if (known == nullptr) {
      Names names;
      for (const NamedImage& one : namedImages()) names.emplace_back(one.name);
      throw Error(ErrorCode::InvalidArgument,
                  {kStage, "--channels",
                   fmt::format("IMAGE=CHANNELS, IMAGE being one of {}", fmt::join(names, ", ")), text});
    }
    sources[image] = parseSources(image, text.substr(equals + 1));
    for (const ChannelSource& source : sources[image])
      for (const Names& term : source.terms)
        if (term.size() > 1 && int(term.size()) != known->channels)
          throw Error(ErrorCode::InvalidArgument,
                      {kStage, "--channels",
                       fmt::format("a pass or {} channels for {}", known->channels, image), text});
  }
  return sources;
}

/// What stands before the colour's pass in the names, with the separator; nothing is among them.
std::set<std::string> prefixesOf(const Stored& stored, const std::vector<ChannelSource>& colors) {
  std::set<std::string> prefixes = {""};
  for (const ChannelSource& color : colors) {
    if (color.terms.front().size() != 1) continue;
    const std::string end = color.terms.front().front() + ".R";
    for (const auto& [name, file] : stored) {
      if (name.size() <= end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0) continue;
      const std::string prefix = name.substr(0, name.size() - end.size());
      if (std::string(kSeparators).find(prefix.back()) != std::string::npos) prefixes.insert(prefix);
    }
  }
  return prefixes;
}

/// One way to read the channels.
struct Candidate {
  ChannelMap map;
  bool complete() const {
    return map.has("color") && map.has("normal") && (map.has("position") || map.has("depth"));
  }
};

/// The colour's alpha stands beside it.
void addAlpha(const Stored& stored, ChannelMap& map) {
  const auto color = map.images.find("color");
  if (color == map.images.end() || map.has("alpha")) return;
  std::string name = color->second.terms.front().front();
  name.back() = name.back() == 'r' ? 'a' : 'A';
  for (const auto& [base, file] : stored)
    if (file == name) map.images["alpha"] = {{{name}}, {}};
}

Candidate makeCandidate(const ViewChannels& channels, const std::string& renderer, const std::string& prefix,
                        const SourceTable& user) {
  Candidate candidate;
  candidate.map.renderer = renderer;
  candidate.map.layer = prefix.substr(0, prefix.size() - (prefix.empty() ? 0 : 1));
  candidate.map.view = channels.view;
  for (const NamedImage& image : namedImages()) {
    const auto given = user.find(image.name);
    const bool isGiven = given != user.end();
    const Names prefixes = isGiven ? Names{"", prefix} : Names{prefix};
    for (const ChannelSource& source : isGiven ? given->second : sourcesOf(renderer, image.name)) {
      if (auto found = findSource(channels.stored, prefixes, source, image.channels)) {
        candidate.map.images[image.name] = std::move(*found);
        break;
      }
    }
  }
  addAlpha(channels.stored, candidate.map);
  return candidate;
}

std::vector<Candidate> allCandidates(const ViewChannels& channels, const ChannelOptions& options) {
  const SourceTable user = userSources(options);
  Names renderers = options.renderer == kAuto ? rendererNames() : Names{options.renderer};
  if (options.renderer == kAuto && !user.empty()) renderers.emplace_back();
  std::vector<Candidate> candidates;
  for (const std::string& renderer : renderers)
    for (const std::string& prefix : prefixesOf(channels.stored, sourcesOf(renderer, "color")))
      candidates.push_back(makeCandidate(channels, renderer, prefix, user));
  return candidates;
}

/// The first of those with the most images.
const Candidate& bestOf(const std::vector<Candidate>& candidates) {
  return *std::max_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.map.images.size() < b.map.images.size();
  });
}

void keep(std::vector<Candidate>& candidates, const std::function<bool(const Candidate&)>& condition) {
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [&](const Candidate& candidate) { return !condition(candidate); }),
                   candidates.end());
}

Names layersOf(const std::vector<Candidate>& candidates) {
  Names layers;
  for (const Candidate& candidate : candidates)
    if (!candidate.map.layer.empty() &&
        std::find(layers.begin(), layers.end(), candidate.map.layer) == layers.end())
      layers.push_back(candidate.map.layer);
  return layers;
}

/// Names under which an image was looked for, for messages.
std::string lookedFor(const ChannelOptions& options, const ChannelMap& map, const std::string& image) {
  const SourceTable user = userSources(options);
  const auto given = user.find(image);
  Names names;
  for (const ChannelSource& source : given != user.end() ? given->second : sourcesOf(map.renderer, image)) {
    Names terms;
    for (const Names& term : source.terms)
      terms.push_back((map.layer.empty() ? "" : map.layer + ".") + fmt::format("{}", fmt::join(term, ",")));
    names.push_back(fmt::format("{}", fmt::join(terms, " + ")));
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

}  // namespace

void requireChannelOptions(const ChannelOptions& options) {
  userSources(options);
  const Names& known = rendererNames();
  if (options.renderer != kAuto && std::find(known.begin(), known.end(), options.renderer) == known.end())
    throw Error(ErrorCode::InvalidArgument,
                {kStage, "--renderer", fmt::format("auto, {}", fmt::join(known, ", ")), options.renderer});
}

void requireImage(const std::string& path, const std::string& image, const ChannelMap& map,
                  const Names& channels, const ChannelOptions& options, const std::string& otherwise) {
  if (map.has(image)) return;
  const std::string names = lookedFor(options, map, image);
  throwFileError(kStage, path,
                 fmt::format("channels of {}{}, or --channels {}=NAME{}", image,
                             names.empty() ? "" : fmt::format(" ({})", names), image, otherwise),
                 channelList(channels));
}

ChannelMap findChannels(const std::string& path, const Names& channels, const Names& views,
                        const ChannelOptions& options) {
  const ViewChannels ofView = channelsOfView(path, channels, views, options.view);
  std::vector<Candidate> candidates = allCandidates(ofView, options);
  const Names allLayers = layersOf(candidates);
  if (!options.layer.empty())
    keep(candidates, [&](const Candidate& candidate) { return candidate.map.layer == options.layer; });
  if (candidates.empty())
    throwFileError(kStage, path, "the view layer " + options.layer,
                   allLayers.empty() ? "none" : fmt::format("{}", fmt::join(allLayers, ", ")));
  const ChannelMap nearest = bestOf(candidates).map;
  keep(candidates, [](const Candidate& candidate) { return candidate.complete(); });
  if (candidates.empty()) {
    for (const char* image : {"color", "normal", "position"})
      requireImage(path, image, nearest, channels, options);
  }
  const ChannelMap best = bestOf(candidates).map;
  keep(candidates, [&](const Candidate& candidate) { return candidate.map.renderer == best.renderer; });
  const Names layers = layersOf(candidates);
  if (layers.size() > 1)
    keep(candidates, [](const Candidate& candidate) { return candidate.map.layer != kCompositorLayer; });
  if (layersOf(candidates).size() > 1)
    throwFileError(kStage, path, "one view layer, or --layer NAME",
                   fmt::format("{}", fmt::join(layersOf(candidates), ", ")));
  const ChannelMap& found = bestOf(candidates).map;
  for (const auto& [image, sources] : userSources(options))
    requireImage(path, image, found, channels, options);  // also what would do without, once it is asked for
  return found;
}

bool hasFrameChannels(const Names& channels, const Names& views, const ChannelOptions& options) {
  ChannelOptions any = options;
  any.layer.clear();
  try {
    const ViewChannels ofView = channelsOfView({}, channels, views, options.view);
    const std::vector<Candidate> candidates = allCandidates(ofView, any);
    return std::any_of(candidates.begin(), candidates.end(),
                       [](const Candidate& candidate) { return candidate.complete(); });
  } catch (const Error& error) {
    return error.code() == ErrorCode::FileError;  // views to choose from are those of a frame
  }
}

}  // namespace quell::io
