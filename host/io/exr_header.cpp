#include "host/io/exr_header.hpp"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiView.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>
#include <openexr.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "host/io/exr_attributes.hpp"
#include "host/io/exr_open.hpp"

namespace quell::io {
namespace {

/// Images beyond this many pixels (16384 x 16384) are taken for damaged headers rather than allocated.
constexpr std::int64_t kMaxPixels = std::int64_t(1) << 28;
/// Of an entry in a file's table of lines or tiles.
constexpr std::int64_t kTableEntryBytes = 8;
/// Bytes of pixels in one of a file, at most, far above what compressors make of a picture of one colour (OpenEXR 3.1: 1289
/// with PXR24, the most of those without loss, and 29455 with DWAB).
constexpr std::int64_t kMostRatio = 4096;
constexpr std::int64_t kMostRatioDwa = 65536;

/// A file whose header alone is read. OpenEXR would print its errors if nobody else took them.
class HeaderReader {
 public:
  explicit HeaderReader(const std::string& path) {
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    start.user_data = &m_message;
    start.error_handler_fn = [](exr_const_context_t context, exr_result_t, const char* message) {
      void* text = nullptr;
      if (context != nullptr && exr_get_user_data(context, &text) == EXR_ERR_SUCCESS && text != nullptr)
        *static_cast<std::string*>(text) = message;
    };
    check(exr_start_read(&m_context, path.c_str(), &start));
  }
  HeaderReader(const HeaderReader&) = delete;
  HeaderReader& operator=(const HeaderReader&) = delete;
  ~HeaderReader() {
    if (m_context != nullptr) exr_finish(&m_context);
  }

  int parts() const {
    int count = 0;
    check(exr_get_count(m_context, &count));
    return count;
  }
  exr_attr_box2i_t dataWindow(int part) const {
    exr_attr_box2i_t window{};
    check(exr_get_data_window(m_context, part, &window));
    return window;
  }
  bool isDeep(int part) const {
    exr_storage_t storage = EXR_STORAGE_SCANLINE;
    check(exr_get_storage(m_context, part, &storage));
    return storage == EXR_STORAGE_DEEP_SCANLINE || storage == EXR_STORAGE_DEEP_TILED;
  }
  std::int64_t chunks(int part) const {
    std::int32_t count = 0;
    check(exr_get_chunk_count(m_context, part, &count));
    return count;
  }

  std::int64_t bytesOfPixel(int part) const {
    const exr_attr_chlist_t* channels = nullptr;
    check(exr_get_channels(m_context, part, &channels));
    std::int64_t bytes = 0;
    for (int i = 0; i < channels->num_channels; ++i)
      bytes += channels->entries[i].pixel_type == EXR_PIXEL_HALF ? 2 : 4;
    return bytes;
  }
  std::int64_t mostRatio(int part) const {
    exr_compression_t compression = EXR_COMPRESSION_NONE;
    check(exr_get_compression(m_context, part, &compression));
    const bool dwa = compression == EXR_COMPRESSION_DWAA || compression == EXR_COMPRESSION_DWAB;
    return dwa ? kMostRatioDwa : kMostRatio;
  }

  bool hasLines(int part) const {
    exr_storage_t storage = EXR_STORAGE_SCANLINE;
    check(exr_get_storage(m_context, part, &storage));
    return storage == EXR_STORAGE_SCANLINE;
  }
  /// Throws where lines of a part are not within the bytes of the file.
  void requireLines(int part, std::int64_t fileBytes) const {
    const exr_attr_box2i_t window = dataWindow(part);
    std::int32_t linesEach = 1;
    check(exr_get_scanlines_per_chunk(m_context, part, &linesEach));
    for (std::int64_t y = window.min.y; y <= window.max.y; y += std::max(linesEach, 1)) {
      exr_chunk_info_t chunk{};
      check(exr_read_scanline_chunk_info(m_context, part, int(y), &chunk));
      if (chunk.data_offset + chunk.packed_size > std::uint64_t(fileBytes))
        throw std::runtime_error(fmt::format("a file that ends within line {} of {}", y - window.min.y,
                                             std::int64_t(window.max.y) - window.min.y + 1));
    }
  }

