#include "host/cli/select_features/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "host/cli/common/denoise_session.hpp"
#include "host/cli/common/progress.hpp"
#include "host/cli/common/watched_sequence.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/metrics/error.hpp"
#include "host/stages/fit_features.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "select-features";
constexpr char kMethod[] = "bmfr";

// Frames and encoded references of one sequence in host memory, up to the last frame with a reference.
struct LoadedSequence {
  std::unique_ptr<io::FrameSequence> sequence;
  std::vector<io::FrameData> frames;
  std::vector<std::optional<io::Reference>> references;  // one a frame
};

LoadedSequence load(const std::string& directory, const io::SequenceOptions& reading) {
  LoadedSequence loaded{openWatched(directory, reading), {}, {}};
  io::References references(*loaded.sequence);
  std::size_t needed = 0;
  for (const int number : loaded.sequence->frames()) {
    loaded.frames.push_back(loaded.sequence->read(number));
    std::optional<io::Reference> reference = references.of(number);
    if (reference) {
      needed = loaded.frames.size();
      reference->a = metrics::encodeForDisplay(reference->a);
      if (!reference->b.empty()) reference->b = metrics::encodeForDisplay(reference->b);
    }
    loaded.references.push_back(std::move(reference));
  }
  if (needed == 0) refuse(kCommand, "--input", "a sequence with at least one reference frame", directory);
  if (loaded.frames.front().demodulated)
    refuse(kCommand, "--input", "a sequence whose radiance is not demodulated", directory);
  loaded.frames.resize(needed);
  return loaded;
}

// The table of Flatval 2020 by groups, without the nine products w*n (all at once they are half of a list), and what
// the inputs have images for.
std::string defaultPool(const std::vector<LoadedSequence>& sequences) {
  const auto all = [&](const io::Image io::FrameData::*image) {
    return std::all_of(sequences.begin(), sequences.end(),
                       [&](const LoadedSequence& loaded) { return !(loaded.frames.front().*image).empty(); });
  };
  std::string pool = "n,n2,n3,sqrt(n),w,w2,w3,sqrt(w),w*w,depth,g";
  if (all(&io::FrameData::albedo)) pool += ",albedo";
  if (all(&io::FrameData::roughness)) pool += ",roughness";
  return pool;
}

class Evaluator {
 public:
  Evaluator(const SelectionArguments& arguments, const std::vector<LoadedSequence>& sequences)
      : m_arguments(arguments), m_sequences(sequences) {}

  double rmse(const std::string& features) const {
    double sum = 0.0;
    int count = 0;
    for (const LoadedSequence& loaded : m_sequences) addErrors(loaded, features, sum, count);
    return metrics::signedRoot(sum / count);
  }

 private:
  void addErrors(const LoadedSequence& loaded, const std::string& features, double& sum, int& count) const {
    Settings settings = defaultSettings(kMethod, *loaded.sequence);
    settings.set("taa", "off");
    for (const auto& [name, value] : m_arguments.settings) settings.set(name, value);
    settings.set("features", features);
    DenoiseSession session(m_arguments.device.device, settings,
                           makeOptions(m_arguments.device, TimerMode::Off), loaded.frames.front());
    for (std::size_t i = 0; i < loaded.frames.size(); ++i) {
      const auto& reference = loaded.references[i];
      if (!reference) {
        session.run(loaded.frames[i]);
        continue;
      }
      const io::Image encoded = metrics::encodeForDisplay(session.denoise(loaded.frames[i]).linear);
      sum += metrics::unbiasedMse(encoded, reference->a, reference->b.empty() ? reference->a : reference->b);
      ++count;
    }
  }

  const SelectionArguments& m_arguments;
  const std::vector<LoadedSequence>& m_sequences;
};

// What the list would be with this entry, unless it is in there already or does not fit.
std::optional<std::string> extended(const std::string& list, const std::string& entry, int mostFeatures) {
  const std::vector<std::string> names = FitFeatures(list).names();
  const std::set<std::string> present(names.begin(), names.end());
  std::string longer = list;
  int count = static_cast<int>(names.size());
  for (const std::string& name : expandFeatures(entry)) {
    if (present.count(name) > 0) continue;
    longer += "," + name;
    ++count;
  }
  if (longer == list || count > mostFeatures) return std::nullopt;
  return longer;
}

std::vector<std::string> poolEntries(const SelectionArguments& arguments,
                                     const std::vector<LoadedSequence>& sequences) {
  const std::string pool = arguments.pool.empty() ? defaultPool(sequences) : arguments.pool;
  std::vector<std::string> entries = arguments.components ? expandFeatures(pool) : splitFeatures(pool);
  for (const std::string& entry : entries) expandFeatures(entry);  // throws for what is no feature
  return entries;
}

SelectionStep makeStep(const std::string& added, const std::string& features, double rmse) {
  return {added, features, FitFeatures(features).count(), rmse, 0.0};
}

// The entry that lowers the error the most; nothing if none does. Entries that the windows refuse are passed over.
std::optional<SelectionStep> bestStep(const SelectionStep& last, const std::vector<std::string>& pool,
                                      const Evaluator& evaluator, int mostFeatures) {
  std::optional<SelectionStep> best;
  Progress progress(fmt::format("{} features", last.count), pool.size());
  for (const std::string& entry : pool) {
    const auto features = extended(last.features, entry, mostFeatures);
    if (features) {
      try {
        const double rmse = evaluator.rmse(*features);
        if (rmse < (best ? best->rmse : last.rmse)) best = makeStep(entry, *features, rmse);
      } catch (const Error& error) {
        if (error.code() != ErrorCode::OutOfRange) throw;
      }
    }
    progress.step(entry);
  }
  if (best) best->gain = 1.0 - best->rmse / last.rmse;
  return best;
}

}  // namespace

std::vector<SelectionStep> selectFeatures(const SelectionArguments& arguments) {
  const FitFeatures start(arguments.start);
  if (start.count() > arguments.mostFeatures)
    refuse(kCommand, "--count", fmt::format("at least the {} features of --start", start.count()),
           std::to_string(arguments.mostFeatures));
  std::vector<LoadedSequence> sequences;
  for (const std::string& directory : arguments.inputs)
    sequences.push_back(load(directory, arguments.reading));
  const std::vector<std::string> pool = poolEntries(arguments, sequences);
  const Evaluator evaluator(arguments, sequences);
  std::vector<SelectionStep> steps = {makeStep("", arguments.start, evaluator.rmse(arguments.start))};
  while (const auto step = bestStep(steps.back(), pool, evaluator, arguments.mostFeatures))
    steps.push_back(*step);
  return steps;
}

nlohmann::json toJson(const std::vector<SelectionStep>& steps) {
  nlohmann::json result = nlohmann::json::array();
  for (const SelectionStep& step : steps)
    result.push_back({{"added", step.added},
                      {"features", step.features},
                      {"count", step.count},
                      {"unbiased_rmse", step.rmse},
                      {"gain", step.gain}});
  return result;
}

void print(const std::vector<SelectionStep>& steps) {
  fmt::print("{:>4}  {:<14} {:>8}  {:>13}  {:>7}\n", "step", "added", "features", "unbiased RMSE", "gain");
  for (std::size_t i = 0; i < steps.size(); ++i)
    fmt::print("{:>4}  {:<14} {:>8}  {:>13.5f}  {:>6.2f}%\n", i, i == 0 ? "(start)" : steps[i].added,
               steps[i].count, steps[i].rmse, 100.0 * steps[i].gain);
  fmt::print("\nfeatures={}\n", steps.back().features);
}

}  // namespace quell::cli
