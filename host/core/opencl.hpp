// clhpp for use inside Quell: exceptions on, OpenCL 1.2.
//
// clhpp changes its inline functions with macros. An application that embeds Quell may compile clhpp with
// others, and one linker would merge the two; so Quell's copy lives in a namespace of its own.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define cl quell_clhpp
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wignored-attributes"
#include <CL/opencl.hpp>
#pragma GCC diagnostic pop
#undef cl

namespace quell {
namespace cl = ::quell_clhpp;
}  // namespace quell
