#include "report/exports/numpy_output.h"

#include "report/exports/column_spool.h"
#include "report/exports/npy_column.h"
#include "report/exports/zip_writer.h"

#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;  ///< bytes that are written at once

class NumpyOutput : public QueryOutput {
 public:
  NumpyOutput(std::ostream& stream, const Stop& stop) : stream_(stream), stop_(stop) {}

  void begin(const std::vector<std::string>& names) override {
    names_ = names;
    columns_.assign(names.size(), {});
    spool_.emplace(names.size(), ColumnSpool::kMostBytes, stop_);
  }

  void row(const std::vector<Cell>& cells) override {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      columns_[i].see(cells[i]);
      spool_->add(i, cells[i]);
    }
  }

  void end() override {
    ZipWriter archive(stream_);
    for (std::size_t i = 0; i < names_.size(); ++i)
      archive.add(names_[i] + ".npy", [&](const ZipWriter::Sink& sink) { write_array(i, sink); });
    archive.finish();
  }

 private:
  void write_array(std::size_t column, const ZipWriter::Sink& sink) {
    std::string piece = columns_[column].header();
    spool_->visit(column, [&](const Cell& cell) {
      piece += columns_[column].bytes_of(cell);
      if (piece.size() < kPiece) return;
      sink(piece);
      piece.clear();
    });
    sink(piece);
  }

  std::ostream& stream_;
  Stop stop_;
  std::vector<std::string> names_;
  std::vector<NpyColumn> columns_;
  std::optional<ColumnSpool> spool_;
};

}  // namespace

std::unique_ptr<QueryOutput> make_numpy_output(std::ostream& stream, const Stop& stop) {
  return std::make_unique<NumpyOutput>(stream, stop);
}

}  // namespace lacuna
