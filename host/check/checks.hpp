// The table of checks. A new one is a function and a line in its group's file; a new group one more line in checks.cpp.
#pragma once

#include <vector>

#include "host/check/context.hpp"

namespace quell::check {

/// Adds what it measures and what it finds.
using Check = void (*)(const Context&, Result&);

/// A group of checks that are about the same images, in the order in which they run.
using Group = std::vector<Check>;

const Group& surfaceChecks();
const Group& cameraChecks();
const Group& depthChecks();
const Group& normalChecks();
const Group& motionChecks();
const Group& historyChecks();
const Group& radianceChecks();
const Group& albedoChecks();
const Group& absentChecks();

/// Name of the figure that says how many surfaces keep their history.
constexpr char kFoundBefore[] = "surfaces within the last image that are found there";

/// Runs all of them, causes before what follows from them. `before`: the frame right before, or null.
Result checkFrame(const Frame& now, const Frame* before);

}  // namespace quell::check
