// Greedy choice of the features of a fit (Koskela et al. 2019, section on feature buffers; Flatval 2020, chapter 4.5.2).
#pragma once

#include <nlohmann/json.hpp>
#include <quell/quell.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/cli/common/command_arguments.hpp"

namespace quell::cli {

struct SelectionArguments {
  std::vector<std::string> inputs;  ///< sequences, each with at least one reference frame
  io::SequenceOptions reading;
  /// Entries are added one at a time; groups such as "w" whole, "so that the selection does not overfit to camera
  /// orientations" (Koskela et al.). Empty: everything that the inputs have images for.
  std::string pool;
  std::string start = "1";  ///< features to start with
  bool components = false;  ///< take the pool's groups apart, as Flatval does
  int mostFeatures = 16;    ///< scalars, the constant one included
  std::vector<std::pair<std::string, std::string>> settings;  ///< of the method bmfr
  DeviceArguments device;
};

/// One more entry of the pool in the list.
struct SelectionStep {
  std::string added;     ///< entry of the pool; empty for the start
  std::string features;  ///< the list with it
  int count = 0;         ///< scalar features
  /// Square root of the mean over all reference frames of mean((I - A)(I - B)), display-encoded, before TAA; the plain
  /// error against the only half of a reference that has but one.
  double rmse = 0.0;
  double gain = 0.0;  ///< share of the RMSE of the step before that it took away
};

/// The first step is the start. Ends when nothing lowers the RMSE any more, or nothing that is left fits into the
/// number of features. Throws Error(InvalidArgument) if no input has a reference frame, and whatever the settings, the
/// sequences and the denoiser throw.
std::vector<SelectionStep> selectFeatures(const SelectionArguments& arguments);

/// [{added, features, count, unbiased_rmse, gain}, ...]
nlohmann::json toJson(const std::vector<SelectionStep>& steps);
void print(const std::vector<SelectionStep>& steps);

}  // namespace quell::cli
