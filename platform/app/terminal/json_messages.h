#pragma once

#include "foundation/work.h"
#include "foundation/text/problem.h"

#include <string>

namespace lacuna {

/// Whether progress and errors on standard error are lines of JSON, for a program that reads them: the environment
/// variable `LACUNA_MESSAGES` is `json`. Throws `BadInput` where it is anything but that or `text`.
bool messages_are_json();

/// `{"progress":{"phase":"segments of 0.5 s","fraction":0.4,"seconds_left":1.2}}`, with null for an unknown time.
std::string progress_message(const Progress& progress);

/// A line for each problem: `{"problem":{"file":"rig.toml","line":3,"column":1,"key":"engine.step","message":"..."}}`.
/// `file` and `key` are "" and numbers are 0 where they are not known; the message begins with the key.
std::string problem_messages(const BadInput& bad);

/// `{"failure":"..."}`, of what is no fault of the input, an interruption included.
std::string failure_message(const std::string& sentence);

}  // namespace lacuna
