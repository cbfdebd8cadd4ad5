// Planes, what a method's table resolves to, and the device memory behind it.
#include "host/core/schedule.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "host/core/buffer_set.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/fake_stage.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr Size kSize{33, 17};

Configuration configuration() {
  Configuration c;
  c.frame.size = kSize;
  return c;
}

template <class... Rows>
Schedule table(Rows... rows) {
  Schedule schedule;
  (schedule.push_back(std::move(rows)), ...);
  return schedule;
}

// a -> b -> c -> d, each stage reading what the one before wrote, with a history h.
Schedule chain(Extent extentOfC = 1, bool readsALate = false) {
  std::vector<Port> last = {fakePort("c", Access::Read, extentOfC), fakePort("d", Access::Write)};
  if (readsALate) last.push_back(fakePort("a", Access::Read));
  return table(fakeRow("first", {fakePort("hPrev", Access::Previous), fakePort("a", Access::Write),
                                 fakePort("h", Access::Write)}),
               fakeRow("second", {fakePort("a", Access::Read), fakePort("b", Access::Write)}),
               fakeRow("third", {fakePort("b", Access::Read), fakePort("c", Access::Write, extentOfC)}),
               fakeRow("fourth", last));
}

// What is in memory for a table.
struct Allocated {
  explicit Allocated(const Schedule& schedule, const std::vector<std::string>& kept = {})
      : plan(makePlan(schedule, configuration())), buffers(device.context, device.queue, plan, kSize, kept) {}

  cl::Buffer current(const char* name, int parity = 0) const {
    return buffers.current(plan.find(name), parity);
  }
  cl::Buffer previous(const char* name, int parity = 0) const {
    return buffers.previous(plan.find(name), parity);
  }

  OpenDevice device;
  Plan plan;
  BufferSet buffers;
};