 private:
  void check(exr_result_t result) const {
    if (result == EXR_ERR_SUCCESS) return;
    throw std::runtime_error(m_message.empty() ? exr_get_default_error_message(result) : m_message);
  }

  std::string m_message;
  exr_context_t m_context = nullptr;
};

PixelWindow toWindow(const Imath::Box2i& box) {
  return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

/// "layer.pass" of "layer.pass-left", which Blender writes, or of "layer.pass.left".
std::string withoutView(const std::string& name, const std::string& view) {
  const std::size_t length = name.size() - std::min(name.size(), view.size() + 1);
  const bool ends = !view.empty() && length > 0 && name.compare(length + 1, view.size(), view) == 0 &&
                    (name[length] == '-' || name[length] == '.');
  return ends ? name.substr(0, length) : name;
}

void addView(std::vector<std::string>& views, const std::string& view) {
  if (!view.empty() && std::find(views.begin(), views.end(), view) == views.end()) views.push_back(view);
}

}  // namespace

std::string nameInFile(const ExrHeader& header, const ExrPart& part, const std::string& channel) {
  if (header.parts.size() == 1) return channel;
  const std::size_t dot = channel.rfind('.');
  std::string pass = dot == std::string::npos ? withoutView(part.name, part.view) : channel.substr(0, dot);
  if (pass == channel) pass.clear();  // a part of one channel
  if (!part.view.empty() && pass != part.view) pass += (pass.empty() ? "" : ".") + part.view;
  return (pass.empty() ? "" : pass + ".") + channel.substr(dot + 1);  // of the whole name without a dot
}

void requirePlausibleHeader(const std::string& path) {
  const HeaderReader reader(path);
  const std::int64_t fileBytes = std::int64_t(std::filesystem::file_size(path));
  requireAttributesWithin(path, fileBytes);
  std::int64_t tableBytes = 0;
  for (int part = 0; part < reader.parts(); ++part) {
    if (reader.isDeep(part)) throw std::invalid_argument("deep pixels, of several samples each");
    const exr_attr_box2i_t window = reader.dataWindow(part);
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
    const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMaxPixels / height)
      throw std::length_error(fmt::format("a data window of {}x{} pixels", width, height));
    tableBytes += kTableEntryBytes * reader.chunks(part);
    const std::int64_t leastBytes = width * height / reader.mostRatio(part) * reader.bytesOfPixel(part);
    if (tableBytes > fileBytes || leastBytes > fileBytes)
      throw std::length_error(
          fmt::format("a data window of {}x{} pixels in a file of {} bytes", width, height, fileBytes));
  }
}

void requireAllLines(const std::string& path) {
  withExrErrors(path, [&] {
    const HeaderReader reader(path);
    const std::int64_t fileBytes = std::int64_t(std::filesystem::file_size(path));
    for (int part = 0; part < reader.parts(); ++part)
      if (reader.hasLines(part)) reader.requireLines(part, fileBytes);
  });
}

ExrHeader describe(const std::vector<Imf::Header>& headers) {
  ExrHeader result;
  for (const Imf::Header& header : headers) {
    ExrPart part;
    if (header.hasName()) part.name = header.name();
    if (header.hasView()) part.view = header.view();
    part.data = toWindow(header.dataWindow());
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
      part.channels.emplace_back(channel.name());
    addView(result.views, part.view);
    if (Imf::hasMultiView(header))
      for (const std::string& view : Imf::multiView(header)) addView(result.views, view);
    result.parts.push_back(std::move(part));
  }
  for (const ExrPart& part : result.parts)
    for (const std::string& channel : part.channels)
      result.channels.push_back(nameInFile(result, part, channel));
  result.windows = {result.parts.front().data, toWindow(headers.front().displayWindow())};
  result.width = result.windows.data.width;
  result.height = result.windows.data.height;
  result.attributes = std::make_shared<const Imf::Header>(headers.front());
  return result;
}

ExrHeader readExrHeader(const std::string& path) {
  return withExrErrors(path, [&] { return describe(openExr(path)); });
}

}  // namespace quell::io
