#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// What a bench's recorder writes, row by row.
struct Row {
  double time = 0.0;     ///< s
  double command = 0.0;  ///< N·m
  double angle = 0.0;    ///< rad, as the encoder says
};

/// The whole text of a CSV file: time in s, torque command in N·m, encoder angle in degrees.
std::string recording_text(const std::vector<Row>& rows);

/// A different one for every trial, the same for ever.
std::uint64_t noise_seed(const std::string& trial);

/// What a generator does: writes FOLDER/TRIAL.csv, with the text that `text_of` has for it, for each of the trials.
/// `arguments` are those of main; the result is its exit code.
int write_recordings(std::span<char*> arguments, std::span<const char* const> trials,
                     const std::function<std::string(const std::string& trial)>& text_of);

}  // namespace bench
