// Planes, and the device memory behind a method's table.
#include "host/core/schedule.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "host/core/stage.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr Size kSize{33, 17};

BufferSpec transient(const std::string& name, int planes = 1) {
  return {name, Element::Float32, planes, 0, false};
}

BufferSpec history(const std::string& name, Element element = Element::Float32) {
  return {name, element, 1, 0, true};
}

void addRow(Schedule& schedule, std::vector<std::string> reads, std::vector<std::string> writes) {
  schedule.stages.push_back({nullptr, std::move(reads), std::move(writes)});
}

// a -> b -> c -> d, each stage reading what the one before wrote, with a history h.
Schedule chain() {
  Schedule schedule;
  schedule.buffers = {transient("a"), transient("b"), transient("c"), transient("d"), history("h")};
  addRow(schedule, {"h.prev"}, {"a", "h"});
  addRow(schedule, {"a"}, {"b"});
  addRow(schedule, {"b"}, {"c"});
  addRow(schedule, {"c"}, {"d"});
  return schedule;
}

BufferSet allocate(const Schedule& schedule) {
  const OpenDevice device;
  return BufferSet(device.context, device.queue, schedule, kSize);
}

}  // namespace

TEST_CASE("planes leave a margin around every image", "[core]") {
  for (const Size size : {Size{1, 1}, Size{15, 3}, Size{16, 4}, Size{17, 5}, Size{1920, 1080}}) {
    const PlaneParams planes = makePlanes(size);
    INFO(size.width << "x" << size.height);
    CHECK(planes.width == size.width);
    CHECK(planes.height == size.height);
    // Sixteen elements from column -16, and from column width, stay within the row's margins.
    CHECK(planes.pitch >= QUELL_PLANE_MARGIN + size.width + QUELL_PLANE_MARGIN);
    CHECK(planes.pitch % QUELL_PLANE_MARGIN == 0);
    CHECK(planes.stride == planes.pitch * (size.height + 2 * QUELL_PLANE_MARGIN_ROWS));
  }
}

TEST_CASE("buffers count their margins in memory and leave them out of the payload", "[core]") {
  const BufferSpec bytes{"bytes", Element::UInt8, 2, 0, false};
  CHECK(elementCount(bytes, kSize) == 2 * static_cast<std::size_t>(makePlanes(kSize).stride));
  CHECK(payloadBytes(bytes, kSize) == 2u * 33 * 17);
  const BufferSpec elements{"elements", Element::Float32, 0, 77, false};
  CHECK(elementCount(elements, kSize) == 77);
  CHECK(payloadBytes(elements, kSize) == 4 * 77);
}

TEST_CASE("transient buffers share memory only where their lifetimes are disjoint", "[core]") {
  const BufferSet buffers = allocate(chain());
  CHECK(buffers.get("a", 0)() == buffers.get("c", 0)());
  CHECK(buffers.get("b", 0)() == buffers.get("d", 0)());
  CHECK(buffers.get("a", 0)() != buffers.get("b", 0)());
  CHECK(buffers.get("c", 0)() != buffers.get("d", 0)());
  for (const char* name : {"a", "b", "c", "d"}) CHECK(buffers.get(name, 0)() == buffers.get(name, 1)());
}

TEST_CASE("a buffer that is read late keeps its memory until then", "[core]") {
  Schedule schedule = chain();
  schedule.stages.back().reads.emplace_back("a");
  const BufferSet buffers = allocate(schedule);
  for (const char* name : {"b", "c", "d"}) CHECK(buffers.get("a", 0)() != buffers.get(name, 0)());
}

TEST_CASE("a buffer never moves into memory that is too small for it", "[core]") {
  Schedule schedule = chain();
  schedule.buffers[2] = transient("c", 5);
  const BufferSet buffers = allocate(schedule);
  for (const BufferSpec& spec : schedule.buffers) {
    INFO(spec.name);
    CHECK(buffers.get(spec.name, 0).getInfo<CL_MEM_SIZE>() >=
          elementCount(spec, kSize) * elementBytes(spec.element));
  }
}

TEST_CASE("history is double-buffered, changes sides every frame and shares with nothing", "[core]") {
  const BufferSet buffers = allocate(chain());
  CHECK(buffers.get("h", 0)() != buffers.get("h", 1)());
  CHECK(buffers.get("h.prev", 1)() == buffers.get("h", 0)());
  CHECK(buffers.get("h.prev", 0)() == buffers.get("h", 1)());
  for (const char* name : {"a", "b", "c", "d"})
    for (const int parity : {0, 1}) CHECK(buffers.get("h", parity)() != buffers.get(name, 0)());
}

TEST_CASE("buffers start as zeros", "[core]") {
  const OpenDevice device;
  const BufferSet buffers(device.context, device.queue, chain(), kSize);
  for (const char* name : {"a", "b", "h", "h.prev"}) {
    std::vector<unsigned char> bytes(buffers.get(name, 0).getInfo<CL_MEM_SIZE>(), 1);
    device.queue.enqueueReadBuffer(buffers.get(name, 0), CL_TRUE, 0, bytes.size(), bytes.data());
    CHECK(bytes == std::vector<unsigned char>(bytes.size(), 0));
  }
}

TEST_CASE("the memory reported is the memory held", "[core]") {
  const BufferSet buffers = allocate(chain());
  const MemoryUse use = buffers.memoryUse();
  const std::size_t plane = static_cast<std::size_t>(makePlanes(kSize).stride) * 4;
  CHECK(use.totalBytes == (2 + 2) * plane);  // a + c, b + d, and h twice
  std::size_t sum = 0;
  std::vector<std::string> names;
  for (const MemoryUse::Buffer& buffer : use.buffers) {
    sum += buffer.bytes;
    names.push_back(buffer.name);
  }
  CHECK(sum == use.totalBytes);
  CHECK(names == std::vector<std::string>{"a + c", "h", "b + d"});
  CHECK(BufferSet().memoryUse().totalBytes == 0);
}

TEST_CASE("a name that the table does not declare is a mistake of the method", "[core]") {
  const BufferSet buffers = allocate(chain());
  CHECK_THROWS_AS(buffers.get("e", 0), std::logic_error);
  CHECK_THROWS_AS(buffers.get("e.prev", 0), std::logic_error);
  CHECK_THROWS_AS(buffers.get("a.prev", 0), std::logic_error);
}

TEST_CASE("a buffer that no stage of the configuration touches takes no memory", "[core]") {
  Schedule schedule = chain();
  schedule.buffers.push_back(transient("unused", 100));
  const BufferSet buffers = allocate(schedule);
  CHECK(buffers.memoryUse().totalBytes == allocate(chain()).memoryUse().totalBytes);
  CHECK_THROWS_AS(buffers.get("unused", 0), std::logic_error);
}

TEST_CASE("memory that the device cannot give is refused by the buffer's name", "[core]") {
  Schedule schedule = chain();
  schedule.buffers.push_back({"giant", Element::Float32, 0, std::size_t{1} << 50, false});
  addRow(schedule, {"d"}, {"giant"});
  REQUIRE_THROWS_MATCHES(allocate(schedule), Error,
                         failsWith(ErrorCode::OutOfMemory, {"giant", std::to_string(std::size_t{4} << 50)}));
}

}  // namespace quell::tests
