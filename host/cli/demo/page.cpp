#include "host/cli/demo/page.hpp"

#include <nlohmann/json.hpp>

#include "host/io/atomic_file.hpp"
#include "host/io/base64.hpp"

namespace quell::cli {
namespace {

constexpr char kMarker[] = "DEMO_DATA";
/// How long a frame of the sequence shows; where frames are left out, the others show longer.
constexpr double kMillisecondsPerFrame = 1000.0 / 12.0;

std::vector<DemoSheet> everyKth(const std::vector<DemoSheet>& sheets, std::size_t k) {
  std::vector<DemoSheet> chosen;
  for (std::size_t i = (sheets.size() - 1) % k; i < sheets.size(); i += k) chosen.push_back(sheets[i]);
  return chosen;
}

std::size_t totalBytes(const std::vector<DemoSheet>& sheets) {
  std::size_t sum = 0;
  for (const DemoSheet& sheet : sheets) sum += sheet.bytes;
  return sum;
}

}  // namespace

std::vector<DemoSheet> sheetsWithin(const std::vector<DemoSheet>& sheets, std::size_t mostBytes) {
  for (std::size_t k = 1; k < sheets.size(); ++k) {
    std::vector<DemoSheet> chosen = everyKth(sheets, k);
    if (totalBytes(chosen) <= mostBytes) return chosen;
  }
  return sheets.empty() ? sheets : std::vector<DemoSheet>{sheets.back()};
}

std::string makeDemoPage(const DemoPage& page) {
  const std::vector<DemoSheet> sheets = sheetsWithin(page.sheets, kMostPageBytes);
  const double kept = static_cast<double>(sheets.size()) / static_cast<double>(page.sheets.size());
  nlohmann::json data = {{"title", page.title},
                         {"subtitle", page.subtitle},
                         {"report", page.report},
                         {"width", page.size.width},
                         {"height", page.size.height},
                         {"panes", page.panes},
                         {"millisecondsPerFrame", kMillisecondsPerFrame / kept},
                         {"frames", nlohmann::json::array()}};
  for (const DemoSheet& sheet : sheets)
    data["frames"].push_back({{"number", sheet.number},
                              {"panes", sheet.panes},
                              {"sheet", "data:image/png;base64," + io::base64(io::readFile(sheet.path))}});
  std::string text = kDemoPageTemplate;
  // A "</script>" within a text would end the script.
  std::string json = data.dump();
  for (std::size_t at = json.find("</"); at != std::string::npos; at = json.find("</", at + 3))
    json.replace(at, 2, "<\\/");
  return text.replace(text.find(kMarker), sizeof(kMarker) - 1, json);
}

}  // namespace quell::cli
