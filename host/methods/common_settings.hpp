// Settings that several methods share, written once.
#pragma once

#include <quell/settings.hpp>
#include <vector>

#include "host/core/reprojection.hpp"
#include "host/stages/edge_stops.hpp"

namespace quell {

using SettingList = std::vector<SettingDescription>;

/// The lists one after the other.
SettingList joined(std::initializer_list<SettingList> lists);

/// demodulate: what light is divided by before it is filtered.
SettingList demodulationSettings();
/// positionLimitFootprints, positionLimit, normalLimitSquared: when history is discarded.
SettingList discardSettings();
DiscardLimits discardLimits(const Settings& settings);
/// taa, taaNewestWeight.
SettingList antialiasingSettings();

/// iterations, luminanceSigma with this default, unit and range, depthSigma, normalPower, roughnessSigma.
SettingList atrousSettings(const SettingDescription& luminanceSigma);
EdgeStops edgeStops(const Settings& settings);

}  // namespace quell
