// What a method's table is written with.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/core/schedule.hpp"
#include "host/core/stage.hpp"
#include "host/methods/common_settings.hpp"
#include "host/stages/box_filter.hpp"

namespace quell {

/// Adds one line to the table.
template <class StageType>
void add(Schedule& table, StageType stage, std::vector<Wire> wires = {}) {
  table.push_back({std::make_unique<StageType>(std::move(stage)), std::move(wires)});
}

/// The buffers that an iteration of a filter reads or writes.
struct FilterLevel {
  std::string irradiance;
  std::string variance;
};

/// What leaves iteration `i` (0: enters the first): two pairs of buffers by turns.
FilterLevel levelAfter(int iteration);
/// The wires of an iteration of the stage atrous.
std::vector<Wire> atrousWires(const FilterLevel& in, const FilterLevel& out);

/// Adds the lines that take sums or minima over windows, columns and then rows, from one buffer to another. `radius`: of
/// elements in a row and in a column; those of `planes` do not count.
void addWindows(Schedule& table, const BoxFilter::Setup& planes, std::array<int, 2> radius,
                const std::string& from, const std::string& to);

/// Adds the lines that measure what light the filter has lost, in the buffer `filtered`; the stage variance has written
/// the luminance of the history.
void addLightGain(Schedule& table, const Configuration& configuration, const std::string& filtered);

/// Whether background takes part in temporal antialiasing.
enum class BackgroundAntialiasing {
  IfJittered,  ///< elsewhere the display shows it as it comes
  Always,
};

/// Whether the display image, or with jittered rays the linear one, is antialiased over time.
bool antialiases(const Configuration& configuration, const AntialiasingSettings& antialiasing);

/// Adds the lines from filtered irradiance, in the buffer `filtered`, to the caller's images: background (with `skip`),
/// remodulate and, with `taa`, temporal_antialiasing. `keepLight`: light_gain has gone before.
void addOutputStages(Schedule& table, const Configuration& configuration, const std::string& filtered,
                     const AntialiasingSettings& antialiasing, bool skip,
                     BackgroundAntialiasing background = BackgroundAntialiasing::IfJittered,
                     bool keepLight = false);

}  // namespace quell
