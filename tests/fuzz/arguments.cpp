// What is written on a command line: settings as NAME=VALUE, sources of --channels.
#include <quell/settings.hpp>

#include "host/io/channel_names.hpp"
#include "tests/fuzz/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace quell;
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  fuzz::attempt([&] { io::parseSources(text); });
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return 0;
  for (const char* method : {"quell", "bmfr", "svgf", "atrous"})
    fuzz::attempt([&] { Settings(method).set(text.substr(0, equals), text.substr(equals + 1)); });
  return 0;
}
