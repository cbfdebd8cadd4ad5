// Results of quell bench, which --compare reads.
#include <nlohmann/json.hpp>

#include "host/cli/bench/compare.hpp"
#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void read(const std::uint8_t* bytes, std::size_t count) {
  const std::string path = asFile(bytes, count, "report.json");
  attempt([&] {
    const nlohmann::json report = cli::readBench(path);
    cli::compareBench(report, report, path);
  });
}

const Reader kReader("report", read);

}  // namespace
}  // namespace quell::fuzz
