// What a check says, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/cli/check/sequence_check.hpp"

namespace quell::cli {

/// `name`: of the sequence.
std::string checkText(const std::string& name, const SequenceCheck& check);
nlohmann::ordered_json checkJson(const std::string& name, const SequenceCheck& check);

/// "frame 3", or "4 frames from 0 to 3".
std::string framesText(const std::vector<int>& frames);
/// "fine", "doubtful" or "wrong".
const char* verdictOf(Severity worst);
/// 0, 1 or 2.
int exitCodeOf(Severity worst);

}  // namespace quell::cli
