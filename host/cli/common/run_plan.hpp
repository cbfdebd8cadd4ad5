// What the bench command shall run: methods with their settings, and the sequences to run them on.
#pragma once

#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// A setting and the values that it takes in turn.
struct Variation {
  std::string setting;
  std::vector<std::string> values;  ///< at least one
};

/// What stands between the values of a setting: a comma, or a semicolon where values are texts that contain commas.
char valueSeparator(const std::string& setting);

/// Reads "name=value,value". Throws Error(InvalidArgument).
Variation parseVariation(const std::string& text);

/// A method with the settings that the command line gives it; the others keep their defaults.
struct PlannedRun {
  std::string method;
  std::vector<std::pair<std::string, std::string>> assignments;  ///< name and value
  std::string sweep = {};  ///< the named sweep that it belongs to, if any

  std::string settingsText() const;  ///< "solver=gram windows=overlap"; empty for defaults
  std::string name() const;          ///< the method, followed by settingsText()

  /// Throws Error(OutOfRange) for a value that this method refuses.
  Settings settings(const io::FrameSequence& sequence) const;
};

/// All methods times all values of those variations whose setting a method has, the last one varying
/// fastest. Throws Error(UnknownSetting) for an unknown method or a setting that none of the methods has,
/// Error(OutOfRange) for a value that none of them takes, Error(InvalidArgument) for a setting varied twice.
std::vector<PlannedRun> planRuns(const std::vector<std::string>& methods,
                                 const std::vector<Variation>& variations);

/// A sequence and the frames of it to run.
struct BenchInput {
  std::unique_ptr<io::FrameSequence> sequence;
  std::vector<int> frames;  ///< at least one
};

/// Runs that are compared with each other, on sequences of their own.
struct BenchGroup {
  std::vector<PlannedRun> runs;
  std::vector<BenchInput> inputs;
  /// Only for the built-in sequence: timed rounds go on with the history that is there, from the last frame back to the
  /// first and on again, so that a few frames show what a frame far into a sequence takes.
  bool keepsHistory = false;
};

/// What to open. With neither directories nor sizes: the built-in sequence at 1280x720.
struct InputArguments {
  std::vector<std::string> directories;
  std::vector<std::string> sizes;         ///< of the built-in sequence, such as "1280x720"
  std::vector<double> skyShares = {0.0};  ///< of the built-in sequence's rows; it runs once for each
  io::SequenceOptions reading;            ///< of the directories
  int mostFrames = 0;                     ///< the first frames of every sequence; 0: all, or 16 built-in ones
};

/// The first of the directories (at least one) whose frames have roughness. Where none has, the first: what cannot run
/// there is reported. Throws as openInputs().
std::string directoryWithRoughness(const std::vector<std::string>& directories,
                                   const io::SequenceOptions& reading = {});

/// Directories first, then sizes. Throws Error(FileError) or Error(InvalidArgument).
std::vector<BenchInput> openInputs(const InputArguments& arguments);

}  // namespace quell::cli
