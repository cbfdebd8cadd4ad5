// Intermediate buffers and the map of background in the C API.
#include <algorithm>

#include "host/c_api/boundary.hpp"
#include "host/c_api/handles.hpp"

using namespace quell::c_api;

extern "C" {

quell_status quellCountBuffers(quell_denoiser* denoiser, size_t* count) {
  return guarded("quellCountBuffers", [&] {
    require(denoiser, "quellCountBuffers", "denoiser");
    require(count, "quellCountBuffers", "count");
    denoiser->buffers = denoiser->denoiser.bufferNames();
    *count = denoiser->buffers.size();
  });
}

quell_status quellGetBufferName(const quell_denoiser* denoiser, size_t index, const char** name) {
  return guarded("quellGetBufferName", [&] {
    require(denoiser, "quellGetBufferName", "denoiser");
    require(name, "quellGetBufferName", "name");
    requireIndex(index, denoiser->buffers.size(), "quellGetBufferName", "index");
    *name = denoiser->buffers[index].c_str();
  });
}

quell_status quellReadBuffer(const quell_denoiser* denoiser, const char* name, float* values, size_t capacity,
                             quell_buffer_content* content) {
  return guarded("quellReadBuffer", [&] {
    require(denoiser, "quellReadBuffer", "denoiser");
    require(name, "quellReadBuffer", "name");
    requireCapacity(values, capacity, 0, "quellReadBuffer", "values");
    require(content, "quellReadBuffer", "content");
    const quell::BufferContent read = denoiser->denoiser.readBuffer(name);
    writeStruct(content, {0, read.width, read.height, read.planes}, "quellReadBuffer", "content");
    if (values == nullptr) return;
    requireCapacity(values, capacity, read.values.size(), "quellReadBuffer", "values");
    std::copy(read.values.begin(), read.values.end(), values);
  });
}

quell_status quellGetBackgroundMap(quell_denoiser* denoiser, unsigned char* background, size_t capacity,
                                   quell_background_map* map) {
  return guarded("quellGetBackgroundMap", [&] {
    require(denoiser, "quellGetBackgroundMap", "denoiser");
    requireCapacity(background, capacity, 0, "quellGetBackgroundMap", "background");
    denoiser->background = denoiser->denoiser.backgroundMap();
    const quell::BackgroundMap& now = denoiser->background;
    writeStruct(map, {0, now.itemWidth, now.columns, now.rows, now.share(), now.stages.size()},
                "quellGetBackgroundMap", "map");
    if (background == nullptr) return;
    requireCapacity(background, capacity, now.background.size(), "quellGetBackgroundMap", "background");
    std::copy(now.background.begin(), now.background.end(), background);
  });
}

quell_status quellGetBackgroundStage(const quell_denoiser* denoiser, size_t index, const char** label) {
  return guarded("quellGetBackgroundStage", [&] {
    require(denoiser, "quellGetBackgroundStage", "denoiser");
    require(label, "quellGetBackgroundStage", "label");
    requireIndex(index, denoiser->background.stages.size(), "quellGetBackgroundStage", "index");
    *label = denoiser->background.stages[index].c_str();
  });
}

}  // extern "C"
