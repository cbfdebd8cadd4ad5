#include "host/cli/tune/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "host/cli/common/denoise_session.hpp"
#include "host/cli/common/progress.hpp"
#include "host/metrics/report.hpp"

namespace quell::cli {
namespace {

// Gathers what SequenceFigures says of errors.
class ErrorMeans {
 public:
  void add(const metrics::ErrorFigures& figures) {
    const double rmse = figures.unbiasedRmse.value_or(figures.rmse);
    m_mse += std::copysign(rmse * rmse, rmse);
    m_ssim += figures.ssim;
    m_flip += figures.flip;
    ++m_count;
  }

  void store(SequenceFigures& figures) const {
    const double mse = m_mse / m_count;
    figures.rmse = std::copysign(std::sqrt(std::abs(mse)), mse);
    figures.ssim = m_ssim / m_count;
    figures.flip = m_flip / m_count;
  }

 private:
  double m_mse = 0.0, m_ssim = 0.0, m_flip = 0.0;
  int m_count = 0;
};

// A setting at work on a sequence.
struct ActiveSetting {
  EvaluatedSetting* setting;
  bool measuresErrors;  // false for the first setting in all groups but one
  std::unique_ptr<DenoiseSession> session;
  ErrorMeans errors = {};
};

// All settings on one sequence, group by group.
class SequenceEvaluator {
 public:
  SequenceEvaluator(const std::string& label, const BenchInput& input, const EvaluationArguments& arguments,
                    Evaluation& result)
      : m_label(label), m_input(input), m_arguments(arguments), m_result(result) {
    const io::FrameSequence& sequence = *input.sequence;
    result.sequences.push_back(
        {sequence.name(), {sequence.width(), sequence.height()}, input.frames.size(), {}, true});
    for (const int number : input.frames) {
      const auto reference = sequence.reference(number);
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
    const DenoiseSession& session = *active.front().session;
    if (first == 1) {
      m_result.device = session.device();
      m_result.copies.push_back(measureCopyBandwidth(session.context(), session.deviceId(), session.queue()));
    }
    Progress progress(fmt::format("{} {}", m_label, name), static_cast<std::size_t>(m_arguments.rounds) + 1);
    runRound(active, 0, [&](ActiveSetting& one, const io::FrameData& frame, const auto& reference) {
      measureErrors(one, frame, reference);
    });
    progress.step("errors");
    for (ActiveSetting& one : active) one.session->denoiser().clearTimings();
    for (int round = 1; round <= m_arguments.rounds; ++round) {
      runRound(active, static_cast<std::size_t>(round),
               [](ActiveSetting& one, const io::FrameData& frame, const auto&) { one.session->run(frame); });
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
      if (error.code() != ErrorCode::InvalidArgument && error.code() != ErrorCode::OutOfRange) throw;
      m_result.refused.push_back({setting.plan, m_input.sequence->name(), error.what()});
    }
  }

  // Calls work(setting, frame, reference) for every frame and setting; who comes first changes from frame to frame. A
  // round starts without history. References are there in round 0 only.
  template <class Work>
  void runRound(std::vector<ActiveSetting>& active, std::size_t round, const Work& work) const {
    for (ActiveSetting& one : active) one.session->denoiser().resetHistory();
    for (std::size_t i = 0; i < m_input.frames.size(); ++i) {
      const int number = m_input.frames[i];
      const io::FrameData frame = m_input.sequence->read(number);
      const std::optional<io::Reference> reference =
          round == 0 ? m_input.sequence->reference(number) : std::nullopt;
      for (std::size_t turn = 0; turn < active.size(); ++turn)
        work(active[(round + i + turn) % active.size()], frame, reference);
    }
  }

  static void measureErrors(ActiveSetting& one, const io::FrameData& frame,
                            const std::optional<io::Reference>& reference) {
    if (!reference || !one.measuresErrors) return one.session->run(frame);
    one.errors.add(
        metrics::compareToReference(one.session->denoise(frame).linear, false, reference->a, reference->b));
  }

  static void store(std::vector<ActiveSetting>& active) {
    const auto frameMs = [](ActiveSetting& one) { return one.session->denoiser().timings().frame.medianMs; };
    const double firstMs = frameMs(active.front());
    for (ActiveSetting& one : active) {
      if (!one.measuresErrors) continue;
      SequenceFigures figures;
      figures.frameMs = frameMs(one);
      figures.relativeTime = figures.frameMs / firstMs;
      one.errors.store(figures);
      one.setting->sequences.push_back(figures);
    }
  }

  const std::string& m_label;
  const BenchInput& m_input;
  const EvaluationArguments& m_arguments;
  Evaluation& m_result;
};

}  // namespace

Evaluation evaluateSettings(const std::string& label, const std::vector<PlannedRun>& plans,
                            const std::vector<BenchInput>& inputs, const EvaluationArguments& arguments) {
  Evaluation result;
  for (const PlannedRun& plan : plans) result.settings.push_back({plan, {}});
  for (const BenchInput& input : inputs) SequenceEvaluator(label, input, arguments, result).evaluate();
  return result;
}

}  // namespace quell::cli
