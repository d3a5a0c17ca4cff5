#pragma once

#include "storage/core/records.h"

#include <optional>
#include <string>

namespace lacuna {

/// How enumerators stand in the database.
inline const char* to_string(RunEnding ending) {
  switch (ending) {
    case RunEnding::done: return "done";
    case RunEnding::failed: return "failed";
    case RunEnding::interrupted: return "interrupted";
  }
  return "";
}

inline const char* to_string(TraceKind kind) {
  switch (kind) {
    case TraceKind::measured: return "measured";
    case TraceKind::commands: return "commands";
    case TraceKind::predicted: return "predicted";
    case TraceKind::centre_of_mass: return "centre_of_mass";
  }
  return "";
}

inline const char* to_string(ComparisonKind kind) {
  return kind == ComparisonKind::refitted ? "refitted" : "as_written";
}

/// NULL where neither.
inline std::optional<std::string> text_of(AtBound bound) {
  switch (bound) {
    case AtBound::neither: return std::nullopt;
    case AtBound::lower: return "lower";
    case AtBound::upper: return "upper";
  }
  return std::nullopt;
}

inline AtBound bound_from(const std::string& text) {
  if (text.empty()) return AtBound::neither;
  return text == "lower" ? AtBound::lower : AtBound::upper;
}

}  // namespace lacuna
