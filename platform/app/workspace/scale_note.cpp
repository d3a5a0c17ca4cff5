#include "app/workspace/scale_note.h"

#include "data_checks/reading_scale.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace lacuna {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kSameFactor = 0.01;

bool is_near(double a, double b) { return std::abs(a / b - 1.0) < kSameFactor; }

const ColumnMapping* mapping_of(const OpenExperiment& opened, const std::string& channel) {
  const std::vector<ColumnMapping>& sensors = opened.experiment.target.recording.sensors;
  const auto found = std::find_if(sensors.begin(), sensors.end(),
                                  [&](const ColumnMapping& mapping) { return mapping.channel == channel; });
  return found == sensors.end() ? nullptr : &*found;
}

std::optional<ReadingScale> scale_of(const OpenExperiment& opened) {
  return reading_scale({opened.definition, *opened.model, opened.trials, opened.definition.start_values()});
}

struct Correction {
  std::string lines;        ///< to type
  SourceLocation location;  ///< of the first column
};

Correction correction_of(const OpenExperiment& opened, const ReadingScale& scale) {
  Correction correction;
  for (const std::string& channel : scale.channels)
    if (const ColumnMapping* mapping = mapping_of(opened, channel)) {
      if (correction.lines.empty()) correction.location = mapping->location;
      correction.lines += fmt::format("{}{} = {{ ..., {} }}", correction.lines.empty() ? "" : ", ", channel,
                                      corrected_key(*mapping, scale.factor));
    }
  return correction;
}

}  // namespace

std::string corrected_key(const ColumnMapping& mapping, double factor) {
  const std::optional<Unit> unit = parse_unit(mapping.unit);
  const std::optional<Unit> gain = parse_unit(mapping.gain_unit.empty() ? "1" : mapping.gain_unit);
  const double counts = kTurn / mapping.gain * factor;
  if (mapping.unit == "1" && mapping.gain_unit == "rad" && is_near(counts, std::round(counts)))
    return fmt::format("counts_per_turn = {:.0f}", std::round(counts));
  if (unit && mapping.gain == 1.0)
    for (const std::string_view other : {"rad", "deg", "rev", "m", "cm", "mm", "in", "ft"})
      if (const std::optional<Unit> likelier = parse_unit(std::string(other));
          likelier->same_dimension(*unit) && is_near(likelier->to_si, unit->to_si / factor))
        return fmt::format("unit = \"{}\"", other);
  const double number = mapping.gain / (gain ? gain->to_si : 1.0) / factor;
  if (mapping.gain_unit.empty()) return fmt::format("gain = {:.6g}", number);
  return fmt::format("gain = \"{:.6g} {}\"", number, mapping.gain_unit);
}

std::optional<ReadingNote> scale_note(const OpenExperiment& opened) {
  const std::optional<ReadingScale> scale = scale_of(opened);
  if (!scale) return std::nullopt;
  const Correction correction = correction_of(opened, *scale);
  return ReadingNote{
      correction.location,
      fmt::format("{}; in that case write under [target.sensors]: {}", to_string(*scale), correction.lines), true};
}

std::string scale_correction(const OpenExperiment& opened) {
  const std::optional<ReadingScale> scale = scale_of(opened);
  return scale ? correction_of(opened, *scale).lines : "";
}

}  // namespace lacuna
