#pragma once

#include "measurement/recording.h"

#include <string>
#include <vector>

namespace lacuna {

/// The notes as sentences, each behind its place. What is noticed in several files is one sentence behind all of the
/// places: "sine.csv:1, steps.csv:1: ...".
std::vector<std::string> note_sentences(const std::vector<ReadingNote>& notes);

}  // namespace lacuna
