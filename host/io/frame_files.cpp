#include "host/io/frame_files.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <tuple>
#include <utility>

#include "host/io/file_error.hpp"
#include "host/io/frame_names.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "open sequence";
constexpr char kExtension[] = ".exr";
/// Of numbers where no file shows how many there are.
constexpr int kUsualDigits = 4;
/// Ranges of missing frames that a message lists.
constexpr int kMostRanges = 4;

std::vector<std::string> listFiles(const std::string& directory) {
  return listEntries(directory, [](const fs::directory_entry& entry) {
    std::error_code dangling;
    return entry.is_regular_file(dangling);
  });
}

/// Sequences by what their names have in common.
class Groups {
 public:
  explicit Groups(std::string directory) : m_directory(std::move(directory)) {}

  void add(const std::string& name) {
    const NumberedName split = splitName(name);
    m_groups
        .try_emplace(keyOf(split.prefix, split.suffix, split.digits > 0), m_directory, split.prefix,
                     split.suffix)
        .first->second.add(split.frame, name, split.digits);
  }
  std::map<std::string, FrameFiles> take() { return std::move(m_groups); }

 private:
  std::string m_directory;
  std::map<std::string, FrameFiles> m_groups;
};

std::string directoryOf(const std::string& path) {
  const std::string directory = fs::path(path).parent_path().string();
  return directory.empty() ? "." : directory;
}

/// Where "%d" or "%04d" begins and ends; npos twice where there is none.
std::pair<std::size_t, std::size_t> findPrintf(const std::string& pattern) {
  for (std::size_t begin = pattern.rfind('%'); begin != std::string::npos;
       begin = begin > 0 ? pattern.rfind('%', begin - 1) : std::string::npos) {
    std::size_t end = begin + 1;
    while (end < pattern.size() && isDigit(pattern[end])) ++end;
    if (end < pattern.size() && pattern[end] == 'd') return {begin, end + 1};
  }
  return {std::string::npos, std::string::npos};
}

/// Where the last run of '#' begins and ends.
std::pair<std::size_t, std::size_t> findHashes(const std::string& pattern) {
  const std::size_t last = pattern.rfind('#');
  if (last == std::string::npos) return {last, last};
  const std::size_t before = pattern.find_last_not_of('#', last);
  return {before == std::string::npos ? 0 : before + 1, last + 1};
}

FrameFiles filesAround(const std::string& directory, const std::string& prefix, const std::string& suffix) {
  FrameFiles files(directory, prefix, suffix);
  for (const std::string& name : listFiles(directory)) {
    if (name.size() <= prefix.size() + suffix.size() || name.compare(0, prefix.size(), prefix) != 0 ||
        name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
      continue;
    const std::size_t end = name.size() - suffix.size();
    const bool negative = name[prefix.size()] == '-';
    const std::size_t begin = prefix.size() + (negative ? 1 : 0);
    int frame = 0;
    const auto parsed = std::from_chars(name.data() + begin, name.data() + end, frame);
    if (begin == end || !isDigit(name[begin]) || parsed.ec != std::errc() || parsed.ptr != name.data() + end)
      continue;
    files.add(negative ? -frame : frame, name, int(end - begin));
  }
  return files;
}

}  // namespace

std::string paddedFrame(int frame) {
  return frame < 0 ? fmt::format("-{:04}", -std::int64_t(frame)) : fmt::format("{:04}", frame);
}

std::string missingText(const std::vector<int>& frames) {
  std::string text;
  int ranges = 0;
  bool several = false;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const int first = frames[i - 1] + 1, last = frames[i] - 1;
    if (last < first) continue;
    several = several || ranges > 0 || last > first;
    if (ranges++ == kMostRanges) {
      text += ", ...";
      break;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ", ", first);
    if (last > first) text += fmt::format(" to {}", last);
  }
  return text.empty() ? text : (several ? "no frames " : "no frame ") + text;
}

FrameFiles::FrameFiles(std::string directory, std::string prefix, std::string suffix)
    : m_directory(std::move(directory)), m_prefix(std::move(prefix)), m_suffix(std::move(suffix)) {}

void FrameFiles::add(int frame, const std::string& name, int digits) {
  const auto [known, isNew] = m_names.try_emplace(frame, name);
  if (!isNew)
    throwFileError(kStage, path(frame), fmt::format("one file for frame {}", frame),
                   fmt::format("{} as well; move one of them elsewhere", name));
  m_digits = m_names.size() == 1 ? digits : std::min(m_digits, digits);
}

std::vector<int> FrameFiles::frames() const {
  std::vector<int> numbers;
  for (const auto& [frame, name] : m_names) numbers.push_back(frame);
  return numbers;
}