// makePlan() refuses the table, in a sentence that has all of these.
void checkRefused(const Schedule& schedule, const std::vector<std::string>& words) {
  try {
    makePlan(schedule, configuration());
    FAIL("the table was taken");
  } catch (const std::logic_error& error) {
    INFO(error.what());
    for (const std::string& word : words) CHECK(std::string(error.what()).find(word) != std::string::npos);
  }
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

TEST_CASE("buffers count their margins in memory and leave them out of the bytes touched", "[core]") {
  const Port bytes = fakePort("bytes", Access::Read, 2, Element::UInt8);
  CHECK(elementCount({"bytes", bytes.element, bytes.extent}, kSize) ==
        2 * static_cast<std::size_t>(makePlanes(kSize).stride));
  CHECK(touchedBytes(bytes, configuration()) == 2.0 * 33 * 17);
  Port records = fakePort("records", Access::Update, Extent::records(77));
  CHECK(elementCount({"records", records.element, records.extent}, kSize) == 77);
  CHECK(touchedBytes(records, configuration()) == 2.0 * 4 * 77);  // read and written
  records.touched = 0.5;
  CHECK(touchedBytes(records, configuration()) == 4.0 * 77);
  records.exists = false;
  CHECK(touchedBytes(records, configuration()) == 0.0);
}

TEST_CASE("buffers follow from the ports of a table", "[core]") {
  const Plan plan = makePlan(chain(Extent(5)), configuration());
  REQUIRE(plan.buffers.size() == 5);
  CHECK(plan.find("a") >= 0);
  CHECK(plan.find("hPrev") == -1);
  for (const BufferSpec& spec : plan.buffers) {
    INFO(spec.name);
    CHECK(spec.history == (spec.name == "h"));
    CHECK(spec.extent.planes == (spec.name == "c" ? 5 : 1));
  }
  CHECK(plan.buffers[static_cast<std::size_t>(plan.find("a"))].firstRow == 0);
  CHECK(plan.buffers[static_cast<std::size_t>(plan.find("a"))].lastRow == 1);
}

TEST_CASE("wires join ports to buffers of other names", "[core]") {
  const Plan plan =
      makePlan(table(fakeRow("writer", {fakePort("out", Access::Write)}, {{"out", "light"}}),
                     fakeRow("reader", {fakePort("in", Access::Read), fakePort("kept", Access::Previous)},
                             {{"in", "light"}, {"kept", "light"}})),
               configuration());
  REQUIRE(plan.buffers.size() == 1);
  CHECK(plan.buffers[0].name == "light");
  CHECK(plan.buffers[0].history);
}

TEST_CASE("absent ports take no buffer", "[core]") {
  Port absent = fakePort("absent", Access::Read);
  absent.exists = false;
  const Plan plan = makePlan(table(fakeRow("only", {absent, fakePort("a", Access::Write)})), configuration());
  CHECK(plan.buffers.size() == 1);
  CHECK_FALSE(plan.rows[0][0].hasBuffer());
}

TEST_CASE("a wire of a port that the stage does not have is refused", "[core]") {
  checkRefused(table(fakeRow("writer", {fakePort("out", Access::Write)}, {{"outt", "light"}})),
               {"stage writer", "port outt", "one of out"});
}

TEST_CASE("a buffer that nothing has written before is refused where it is read", "[core]") {
  checkRefused(table(fakeRow("reader", {fakePort("light", Access::Read)})),
               {"stage reader", "port light", "an earlier stage that writes the buffer light"});
  checkRefused(table(fakeRow("reader", {fakePort("light", Access::Read)}),
                     fakeRow("writer", {fakePort("light", Access::Write)})),
               {"stage reader", "port light"});
  checkRefused(table(fakeRow("updater", {fakePort("light", Access::Update)})),
               {"stage updater", "port light"});
}

TEST_CASE("a stage may have a buffer to itself", "[core]") {
  CHECK(makePlan(table(fakeRow("solver", {fakePort("matrix", Access::Scratch)})), configuration())
            .buffers.size() == 1);
}

TEST_CASE("a history that no stage writes is refused", "[core]") {
  checkRefused(table(fakeRow("reader", {fakePort("lightPrev", Access::Previous)})),
               {"light", "a stage that writes the buffer"});
}

TEST_CASE("ports of one buffer that differ in element or planes are refused", "[core]") {
  const auto pair = [](const Port& reader) {
    return table(fakeRow("writer", {fakePort("light", Access::Write, 3)}), fakeRow("reader", {reader}));
  };
  checkRefused(pair(fakePort("light", Access::Read, 2)),
               {"stage reader", "port light", "3 planes of float", "stage writer", "2 planes of float"});
  checkRefused(pair(fakePort("light", Access::Read, 3, Element::UInt8)),
               {"stage reader", "3 planes of uchar"});
  checkRefused(pair(fakePort("light", Access::Read, Extent::records(3))),
               {"stage reader", "3 elements of float"});
}

TEST_CASE("a stage that would write what it reads through another port is refused", "[core]") {
  checkRefused(table(fakeRow("writer", {fakePort("light", Access::Write)}),
                     fakeRow("filter", {fakePort("in", Access::Read), fakePort("out", Access::Write)},
                             {{"in", "light"}, {"out", "light"}})),
               {"stage filter", "port out", "a buffer of its own", "port in"});
}

TEST_CASE("a table that the runtime does not have is refused", "[core]") {
  checkRefused(table(fakeRow("reader", {fakePort("sines", Access::Table)})),
               {"stage reader", "port sines", "a table that the runtime provides"});
}

TEST_CASE("transient buffers share memory only where their lifetimes are disjoint", "[core]") {
  const Allocated memory(chain());
  CHECK(memory.current("a")() == memory.current("c")());
  CHECK(memory.current("b")() == memory.current("d")());
  CHECK(memory.current("a")() != memory.current("b")());
  CHECK(memory.current("c")() != memory.current("d")());
  for (const char* name : {"a", "b", "c", "d"}) CHECK(memory.current(name, 0)() == memory.current(name, 1)());
}

TEST_CASE("a buffer that is read late, or kept, keeps its memory until then", "[core]") {
  const Allocated late(chain(1, true)), kept(chain(), {"a"});
  for (const char* name : {"b", "c", "d"}) {
    CHECK(late.current("a")() != late.current(name)());
    CHECK(kept.current("a")() != kept.current(name)());
  }
}

TEST_CASE("a buffer never moves into memory that is too small for it", "[core]") {
  const Allocated memory(chain(Extent(5)));
  for (const BufferSpec& spec : memory.plan.buffers) {
    INFO(spec.name);
    CHECK(memory.current(spec.name.c_str()).getInfo<CL_MEM_SIZE>() >=
          elementCount(spec, kSize) * elementBytes(spec.element));
  }
}

TEST_CASE("history is double-buffered, changes sides every frame and shares with nothing", "[core]") {
  const Allocated memory(chain());
  CHECK(memory.current("h", 0)() != memory.current("h", 1)());
  CHECK(memory.previous("h", 1)() == memory.current("h", 0)());
  CHECK(memory.previous("h", 0)() == memory.current("h", 1)());
  for (const char* name : {"a", "b", "c", "d"})
    for (const int parity : {0, 1}) CHECK(memory.current("h", parity)() != memory.current(name)());
}

TEST_CASE("buffers start as zeros", "[core]") {
  const Allocated memory(chain());
  for (const char* name : {"a", "b", "h"}) {
    for (const int parity : {0, 1}) {
      const cl::Buffer buffer = memory.current(name, parity);
      std::vector<unsigned char> bytes(buffer.getInfo<CL_MEM_SIZE>(), 1);
      memory.device.queue.enqueueReadBuffer(buffer, CL_TRUE, 0, bytes.size(), bytes.data());
      CHECK(bytes == std::vector<unsigned char>(bytes.size(), 0));
    }
  }
}

TEST_CASE("the memory reported is the memory held", "[core]") {
  const Allocated memory(chain());
  const MemoryUse use = memory.buffers.memoryUse();
  const std::size_t plane = static_cast<std::size_t>(makePlanes(kSize).stride) * 4;
  CHECK(use.totalBytes == (2 + 2) * plane);  // a + c, b + d, and h twice
  std::size_t sum = 0;
  std::vector<std::string> names;
  for (const MemoryUse::Buffer& buffer : use.buffers) {
    sum += buffer.bytes;
    names.push_back(buffer.name);
  }
  CHECK(sum == use.totalBytes);
  CHECK(names == std::vector<std::string>{"h", "a + c", "b + d"});
  CHECK(BufferSet().memoryUse().totalBytes == 0);
}

TEST_CASE("memory that the device cannot give is refused by the buffer's name", "[core]") {
  Schedule schedule = chain();
  schedule.push_back(
      fakeRow("greedy", {fakePort("giant", Access::Write, Extent::records(std::size_t{1} << 50))}));
  REQUIRE_THROWS_MATCHES(Allocated(schedule), Error,
                         failsWith(ErrorCode::OutOfMemory, {"giant", std::to_string(std::size_t{4} << 50)}));
}

}  // namespace quell::tests
