#include "host/io/channel_views.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

constexpr char kStage[] = "open sequence";

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

/// A channel's name in two.
struct SplitName {
  std::string base;
  std::string view;  ///< empty: none
};

SplitName splitView(const std::string& name, const std::vector<std::string>& views) {
  const std::size_t last = name.rfind('.');
  if (last == std::string::npos || last == 0) return {name, {}};
  const std::size_t before = name.rfind('.', last - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::string view = name.substr(begin, last - begin);
  if (!contains(views, view)) return {name, {}};
  return {name.substr(0, begin) + name.substr(last + 1), view};
}

}  // namespace

ViewChannels channelsOfView(const std::string& path, const std::vector<std::string>& channels,
                            const std::vector<std::string>& declared, const std::string& wanted) {
  std::vector<std::string> known = declared;
  for (const char* usual : {"left", "right"})
    if (!contains(known, usual)) known.emplace_back(usual);
  std::vector<std::string> present;
  std::vector<SplitName> names;
  for (const std::string& channel : channels) {
    names.push_back(splitView(channel, known));
    std::string& view = names.back().view;
    if (view.empty() && !declared.empty()) view = declared.front();
    if (!view.empty() && !contains(present, view)) present.push_back(view);
  }
  if (present.size() > 1 && wanted.empty())
    throwFileError(kStage, path, "one view, or --view NAME", fmt::format("{}", fmt::join(present, ", ")));
  if (!wanted.empty() && !contains(present, wanted))
    throwFileError(kStage, path, "the view " + wanted,
                   present.empty() ? "no views" : fmt::format("{}", fmt::join(present, ", ")));
  ViewChannels result{wanted.empty() && !present.empty() ? present.front() : wanted, {}};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].view.empty() || names[i].view == result.view) result.stored[names[i].base] = channels[i];
  return result;
}

}  // namespace quell::io
