// What the cases of change_sums, change_weight and follow_change have in common.
#pragma once

#include "tests/cases/stage_case.hpp"

namespace quell::tests {

/// Settings of change detection other than the defaults: a mixed-up one shows.
constexpr double kChangeHistoryFrames = 8.0;
constexpr double kChangeLeastWeight = 1.0 / kChangeHistoryFrames;
constexpr double kChangeMomentsLeastWeight = 0.3;
constexpr double kChangeMostWeight = 0.9;
constexpr double kChangeThreshold = 1.5;
constexpr double kRecentChangeThreshold = 0.7;
constexpr double kChangeGain = 3.0;
constexpr double kChangeMemory = 0.4;

enum class ChangeSettings { Unusual, Defaults };

/// The method quell with the settings above or with its own.
StageSetup makeChangeSetup(const CaseOptions& options, int signals,
                           ChangeSettings settings = ChangeSettings::Unusual);

/// Of the records of tiles: sums of differences and of their squares.
std::vector<LightInput> lightOfRecords(Planes& sums);

/// None, one frame, a few and the longest ones.
Planes randomHistoryLengths(Size size, int signals, unsigned seed);

}  // namespace quell::tests
