#include "host/core/program_groups.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>

#include "host/core/kernel_sources.hpp"

namespace quell {
namespace {

constexpr std::string_view kDefine = " -D ";
constexpr std::string_view kFormatOption = "_FORMAT";  // of images, see kernels/common/image_access.h

/// What the compiler is told beside definitions, and these one by one.
struct CompileOptions {
  std::string flags;
  std::vector<std::string> defines;  ///< NAME=VALUE
};

CompileOptions parseOptions(const std::string& text) {
  CompileOptions options;
  std::size_t end = text.find(kDefine);
  options.flags = text.substr(0, end);
  while (end != std::string::npos) {
    const std::size_t begin = end + kDefine.size();
    end = text.find(kDefine, begin);
    options.defines.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return options;
}

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The names that the source looks for by #ifdef, #ifndef or defined(). All else that it evaluates must be given
/// (scripts/lint-kernels, -Wundef).
std::set<std::string_view> askedNames(std::string_view source) {
  std::set<std::string_view> names;
  for (const std::string_view question : {"#ifdef ", "#ifndef ", "defined("}) {
    for (std::size_t at = source.find(question); at != source.npos; at = source.find(question, at)) {
      at += question.size();
      std::size_t end = at;
      while (end < source.size() && isWordCharacter(source[end])) ++end;
      names.insert(source.substr(at, end - at));
    }
  }
  return names;
}

/// What decides on whom a kernel can share a program with.
struct Meaning {
  std::string flags;
  std::map<std::string, std::string> values;  ///< of the options that are given
  std::set<std::string_view> asked;           ///< whether these are given matters
  bool ofImages = false;                      ///< an option is the layout of an image
};

bool endsWith(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

Meaning meaningOf(const KernelUse& use) {
  const CompileOptions options = parseOptions(use.options);
  Meaning meaning{options.flags, {}, askedNames(kernelSource(use.stem))};
  for (const std::string& define : options.defines) {
    const std::size_t sign = define.find('=');
    const std::string name = define.substr(0, sign);
    meaning.values[name] = sign == std::string::npos ? "" : define.substr(sign + 1);
    meaning.ofImages = meaning.ofImages || endsWith(name, kFormatOption);
  }
  return meaning;
}

/// Whether the options of `a` change nothing for `b`.
bool leavesAlone(const Meaning& a, const Meaning& b) {
  return std::all_of(a.values.begin(), a.values.end(), [&](const auto& option) {
    const auto found = b.values.find(option.first);
    return found == b.values.end() ? b.asked.count(option.first) == 0 : found->second == option.second;
  });
}

bool canShare(const Meaning& a, const Meaning& b) {
  return !a.ofImages && !b.ofImages && a.flags == b.flags && leavesAlone(a, b) && leavesAlone(b, a);
}

/// A group while it grows.
struct Growing {
  ProgramGroup group;
  std::vector<Meaning> meanings;

  bool takes(const KernelUse& use, const Meaning& meaning) const {
    for (std::size_t i = 0; i < meanings.size(); ++i)
      if (group.kernels[i].stem == use.stem || !canShare(meanings[i], meaning)) return false;
    return true;
  }
};

}  // namespace

const std::string& kernelSource(const std::string& stem) {
  const auto found = kernelSources().find(stem);
  if (found == kernelSources().end()) throw std::logic_error("no kernel source " + stem);
  return found->second;
}

std::string ProgramGroup::source() const {
  std::string text;
  for (const KernelUse& use : kernels) text += kernelSource(use.stem);
  return text;
}

std::string ProgramGroup::options() const {
  std::string text = parseOptions(kernels.front().options).flags;
  std::set<std::string> given;
  for (const KernelUse& use : kernels)
    for (const std::string& define : parseOptions(use.options).defines)
      if (given.insert(define).second) text.append(kDefine).append(define);
  return text;
}

std::string ProgramGroup::name() const {
  std::string text;
  for (const KernelUse& use : kernels) text += (text.empty() ? "" : ", ") + use.stem;
  return text;
}

std::vector<ProgramGroup> groupKernels(const std::vector<KernelUse>& uses) {
  std::vector<Growing> growing;
  std::set<KernelUse> seen;
  for (const KernelUse& use : uses) {
    if (!seen.insert(use).second) continue;
    Meaning meaning = meaningOf(use);
    auto place = std::find_if(growing.begin(), growing.end(),
                              [&](const Growing& group) { return group.takes(use, meaning); });
    if (place == growing.end()) place = growing.insert(place, Growing{});
    place->group.kernels.push_back(use);
    place->meanings.push_back(std::move(meaning));
  }
  std::vector<ProgramGroup> groups;
  for (Growing& group : growing) groups.push_back(std::move(group.group));
  return groups;
}

}  // namespace quell
