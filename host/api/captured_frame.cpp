#include "host/api/captured_frame.hpp"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

#include "host/api/captured_lines.hpp"
#include "host/core/fnv1a.hpp"
#include "host/core/render_rectangle.hpp"
#include "host/core/whole_file.hpp"

namespace quell {
namespace {

// First words of the files; the numbers change with the layout.
constexpr char kFactsFormat[] = "quell-capture";
constexpr char kFrameFormat[] = "quell-captured-frame";
constexpr int kFormatVersion = 1;

template <class Lines>
void describeFormat(Lines& lines, const char* format) {
  int version = kFormatVersion;
  lines.line(format, version);
  if constexpr (Lines::kReads)
    if (version != kFormatVersion)
      lines.refuse("version " + std::to_string(kFormatVersion) + " of the format", std::to_string(version));
}

template <class Lines, class Facts>
void describeFacts(Lines& lines, Facts& facts) {
  describeFormat(lines, kFactsFormat);
  lines.text("version", facts.version);
  lines.text("method", facts.method);
  lines.count("identity", facts.identity);
  for (auto& part : facts.identity) lines.text("is", part);
  lines.line("lanes", facts.lanes);
  lines.line("mapping", facts.options.mapping);
  if constexpr (Lines::kReads)
    if (facts.options.mapping > Mapping::Wide16) lines.refuse("a mapping that there is", "another number");
  lines.line("workGroup", facts.options.workGroup);
  lines.line("fitGroup", facts.options.fitGroup);
  lines.count("keptBuffers", facts.options.keptBuffers);
  for (auto& name : facts.options.keptBuffers) lines.text("kept", name);
}

template <class Lines, class FrameType>
void describeNumbers(Lines& lines, FrameType& frame) {
  lines.line("size", frame.size.width, frame.size.height);
  lines.lineIf(hasRenderSize(frame), "renderSize", frame.renderSize.width, frame.renderSize.height);
  lines.line("worldToClip", frame.camera.worldToClip);
  lines.line("worldToClipPrev", frame.camera.worldToClipPrev);
  lines.line("jitterPx", frame.camera.jitterPx);
  lines.line("demodulated", frame.demodulated);
  lines.line("depthKind", frame.depthKind, frame.depthNear, frame.depthFar);
  lines.line("motionScale", frame.motionScale);
  lines.line("sampleCount", frame.sampleCount);
}

/// A block of bytes behind the lines: how many, and their hash; none where nothing was read.
template <class Lines, class Content>
void describeContent(Lines& lines, Content& content, std::uint64_t size) {
  std::uint64_t bytes = content.size();
  Hash hash{fnv1a(content.data(), content.size())};
  lines.line("content", bytes, hash);
  if constexpr (Lines::kReads) {
    if (bytes != 0 && bytes != size)
      lines.refuse("a content of " + std::to_string(size) + " bytes", std::to_string(bytes));
    lines.expectContent(content, bytes, hash);
  }
}

template <class Lines, class Captured>
void describeFrame(Lines& lines, Captured& captured) {
  describeFormat(lines, kFrameFormat);
  lines.line("frameIndex", captured.frameIndex);
  describeNumbers(lines, captured.frame);
  lines.count("settings", captured.settings);
  for (auto& [name, value] : captured.settings) {
    lines.text("setting", name);
    lines.text("value", value);
  }
  lines.count("memories", captured.memories);
  for (auto& m : captured.memories) {
    lines.line("memory", m.isImage, m.base, m.order, m.type, m.width, m.height, m.size);
    describeContent(lines, m.content, m.size);
  }
  lines.count("views", captured.views);
  for (auto& v : captured.views)
    lines.line("view", v.name, v.memory, v.view.format, v.view.sum, v.view.channels, v.view.offsetBytes,
               v.view.pixelStrideBytes, v.view.rowPitchBytes);
  lines.count("histories", captured.histories);
  for (auto& history : captured.histories) {
    std::uint64_t size = history.content.size();
    lines.text("history", history.name);
    lines.line("copy", history.copy, size);
    describeContent(lines, history.content, size);
  }
  lines.count("outputs", captured.outputs);
  for (auto& output : captured.outputs) {
    Hash hash{output.hash};
    lines.line("output", output.name, hash);
    if constexpr (Lines::kReads) output.hash = hash.value;
  }
}

Bytes readBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return bytes;
}

}  // namespace

std::string frameFileName(int number) {
  char name[32];
  std::snprintf(name, sizeof(name), "frame_%04d.bin", number);
  return name;
}

std::string factsText(const CapturedFacts& facts) {
  LineWriter lines;
  describeFacts(lines, facts);
  return lines.finish();
}

std::string writeFrame(const std::string& path, const CapturedFrame& frame) {
  LineWriter lines;
  describeFrame(lines, frame);
  const std::string text = lines.finish();
  std::vector<FilePart> parts = {{text.data(), text.size()}};
  for (const CapturedMemory& memory : frame.memories)
    parts.push_back({memory.content.data(), memory.content.size()});
  for (const CapturedHistory& history : frame.histories)
    parts.push_back({history.content.data(), history.content.size()});
  return writeWholeFile(path, parts);
}

CapturedFacts readFacts(const std::string& path) {
  const Bytes bytes = readBytes(path);
  LineReader lines(path, bytes);
  CapturedFacts facts;
  describeFacts(lines, facts);
  return facts;
}

CapturedFrame readFrame(const std::string& path) {
  const Bytes bytes = readBytes(path);
  LineReader lines(path, bytes);
  CapturedFrame frame;
  describeFrame(lines, frame);
  lines.readContents(bytes);
  return frame;
}

}  // namespace quell
