// A frame of the caller as a file: all that it takes to run it again bit for bit.
#pragma once

#include <cstdint>
#include <quell/denoiser.hpp>
#include <string>
#include <utility>
#include <vector>

namespace quell {

using Bytes = std::vector<unsigned char>;

/// A memory object of the caller, as far as the frame's images lie in it.
struct CapturedMemory {
  bool isImage = false;
  std::uint64_t base = 0;   ///< buffers: bytes of the object before what is here
  std::uint32_t order = 0;  ///< images: cl_channel_order
  std::uint32_t type = 0;   ///< images: cl_channel_type
  std::uint64_t width = 0;  ///< images: texels
  std::uint64_t height = 0;
  std::uint64_t size = 0;  ///< bytes
  Bytes content = {};      ///< `size` bytes, or none where only outputs lie in it
};

/// A view whose `memory` is an index.
struct CapturedView {
  std::string name;  ///< as namedViews() has it
  int memory = 0;
  ImageView view;
};

/// A buffer of the denoiser that frames before have left.
struct CapturedHistory {
  std::string name;
  int copy = 0;  ///< 0 or 1, written by frames of this parity
  Bytes content;
};

struct CapturedOutput {
  std::string name;  ///< the member of Output
  std::uint64_t hash = 0;
};

struct CapturedFrame {
  std::uint32_t frameIndex = 0;  ///< since the history was reset
  Frame frame;                   ///< all but the images
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<CapturedMemory> memories;
  std::vector<CapturedView> views;
  std::vector<CapturedHistory> histories;  ///< of the first frame of a capture, where there is a history
  std::vector<CapturedOutput> outputs;
};

/// What is the same for all frames of a capture.
struct CapturedFacts {
  std::string version;  ///< of the library
  std::string method;
  std::vector<std::string> identity;  ///< of the device, as kIdentityNames
  int lanes = 0;                      ///< pixels a work-item
  Options options;
};
constexpr const char* kIdentityNames[] = {"vendor", "device", "OpenCL version", "driver"};

constexpr char kFactsFile[] = "capture.txt";
std::string frameFileName(int number);

/// Files as the docs have them (docs/embedding.md): lines of text with a checksum, of frames with the bytes behind them.
std::string factsText(const CapturedFacts& facts);
/// Returns what the system says against it, else an empty text.
std::string writeFrame(const std::string& path, const CapturedFrame& frame);

/// Throw Error(FileError) naming the file and what is wrong with it.
CapturedFacts readFacts(const std::string& path);
CapturedFrame readFrame(const std::string& path);

}  // namespace quell
