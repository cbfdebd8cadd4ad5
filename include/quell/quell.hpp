// Everything of Quell's C++ API.
#pragma once

#include <quell/check.hpp>
#include <quell/denoiser.hpp>
#include <quell/devices.hpp>
#include <quell/error.hpp>
#include <quell/frame.hpp>
#include <quell/replay.hpp>
#include <quell/settings.hpp>
#include <quell/timings.hpp>

/// Everything that Quell offers to C++. What fails throws quell::Error.
namespace quell {}
