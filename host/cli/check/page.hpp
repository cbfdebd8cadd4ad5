// What a check says as one HTML file with its pictures in it, to be opened in any browser without a network.
#pragma once

#include <map>
#include <string>

#include "host/cli/check/sequence_check.hpp"

namespace quell::cli {

/// `pngs`: the bytes of a picture by kind of finding; kinds may be missing.
std::string checkPage(const std::string& name, const SequenceCheck& check,
                      const std::map<std::string, std::string>& pngs);

}  // namespace quell::cli
