// Every way in which the kernels of a method are compiled.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace quell::cli {

/// Which images the caller hands over in the configurations that are looked at.
enum class ImageSets {
  Typical,  ///< every optional image, packed float3: one signal, and two
  All,      ///< also half4 images, and none but the required ones with depth for position
};

/// Kernel stem and compile options -> the methods that use them.
using KernelVariants = std::map<std::pair<std::string, std::string>, std::set<std::string>>;

/// Adds what `method` compiles under every combination of its switches and choices, with these features where it fits
/// any (empty: the default) and other settings at their defaults, for a device with `lanes` pixels per work-item (1: a GPU, more: a CPU) that allows work-groups of
/// `maxWorkGroup`. Combinations that the library refuses are left out. Throws Error(UnknownSetting) for an unknown
/// method, Error(OutOfRange) for features that are none.
void addKernelVariants(KernelVariants& variants, const std::string& method, ImageSets images, int lanes,
                       std::size_t maxWorkGroup, const std::string& features = "");

}  // namespace quell::cli
