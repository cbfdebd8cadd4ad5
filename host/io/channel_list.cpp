// How channels are told to people.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/io/channel_map.hpp"

namespace quell::io {
namespace {

/// Passes that a message lists.
constexpr std::size_t kMostPasses = 40;
constexpr char kLetterOrder[] = "RGBAXYZWrgbaxyzw";

struct Pass {
  std::string name;
  std::string letters;
};

/// Channels of one letter by the pass that they belong to; others by themselves.
std::vector<Pass> passesOf(const std::vector<std::string>& channels) {
  std::vector<Pass> passes;
  for (const std::string& channel : channels) {
    const std::size_t dot = channel.rfind('.');
    const std::size_t begin = dot == std::string::npos ? 0 : dot + 1;
    if (channel.size() - begin != 1) {
      passes.push_back({channel, {}});
      continue;
    }
    const std::string name = channel.substr(0, begin);
    const auto same = std::find_if(passes.begin(), passes.end(), [&](const Pass& pass) {
      return pass.name == name && !pass.letters.empty();
    });
    if (same == passes.end()) {
      passes.push_back({name, channel.substr(begin)});
    } else {
      same->letters += channel.substr(begin);
    }
  }
  return passes;
}

}  // namespace

std::string channelList(const std::vector<std::string>& channels) {
  const std::string order = kLetterOrder;
  std::vector<std::string> texts;
  std::vector<Pass> passes = passesOf(channels);
  for (Pass& pass : passes) {
    std::stable_sort(pass.letters.begin(), pass.letters.end(),
                     [&](char a, char b) { return order.find(a) < order.find(b); });
    texts.push_back(pass.name + pass.letters);
  }
  const std::size_t count = texts.size();
  if (count > kMostPasses) texts.resize(kMostPasses);
  std::string list = fmt::format("{}", fmt::join(texts, ", "));
  if (count > kMostPasses) list += fmt::format(", ... ({} in all)", count);
  return count == 0 ? "none" : list;
}

std::vector<std::string> describe(const ChannelMap& map) {
  std::vector<std::string> lines;
  std::string names = map.renderer.empty() ? "channels as named" : "channels as of " + map.renderer;
  if (!map.layer.empty()) names += ", layer " + map.layer;
  if (!map.view.empty()) names += ", view " + map.view;
  lines.push_back(names);
  for (const NamedImage& image : namedImages()) {
    const auto found = map.images.find(image.name);
    if (found == map.images.end()) continue;
    std::vector<std::string> terms;
    for (const std::vector<std::string>& term : found->second.terms) terms.push_back(channelList(term));
    std::string from = fmt::format("{}", fmt::join(terms, " + "));
    const NumberKind& kind = found->second.kind;
    if (kind.depth != DepthKind::View) from += fmt::format(" ({})", toString(kind.depth));
    if (const std::string motion = toString(kind.motion); !motion.empty())
      from += fmt::format(" ({})", motion);
    lines.push_back(fmt::format("  {:<12} {}", image.name, from));
  }
  for (const NamedImage& image : namedImages())
    if (image.cost[0] != '\0' && !map.has(image.name))
      lines.push_back(fmt::format("  {:<12} not there: {}", image.name, image.cost));
  return lines;
}

}  // namespace quell::io
