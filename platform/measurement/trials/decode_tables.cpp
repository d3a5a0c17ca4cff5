#include "measurement/trials/decode_tables.h"

#include "foundation/text/counted.h"
#include "foundation/unit.h"
#include "measurement/cells/decode.h"
#include "measurement/trials/encoding_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace lacuna {
namespace {

constexpr double kSmallestNumber = 1e-290;  ///< a smaller number is uninitialised memory
constexpr double kLargestNumber = 1e30;     ///< a larger number marks a missing value

void drop_unwritten(const std::vector<const PlannedColumn*>& planned, ReadTable& read) {
  for (std::size_t c = 0; c < planned.size(); ++c) {
    std::size_t count = 0, first = 0;
    for (std::size_t row = 0; row < read.table.columns[c].size(); ++row) {
      double& value = read.table.columns[c][row];
      if (value == 0.0 || !(std::abs(value) < kSmallestNumber || std::abs(value) > kLargestNumber)) continue;
      if (count++ == 0) first = row;
      value = std::nan("");
    }
    if (count == 0) continue;
    read.report.doubt("unwritten " + planned[c]->mapping->column, read.table.lines[first], [&] {
      return fmt::format("column `{}` has {} below 1e-290 or beyond 1e30, which no device measures; treated as missing",
                         planned[c]->mapping->column, counted(count, "number"));
    });
  }
}

/// A column of all good tables, a vector for each trial.
struct ColumnParts {
  std::vector<std::vector<double>> values;
  std::vector<std::pair<std::size_t, std::vector<std::size_t>>> from;  ///< table and rows of each
};

ColumnParts parts_of(const std::vector<ReadTable>& tables, std::size_t column) {
  ColumnParts parts;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    if (tables[t].report.has_problems() || tables[t].table.columns[column].empty()) continue;
    for (std::vector<std::size_t>& rows : rows_by_trial(tables[t].table)) {
      std::vector<double> values;
      for (const std::size_t row : rows) values.push_back(tables[t].table.columns[column][row]);
      parts.values.push_back(std::move(values));
      parts.from.emplace_back(t, std::move(rows));
    }
  }
  return parts;
}

std::string meaning_of(const Encoding& encoding) {
  switch (encoding.kind) {
    case EncodingKind::sign_bit:
      return fmt::format("negative values are stored as {:.0f} + their size", encoding.modulus);
    case EncodingKind::twos_complement:
      return fmt::format("negative values are stored as {:.0f} minus their size", encoding.modulus);
    case EncodingKind::wraps: return fmt::format("the counter restarts at {:.6g}", encoding.modulus);
    case EncodingKind::automatic:
    case EncodingKind::plain: break;
  }
  return {};
}

/// The table and the row of a reading, counted over all parts.
std::pair<ReadTable*, int> line_of(std::size_t place, const ColumnParts& parts, std::vector<ReadTable>& tables) {
  for (std::size_t p = 0; p < parts.values.size(); ++p) {
    if (place < parts.values[p].size()) {
      ReadTable& read = tables[parts.from[p].first];
      return {&read, read.table.lines[parts.from[p].second[place]]};
    }
    place -= parts.values[p].size();
  }
  return {&tables.front(), 0};
}

std::string lines_to_write(std::span<const double> moduli) {
  std::string text;
  for (const double modulus : moduli)
    text +=
        (text.empty() ? "encoding = \"" : "\" or encoding = \"") + to_string(Encoding{EncodingKind::wraps, modulus});
  return text + "\"";
}

void note_encoding(const ColumnMapping& mapping, const std::string& section, const FoundEncoding& found,
                   const ColumnParts& parts, std::vector<ReadTable>& tables) {
  const auto [read, line] = line_of(found.first, parts, tables);
  read->report.doubt("encoding of " + mapping.column, line, [&, &jumps = found.jumps] {
    std::string text = fmt::format(
        "column `{}` jumps {}, here for the first time: {}; decoded accordingly. State this in target.{}.{}: encoding "
        "= \"{}\"; if it is wrong, encoding = \"plain\"",
        mapping.column, counted(jumps, "time"), meaning_of(found.encoding), section, mapping.channel,
        to_string(found.encoding));
    if (found.moduli.size() > 1)
      text += ". The readings also agree with " + lines_to_write(std::span(found.moduli).subspan(1));
    return text;
  });
}

/// A wrong count would shift all readings after a jump, so the experiment must state it.
void refuse_wrap(const ColumnMapping& mapping, const std::string& section, const FoundEncoding& found,
                 const ColumnParts& parts, std::vector<ReadTable>& tables) {
  const auto [read, line] = line_of(found.first, parts, tables);
  read->report.problem("encoding of " + mapping.column, line, [&, &jumps = found.jumps] {
    std::string text =
        fmt::format("column `{}` jumps {}, here for the first time, like a counter that restarts at {:.9g} ± {:.2g}. ",
                    mapping.column, counted(jumps, "time"), found.estimate, found.error);
    if (found.moduli.empty())
      text +=
          fmt::format("No usual count is near this value. State it in target.{}.{}, as in encoding = \"wraps {:.0f}\"",
                      section, mapping.channel, found.estimate);
    else
      text += fmt::format("The readings agree with several counts. State the right one in target.{}.{}: {}", section,
                          mapping.channel, lines_to_write(found.moduli));
    return text + "; if no counter restarts, encoding = \"plain\"";
  });
}

EncodingHints hints_of(const PlannedColumn& planned) {
  const bool is_angle = planned.channel.unit == "rad", is_length = planned.channel.unit == "m";
  EncodingHints hints{is_angle || is_length || planned.mapping->derivative, {}};
  if (is_angle && planned.factor != 0.0) hints.turns.push_back(2.0 * M_PI / std::abs(planned.factor));
  const std::optional<Unit> own = parse_unit(planned.mapping->unit);
  if (own && own->angle) hints.turns.push_back(2.0 * M_PI / own->to_si);
  return hints;
}

/// Of one column, in all tables.
void decode_column(std::size_t column, const PlannedColumn& planned, const std::string& section,
                   std::vector<ReadTable>& tables) {
  Encoding encoding = planned.mapping->encoding;
  if (encoding.kind == EncodingKind::plain) return;
  ColumnParts parts = parts_of(tables, column);
  if (encoding.kind == EncodingKind::automatic) {
    const std::optional<FoundEncoding> found = guess_encoding(parts.values, hints_of(planned));
    if (!found) return;
    encoding = found->encoding;
    if (encoding.kind == EncodingKind::automatic) return refuse_wrap(*planned.mapping, section, *found, parts, tables);
    note_encoding(*planned.mapping, section, *found, parts, tables);
  }
  for (std::size_t p = 0; p < parts.values.size(); ++p) {
    decode(encoding, parts.values[p]);
    std::vector<double>& values = tables[parts.from[p].first].table.columns[column];
    for (std::size_t i = 0; i < parts.values[p].size(); ++i) values[parts.from[p].second[i]] = parts.values[p][i];
  }
}

}  // namespace

void decode_tables(const RecordingPlan& plan, std::vector<ReadTable>& tables) {
  const std::vector<const PlannedColumn*> planned = columns_of(plan);
  for (ReadTable& read : tables)
    if (!read.report.has_problems()) drop_unwritten(planned, read);
  const std::size_t sensors = plan.sensors.size();
  for (std::size_t c = 0; c < sensors + plan.commands.size(); ++c)
    decode_column(c, *planned[c], c < sensors ? "sensors" : "commands", tables);
}

}  // namespace lacuna
