#include "storage/queries/query_output.h"

#include "foundation/text/csv_cell.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

bool is_number(const Cell& cell) {
  return std::holds_alternative<std::int64_t>(cell) || std::holds_alternative<double>(cell);
}

/// Text of a cell; `digits` 0: as many as tell the number from every other.
std::string text_of(const Cell& cell, int digits) {
  struct Writer {
    int digits;
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const {
      return digits > 0 ? fmt::format("{:.{}g}", value, digits) : fmt::format("{}", value);
    }
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(const Blob& blob) const { return fmt::format("({} bytes)", blob.bytes); }
  };
  return std::visit(Writer{digits}, cell);
}

/// Columns on a screen: characters of UTF-8, as if each were one column wide.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// A cell must not break the line that it stands in.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return text;
}

class TableOutput : public QueryOutput {
 public:
  TableOutput(std::ostream& stream, std::size_t most_bytes) : stream_(stream), most_bytes_(most_bytes) {}

  void begin(const std::vector<std::string>& columns) override {
    if (any_) stream_ << '\n';
    any_ = true;
    columns_ = columns;
    rows_.clear();
    bytes_ = 0;
    right_.assign(columns.size(), true);
  }

  void row(const std::vector<Cell>& cells) override {
    static constexpr int kDigits = 6;
    std::vector<std::string> texts;
    texts.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      texts.push_back(on_one_line(text_of(cells[i], kDigits)));
      if (!is_number(cells[i]) && !std::holds_alternative<std::monostate>(cells[i])) right_[i] = false;
    }
    keep(std::move(texts));
  }

  void end() override {
    std::vector<std::size_t> widths;
    widths.reserve(columns_.size());
    for (const std::string& name : columns_) widths.push_back(width_of(name));
    for (const auto& row : rows_) {
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    write(columns_, widths);
    std::vector<std::string> rules;
    rules.reserve(widths.size());
    for (const std::size_t width : widths) rules.emplace_back(width, '-');
    write(rules, widths);
    for (const auto& row : rows_) write(row, widths);
    if (rows_.empty()) stream_ << "(no rows)\n";
  }

 private:
  void keep(std::vector<std::string> row) {
    bytes_ += sizeof(std::vector<std::string>);
    for (const std::string& text : row) bytes_ += sizeof(std::string) + text.size();
    if (bytes_ > most_bytes_)
      throw_problem({}, fmt::format("the table needs more than {} MB of memory and was not printed; select fewer rows "
                                    "(LIMIT 1000), or use --csv or --json, which print row by row",
                                    most_bytes_ / 1'000'000));
    rows_.push_back(std::move(row));
  }

  void write(const std::vector<std::string>& texts, const std::vector<std::size_t>& widths) {
    std::string line;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const std::string padding(widths[i] - width_of(texts[i]), ' ');
      line += (i == 0 ? "" : "  ") + (right_[i] ? padding + texts[i] : texts[i] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    stream_ << line << '\n';
  }

  std::ostream& stream_;
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;  ///< of the rows that are kept
  bool any_ = false;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<bool> right_;
};

class CsvOutput : public QueryOutput {
 public:
  explicit CsvOutput(std::ostream& stream) : stream_(stream) {}

  void begin(const std::vector<std::string>& columns) override {
    if (any_) stream_ << '\n';
    any_ = true;
    std::string line;
    for (const std::string& name : columns) line += (line.empty() ? "" : ",") + csv_cell(name);
    stream_ << line << '\n';
  }

  void row(const std::vector<Cell>& cells) override {
    for (std::size_t i = 0; i < cells.size(); ++i) stream_ << (i == 0 ? "" : ",") << csv_cell(cell_text(cells[i]));
    stream_ << '\n';
  }

  void end() override {}

 private:
  std::ostream& stream_;
  bool any_ = false;
};

class JsonOutput : public QueryOutput {
 public:
  JsonOutput(std::ostream& stream, bool is_list) : stream_(stream), is_list_(is_list) {}

  void begin(const std::vector<std::string>& columns) override {
    columns_ = columns;
    first_ = true;
    if (is_list_) stream_ << '[';
  }

  void row(const std::vector<Cell>& cells) override {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < cells.size(); ++i) object[columns_[i]] = json_of(cells[i]);
    if (is_list_) stream_ << (first_ ? "\n" : ",\n");
    stream_ << object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    if (!is_list_) stream_ << '\n';
    first_ = false;
  }

  void end() override {
    if (is_list_) stream_ << (first_ ? "]\n" : "\n]\n");
  }

 private:
  static nlohmann::ordered_json json_of(const Cell& cell) {
    if (std::holds_alternative<std::monostate>(cell)) return nullptr;
    if (const auto* integer = std::get_if<std::int64_t>(&cell)) return *integer;
    if (const auto* real = std::get_if<double>(&cell)) return *real;  // what is not finite becomes null
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    return {{"bytes", std::get<Blob>(cell).bytes}};
  }

  std::ostream& stream_;
  bool is_list_;
  std::vector<std::string> columns_;
  bool first_ = true;
};

}  // namespace

std::string cell_text(const Cell& cell) { return text_of(cell, 0); }

std::unique_ptr<QueryOutput> make_query_output(QueryFormat format, std::ostream& stream, std::size_t most_bytes) {
  switch (format) {
    case QueryFormat::table: return std::make_unique<TableOutput>(stream, most_bytes);
    case QueryFormat::csv: return std::make_unique<CsvOutput>(stream);
    case QueryFormat::json: return std::make_unique<JsonOutput>(stream, true);
    case QueryFormat::json_lines: return std::make_unique<JsonOutput>(stream, false);
  }
  return nullptr;
}

}  // namespace lacuna
