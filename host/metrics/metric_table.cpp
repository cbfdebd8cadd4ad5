#include "host/metrics/metric_table.hpp"

#include <algorithm>
#include <limits>
#include <quell/error.hpp>
#include <string>

#include "host/metrics/error.hpp"
#include "host/metrics/flip.hpp"
#include "host/metrics/ssim.hpp"

namespace quell::metrics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double ssimWhereLargeEnough(const Comparison& c) {
  return isLargeEnoughForSsim(c.shown) ? ssim(c.shown, c.reference)
                                       : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

const std::vector<Metric>& imageMetrics() {
  using C = const Comparison&;
  // PSNR says what RMSE says, and relMSE hangs on a few dark pixels: neither is compared between runs.
  // clang-format off
  static const std::vector<Metric> all = {
    // key, label, column, unit, best, digits, fine digits and width, compared, tuning, squares, stand-in, needs, measure
    {"rmse", "RMSE", "RMSE", "", 0.0, 4, 6, 9, true, Tuning::None, true, nullptr, Needs::Nothing,
     [](C c) { return rmse(c.shown, c.reference); }},
    {"unbiased_rmse", "unbiased RMSE", "unbiased", "", 0.0, 4, 6, 9, true, Tuning::Minimised, true, "rmse",
     Needs::BothHalves, [](C c) { return unbiasedRmse(c.shown, c.halfA, c.halfB); }},
    {"psnr", "PSNR", "PSNR", "dB", kInfinity, 2, 2, 5, false, Tuning::None, false, nullptr, Needs::Nothing,
     [](C c) { return psnr(c.shown, c.reference); }},
    {"ssim", "SSIM", "SSIM", "", 1.0, 3, 4, 7, true, Tuning::Shown, false, nullptr, Needs::Nothing,
     ssimWhereLargeEnough},
    {"flip", "FLIP", "FLIP", "", 0.0, 4, 4, 7, true, Tuning::Minimised, false, nullptr, Needs::Nothing,
     [](C c) { return flip(c.shown, c.reference); }},
    {"relmse", "relMSE", "relMSE", "", 0.0, 4, 5, 9, false, Tuning::None, false, nullptr, Needs::LinearImage,
     [](C c) { return relMse(c.linear, c.referenceLinear); }},
  };
  // clang-format on
  return all;
}

const Metric& headlineMetric() { return imageMetrics()[indexOfMetric("unbiased_rmse")]; }

const Metric kTemporalError = {
    "temporal_error", "temporal error", "temporal", "", 0.0, 5, 6, 9, true, Tuning::None, false,
    nullptr,          Needs::Nothing,   nullptr};

std::size_t indexOfMetric(std::string_view key) {
  const std::vector<Metric>& all = imageMetrics();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Metric& metric) { return metric.key == key; });
  if (found == all.end())
    throw Error(ErrorCode::InvalidArgument, {"metrics", "key", "a metric's", std::string(key)});
  return std::size_t(found - all.begin());
}

}  // namespace quell::metrics