std::string FrameFiles::path(int frame) const {
  const auto known = m_names.find(frame);
  if (known != m_names.end()) return joinPath(m_directory, known->second);
  return joinPath(m_directory, fmt::format("{}{}{:0{}}{}", m_prefix, frame < 0 ? "-" : "", std::abs(frame),
                                           m_names.empty() ? kUsualDigits : m_digits, m_suffix));
}

std::string FrameFiles::numberText(int frame) const {
  const std::string name = fs::path(path(frame)).filename().string();
  return name.substr(m_prefix.size(), name.size() - m_prefix.size() - m_suffix.size());
}

std::string FrameFiles::pattern() const {
  const int digits = m_names.empty() ? kUsualDigits : m_digits;
  return joinPath(m_directory, m_prefix + std::string(std::size_t(digits), '#') + m_suffix);
}

void FrameFiles::requireNoGaps() const {
  if (m_names.empty())
    throwFileError(kStage, m_directory,
                   fmt::format("at least one frame such as {}{}{}", m_prefix, paddedFrame(0), m_suffix),
                   "none");
  const std::vector<int> numbers = frames();
  const std::string missing = missingText(numbers);
  if (missing.empty()) return;
  int gap = numbers.front() + 1;
  while (has(gap)) ++gap;
  throwFileError(kStage, path(gap),
                 fmt::format("frames {} to {} without gaps", numbers.front(), numbers.back()),
                 fmt::format("{}; --missing skip goes on without them, as after a cut", missing));
}

void FrameFiles::requireAll(const std::vector<int>& frames) const {
  for (const int frame : frames)
    if (!has(frame))
      throwFileError(kStage, path(frame), fmt::format("this buffer for each of the {} frames", frames.size()),
                     "no such file");
}

FrameDirectory::FrameDirectory(std::string path) : m_path(std::move(path)) {
  Groups groups(m_path);
  for (const std::string& name : listFiles(m_path))
    if (lowerCase(fs::path(name).extension().string()) == kExtension) groups.add(name);
  m_byKey = groups.take();
}

const FrameFiles& FrameDirectory::withPrefix(const std::string& prefix) const {
  return m_byKey.try_emplace(keyOf(prefix, kExtension, true), m_path, prefix, kExtension).first->second;
}

std::vector<FrameFiles> FrameDirectory::all() const {
  std::vector<FrameFiles> sequences;
  for (const auto& [key, files] : m_byKey)
    if (!files.empty()) sequences.push_back(files);
  return sequences;
}

FrameFiles oneFile(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  const NumberedName split = splitName(name);
  FrameFiles files(fs::path(path).parent_path().string(), split.prefix, split.suffix);
  files.add(split.frame, name, split.digits);
  return files;
}

bool isFramePattern(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  return findPrintf(name).first != std::string::npos || name.find_first_of("#*?[") != std::string::npos;
}

FrameFiles findFrameFiles(const std::string& pattern) {
  const std::string name = fs::path(pattern).filename().string(), directory = directoryOf(pattern);
  auto [begin, end] = findPrintf(name);
  if (begin == std::string::npos) std::tie(begin, end) = findHashes(name);
  std::vector<FrameFiles> found;
  if (begin != std::string::npos) {
    found.push_back(filesAround(directory, name.substr(0, begin), name.substr(end)));
  } else {
    Groups groups(directory);
    for (const std::string& file : listFiles(directory))
      if (fnmatch(name.c_str(), file.c_str(), FNM_PERIOD) == 0) groups.add(file);
    for (auto& [key, files] : groups.take()) found.push_back(std::move(files));
  }
  if (found.empty() || found.front().empty())
    throwFileError(kStage, pattern, "files whose names are like that", "none in the directory");
  return requireOneSequence(pattern, found);
}

FrameFiles listedFiles(const std::vector<std::string>& paths) {
  std::map<std::string, Groups> byDirectory;
  for (const std::string& path : paths) {
    std::error_code failure;
    if (!fs::is_regular_file(path, failure))
      throwFileError(kStage, path, "a file beside others of a sequence", "none");
    const std::string directory = directoryOf(path);
    byDirectory.try_emplace(directory, directory).first->second.add(fs::path(path).filename().string());
  }
  std::vector<FrameFiles> found;
  for (auto& [directory, groups] : byDirectory)
    for (auto& [key, files] : groups.take()) found.push_back(std::move(files));
  return requireOneSequence(paths.front(), found);
}

FrameFiles requireOneSequence(const std::string& path, const std::vector<FrameFiles>& all) {
  if (all.size() > 1)
    throwFileError(kStage, path, "the frames of one sequence",
                   fmt::format("{} of them, such as {} and {}; name one of them as --input", all.size(),
                               all[0].pattern(), all[1].pattern()));
  return all.front();
}

}  // namespace quell::io
