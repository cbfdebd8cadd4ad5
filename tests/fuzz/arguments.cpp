// What is written on a command line: settings as NAME=VALUE, sources of --channels.
#include <quell/settings.hpp>

#include "host/io/channel_names.hpp"
#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void read(const std::uint8_t* bytes, std::size_t count) {
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  for (const char* image : {"color", "depth", "motion"}) attempt([&] { io::parseSources(image, text); });
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return;
  for (const std::string& method : methodNames())
    attempt([&] { Settings(method).set(text.substr(0, equals), text.substr(equals + 1)); });
}

const Reader kReader("arguments", read);

}  // namespace
}  // namespace quell::fuzz
