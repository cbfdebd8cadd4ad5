// The C API's descriptions of a frame as C++ has them.
#pragma once

#include <quell/quell.h>

#include <quell/denoiser.hpp>

namespace quell::c_api {

/// All throw Error(InvalidArgument) for null, unusable struct sizes and unknown enumerators; `function` is the C
/// function that was called. What the values mean is checked by the denoiser.
Frame toFrame(const quell_frame* given, const char* function);
Output toOutput(const quell_output* given, const char* function);
/// NULL: the defaults.
Options toOptions(const quell_options* given, const char* function);

}  // namespace quell::c_api
