#include "app/workspace/exported_rows.h"

#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/plain_streams.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "report/exports/mcap_trace.h"
#include "report/exports/numpy_output.h"
#include "report/exports/trace_rows.h"
#include "storage/files/log_left.h"
#include "storage/queries/query_output.h"
#include "storage/queries/stored_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <functional>

namespace lacuna {
namespace {

constexpr std::size_t kMostTrialsNamed = 20;

bool is_binary(RowFormat format) { return format == RowFormat::npz || format == RowFormat::mcap; }

std::unique_ptr<QueryOutput> output_of(const RowsExport& wanted, std::ostream& stream) {
  switch (wanted.format) {
    case RowFormat::json: return make_query_output(QueryFormat::json, stream);
    case RowFormat::json_lines: return make_query_output(QueryFormat::json_lines, stream);
    case RowFormat::npz: return make_numpy_output(stream, wanted.stop);
    case RowFormat::csv:
    case RowFormat::mcap: break;
  }
  return make_query_output(QueryFormat::csv, stream);
}

/// Hands rows on and counts them.
class CountedRows : public QueryOutput {
 public:
  explicit CountedRows(std::unique_ptr<QueryOutput> output) : output_(std::move(output)) {}
  void begin(const std::vector<std::string>& columns) override { output_->begin(columns); }
  void row(const std::vector<Cell>& cells) override {
    ++count_;
    output_->row(cells);
  }
  void end() override { output_->end(); }
  std::size_t count() const { return count_; }

 private:
  std::unique_ptr<QueryOutput> output_;
  std::size_t count_ = 0;
};

void write_to(const RowsExport& wanted, const std::function<void(std::ostream&)>& write) {
  if (wanted.to.empty()) {
    write(exact_output());
    return;
  }
  WholeFile file(wanted.to, Link::followed, wanted.stop);
  write(file.stream());
  wanted.existing == Existing::refused ? file.publish_as_new() : file.publish();
}

/// On standard error, which no rows go to.
void tell(const RowsExport& wanted, const std::string& what) {
  if (!wanted.to.empty() && !wanted.quiet) fmt::print(stderr, "{}  {}\n", plain_text(wanted.to), plain_text(what));
}

void write_table(const Database& database, const RowsExport& wanted) {
  if (wanted.format == RowFormat::mcap)
    throw_problem({wanted.to}, fmt::format("an MCAP file holds readings by their times, and {} is a table; use --csv, "
                                           "--json or --npz",
                                           wanted.what));
  std::size_t rows = 0;
  write_to(wanted, [&](std::ostream& stream) {
    CountedRows output(output_of(wanted, stream));
    read_table(database, wanted.what, output);
    rows = output.count();
  });
  tell(wanted, fmt::format("{} {} of {}", rows, rows == 1 ? "row" : "rows", wanted.what));
}

/// "measured and predicted by revision 2".
std::string parts_text(const NamedTrace& trace) {
  std::vector<std::string> labels;
  for (const NamedTrace::Part& part : trace.parts) labels.push_back(part.label);
  const std::string by = trace.revision ? fmt::format(" by revision {}", *trace.revision) : "";
  return fmt::format("{}{}", fmt::join(labels, " and "), by);
}

void write_trace(const NamedTrace& trace, const RowsExport& wanted) {
  write_to(wanted, [&](std::ostream& stream) {
    if (wanted.format == RowFormat::mcap) return write_mcap_trace(trace, stream, wanted.stop);
    write_trace_rows(trace, *output_of(wanted, stream), wanted.stop);
  });
  tell(wanted, fmt::format("{} of {}: {}", trace.trial, trace.experiment, parts_text(trace)));
  if (trace.parts.size() == 1 && trace.parts.front().label == "measured" && !wanted.quiet)
    fmt::print(stderr, "{}: no model has predicted this trial yet; to predict it: lacuna compare\n",
               plain_text(trace.trial));
}

/// "sine.csv, steps.csv"; of many trials the first ones.
std::string trials_text(const std::vector<std::string>& trials) {
  if (trials.empty()) return "none";
  const auto named = static_cast<std::ptrdiff_t>(std::min(trials.size(), kMostTrialsNamed));
  return fmt::format("{}{}", fmt::join(trials.begin(), trials.begin() + named, ", "),
                     trials.size() > kMostTrialsNamed ? " and more (see view traces)" : "");
}

[[noreturn]] void refuse_unknown(const Database& database, const StoredTables& tables, const std::string& what) {
  const std::vector<std::string> trials = names_of_traces(database, kMostTrialsNamed + 1);
  std::vector<std::string> all = tables.views;
  all.insert(all.end(), trials.begin(), trials.end());
  all.insert(all.end(), tables.tables.begin(), tables.tables.end());
  const std::string begin =
      what.empty() ? "say what to export, one of these:"
                   : fmt::format("has no view, trial or table \"{}\"{}; it has these:", what, did_you_mean(what, all));
  throw BadInput({{{database.file().string()}, begin},
                  {{}, fmt::format("  views: {}", fmt::join(tables.views, ", "))},
                  {{}, fmt::format("  trials: {}", trials_text(trials))},
                  {{}, fmt::format("  tables: {}", fmt::join(tables.tables, ", "))}});
}

void check_place(const RowsExport& wanted) {
  if (!wanted.to.empty()) return check_new_output(wanted.to, wanted.existing);
  if (is_binary(wanted.format) && ::isatty(STDOUT_FILENO) != 0)
    throw_problem({}, "a binary file cannot go to a terminal; name the file, as in --npz=FILE, or use a pipe");
}

}  // namespace

std::optional<RowFormat> row_format_of(const std::filesystem::path& file) {
  static constexpr std::array<std::pair<std::string_view, RowFormat>, 6> kEndings{{{".csv", RowFormat::csv},
                                                                                   {".json", RowFormat::json},
                                                                                   {".jsonl", RowFormat::json_lines},
                                                                                   {".ndjson", RowFormat::json_lines},
                                                                                   {".npz", RowFormat::npz},
                                                                                   {".mcap", RowFormat::mcap}}};
  const std::string ending = file.extension().string();
  for (const auto& [known, format] : kEndings)
    if (ending == known) return format;
  return std::nullopt;
}

void export_rows(const RowsExport& wanted) {
  note_database(wanted.database);
  check_place(wanted);
  const LogLeft log(wanted.database);
  const Database database = Database::open_read_only(wanted.database, wanted.stop);
  const StoredTables tables = stored_tables(database);
  const auto has = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), wanted.what) != names.end();
  };
  if (has(tables.views) || has(tables.tables)) return write_table(database, wanted);
  const std::optional<NamedTrace> trace = find_named_trace(database, {wanted.what, wanted.revision});
  if (!trace) refuse_unknown(database, tables, wanted.what);
  write_trace(*trace, wanted);
}

}  // namespace lacuna
