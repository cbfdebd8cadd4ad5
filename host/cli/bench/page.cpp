#include "host/cli/bench/page.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "host/cli/bench/gpu_model.hpp"
#include "host/cli/bench/page_template.hpp"
#include "host/cli/bench/report.hpp"
#include "host/cli/common/figures.hpp"
#include "host/io/base64.hpp"
#include "host/io/png_image.hpp"

namespace quell::cli {
namespace {

using nlohmann::json;

constexpr char kPlaceholder[] = "@RESULTS@";

json picturesJson(const std::vector<BenchPicture>& pictures) {
  json list = json::array();
  for (const BenchPicture& picture : pictures)
    list.push_back({{"input", picture.input},
                    {"frame", picture.frame},
                    {"name", picture.name},
                    {"png", "data:image/png;base64," + io::base64(io::encodePng(picture.image))}});
  return list;
}

// What the page calls them and which way is better; `best` is null where it is infinite.
json metricsJson() {
  const auto describe = [](const metrics::Metric& metric, const char* of) {
    return json{
        {"key", metric.key}, {"label", metric.label}, {"best", number<json>(metric.best)}, {"of", of}};
  };
  json list = json::array();
  for (const metrics::Metric& metric : metrics::imageMetrics()) list.push_back(describe(metric, "frame"));
  list.push_back(describe(metrics::kTemporalError, "run"));
  return list;
}

// Inside a script element, "</script" would end it.
std::string scriptSafe(std::string text) {
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.replace(at, 2, "<\\/");
  return text;
}

}  // namespace

std::string toHtml(const BenchResult& result) {
  json all = toJson(result);
  all["pictures"] = picturesJson(result.pictures);
  all["metrics"] = metricsJson();
  all["headline"] = metrics::headlineMetric().key;
  all["model"] = predictGpus(result);
  std::string page = kReportPage;
  const std::size_t at = page.find(kPlaceholder);
  return page.replace(at, sizeof(kPlaceholder) - 1, scriptSafe(all.dump()));
}

}  // namespace quell::cli
