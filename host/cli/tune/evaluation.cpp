#include "host/cli/tune/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "host/cli/common/denoise_report.hpp"
#include "host/cli/common/fair_rounds.hpp"
#include "host/cli/common/progress.hpp"
#include "host/metrics/error.hpp"
#include "host/metrics/report.hpp"

namespace quell::cli {
namespace {

// Means of the tuned metrics over the reference frames.
class ErrorMeans {
 public:
  void add(const metrics::ErrorFigures& figures) {
    for (std::size_t i = 0; i < m_sums.size(); ++i) {
      const metrics::Metric& metric = *tunedMetrics()[i];
      const std::optional<double>& own = figures.at(metric.key);
      const double value = own ? *own : *figures.at(plainOf(metric).key);
      m_sums[i] += metric.meanOfSquares ? value * std::abs(value) : value;
    }
    ++m_count;
  }

  std::vector<double> means() const {
    std::vector<double> means;
    for (std::size_t i = 0; i < m_sums.size(); ++i) {
      const double mean = m_sums[i] / m_count;
      means.push_back(tunedMetrics()[i]->meanOfSquares ? metrics::signedRoot(mean) : mean);
    }
    return means;
  }

 private:
  std::vector<double> m_sums = std::vector<double>(tunedMetrics().size());
  int m_count = 0;
};

// A setting at work on a sequence.
struct ActiveSetting {
  EvaluatedSetting* setting;
  bool measuresErrors;  // false for the first setting in all groups but one
  std::unique_ptr<DenoiseSession> session;
  ErrorMeans errors = {};
  metrics::MotionCompensatedErrorMeter flicker = {};
};

// All settings on one sequence, group by group.
class SequenceEvaluator {
 public:
  SequenceEvaluator(const std::string& label, const BenchInput& input, const EvaluationArguments& arguments,
                    Evaluation& result)
      : m_label(label),
        m_input(input),
        m_references(*input.sequence),
        m_arguments(arguments),
        m_result(result) {
    const io::FrameSequence& sequence = *input.sequence;
    result.sequences.push_back({sequence.name(),
                                {sequence.width(), sequence.height()},
                                input.frames.size(),
                                {},
                                true,
                                m_references.kind()});
    for (const int number : input.frames) {
      const auto& reference = m_references.of(number);
      if (!reference) continue;
      result.sequences.back().references.push_back(number);
      if (reference->b.empty()) result.sequences.back().unbiased = false;
    }
  }

  // Moves what the library refuses to Evaluation::refused.
  void evaluate() {
    std::vector<EvaluatedSetting>& settings = m_result.settings;
    const std::size_t others = static_cast<std::size_t>(m_arguments.atOnce) - 1;
    const std::size_t groups = std::max<std::size_t>(1, (settings.size() - 1 + others - 1) / others);
    for (std::size_t group = 0; group < groups; ++group) {
      const std::size_t first = 1 + group * others;
      const std::size_t last = std::min(first + others, settings.size());
      evaluateGroup(first, last,
                    fmt::format("{}, group {} of {}", m_input.sequence->name(), group + 1, groups));
    }
    const std::size_t done = m_result.sequences.size();
    settings.erase(std::remove_if(settings.begin(), settings.end(),
                                  [&](const EvaluatedSetting& one) { return one.sequences.size() < done; }),
                   settings.end());
  }

 private:
  void evaluateGroup(std::size_t first, std::size_t last, const std::string& name) {
    std::vector<ActiveSetting> active;
    open(m_result.settings.front(), first == 1, active);
    for (std::size_t i = first; i < last; ++i) tryToOpen(m_result.settings[i], active);
    if (first == 1) {
      const DenoiseSession& session = *active.front().session;
      m_result.device = session.device();
      m_result.copies.push_back(measureCopy(session));
    }
    Progress progress(fmt::format("{} {}", m_label, name), static_cast<std::size_t>(m_arguments.rounds) + 1);
    fairRound(active, m_input, 0,
              [&](ActiveSetting& one, const io::FrameData& frame) { measureErrors(one, frame); });
    progress.step("errors");
    for (ActiveSetting& one : active) one.session->denoiser().clearTimings();
    for (int round = 1; round <= m_arguments.rounds; ++round) {
      fairRound(active, m_input, static_cast<std::size_t>(round),
                [](ActiveSetting& one, const io::FrameData& frame) { one.session->run(frame); });
      progress.step(fmt::format("round {}", round));
    }
    store(active);
  }

  void open(EvaluatedSetting& setting, bool measuresErrors, std::vector<ActiveSetting>& active) const {
    const io::FrameSequence& sequence = *m_input.sequence;
    auto session = std::make_unique<DenoiseSession>(
        m_arguments.device.device, setting.plan.settings(sequence),
        makeOptions(m_arguments.device, TimerMode::Device), sequence.read(m_input.frames.front()));
    active.push_back({&setting, measuresErrors, std::move(session)});
  }

  void tryToOpen(EvaluatedSetting& setting, std::vector<ActiveSetting>& active) const {
    try {
      open(setting, true, active);
    } catch (const Error& error) {
      if (!isRefusal(error)) throw;
      m_result.refused.push_back({setting.plan, m_input.sequence->name(), error.what()});
    }
  }

  void measureErrors(ActiveSetting& one, const io::FrameData& frame) {
    if (!one.measuresErrors) return one.session->run(frame);
    const DenoisedFrame denoised = one.session->denoise(frame);
    one.flicker.add(trackFrame(frame, denoised));
    if (const auto& reference = m_references.of(frame.number))
      one.errors.add(metrics::compareToReference(denoised.linear, false, reference->a, reference->b));
  }

  static void store(std::vector<ActiveSetting>& active) {
    const auto frameMs = [](ActiveSetting& one) { return one.session->denoiser().timings().frame.medianMs; };
    const double firstMs = frameMs(active.front());
    for (ActiveSetting& one : active) {
      if (!one.measuresErrors) continue;
      const double ms = frameMs(one);
      one.setting->sequences.push_back({ms, ms / firstMs, one.errors.means(), one.flicker.mean()});
    }
  }

  const std::string& m_label;
  const BenchInput& m_input;
  io::References m_references;
  const EvaluationArguments& m_arguments;
  Evaluation& m_result;
};

}  // namespace

const std::vector<const metrics::Metric*>& tunedMetrics() {
  static const std::vector<const metrics::Metric*> all = [] {
    std::vector<const metrics::Metric*> tuned;
    for (const metrics::Metric& metric : metrics::imageMetrics())
      if (metric.tuning != metrics::Tuning::None) tuned.push_back(&metric);
    return tuned;
  }();
  return all;
}

const std::vector<std::size_t>& minimisedMetrics() {
  static const std::vector<std::size_t> all = [] {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < tunedMetrics().size(); ++i)
      if (tunedMetrics()[i]->tuning == metrics::Tuning::Minimised) places.push_back(i);
    return places;
  }();
  return all;
}

const metrics::Metric& plainOf(const metrics::Metric& metric) {
  if (metric.standIn == nullptr) return metric;
  return metrics::imageMetrics()[metrics::indexOfMetric(metric.standIn)];
}

Evaluation evaluateSettings(const std::string& label, const std::vector<PlannedRun>& plans,
                            const std::vector<BenchInput>& inputs, const EvaluationArguments& arguments) {
  Evaluation result;
  for (const PlannedRun& plan : plans) result.settings.push_back({plan, {}});
  for (const BenchInput& input : inputs) SequenceEvaluator(label, input, arguments, result).evaluate();
  return result;
}

}  // namespace quell::cli
