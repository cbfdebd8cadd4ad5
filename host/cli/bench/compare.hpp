// What changed between two results of quell bench.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace quell::cli {

/// Reads a file written by quell bench --json. Throws Error(FileError) or Error(InvalidArgument).
nlohmann::json readBench(const std::string& file);

/// Lines about every run that is in both results (same sequence, size and settings): slower or faster where the ranges
/// of the rounds' median frame times, in copies, do not meet and differ by more than 2 %; worse or better where an error
/// figure moved by more than 0.5 %. Ends with a line that counts them.
/// Throws Error(InvalidArgument) if `before` is no result of quell bench; `file` is its name for the message.
std::string compareBench(const nlohmann::json& before, const nlohmann::json& now, const std::string& file);

}  // namespace quell::cli
