// A reader under Clang's libFuzzer.
#include "tests/fuzz/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  quell::fuzz::Reader::all().front()->read(bytes, count);
  return 0;
}
