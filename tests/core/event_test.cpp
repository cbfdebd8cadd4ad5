// quell::Event: one reference to an OpenCL event.
#include <catch2/catch.hpp>
#include <utility>

#include "tests/support/error_matcher.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

cl_uint references(const cl::Event& event) { return event.getInfo<CL_EVENT_REFERENCE_COUNT>(); }

Event sharing(const cl::Event& event) {
  clRetainEvent(event());
  return Event(event());
}

}  // namespace

TEST_CASE("an event gives back its reference exactly once", "[core]") {
  const OpenDevice device;
  const cl::UserEvent event(device.context);
  const cl::UserEvent other(device.context);
  const cl_uint before = references(event);
  {
    Event a = sharing(event);
    CHECK(a.get() == event());
    CHECK(references(event) == before + 1);
    Event b = std::move(a);
    CHECK(a.get() == nullptr);
    CHECK(references(event) == before + 1);
    Event c = sharing(other);
    c = std::move(b);
    CHECK(c.get() == event());
    CHECK(references(other) == before);
    Event& self = c;
    c = std::move(self);
    CHECK(c.get() == event());
    CHECK(references(event) == before + 1);
    {
      const cl::Event handedOver(c.release());
      CHECK(c.get() == nullptr);
      CHECK(references(event) == before + 1);
    }
    CHECK(references(event) == before);
  }
  CHECK(references(event) == before);
}

TEST_CASE("waiting for no event returns at once", "[core]") { CHECK_NOTHROW(Event().wait()); }

TEST_CASE("waiting for a failed event throws", "[core]") {
  const OpenDevice device;
  cl::UserEvent event(device.context);
  const Event waiting = sharing(event);
  event.setStatus(CL_INVALID_OPERATION);
  REQUIRE_THROWS_MATCHES(waiting.wait(), Error, failsWith(ErrorCode::DeviceError, {"CL_EXEC_STATUS_ERROR"}));
}

}  // namespace quell::tests
