#pragma once

#include "foundation/processes/stop.h"
#include "storage/queries/query.h"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// Keeps the cells of rows until they are wanted column by column. A column's cells stay in memory up to `most_bytes`;
/// beyond that they go into a temporary file, which ends with the object.
class ColumnSpool {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{1} << 18;

  explicit ColumnSpool(std::size_t columns, std::size_t most_bytes = kMostBytes, const Stop& stop = {});
  ~ColumnSpool();

  /// Throws `Error` where the temporary file takes no more, and `Interrupted`.
  void add(std::size_t column, const Cell& cell);
  /// The cells of a column in the order in which they came; as often as it is asked for. Of bytes there is the text
  /// that stands for them.
  void visit(std::size_t column, const std::function<void(const Cell&)>& visit);

 private:
  struct Extent {
    std::int64_t place = 0;
    std::size_t size = 0;
  };
  struct Column {
    std::string waiting;          ///< cells that are in no file
    std::vector<Extent> written;  ///< pieces of whole cells
  };
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void write_out(Column& column);

  std::vector<Column> columns_;
  std::size_t most_bytes_;
  Stop stop_;
  std::unique_ptr<std::FILE, Close> file_;
  std::int64_t end_ = 0;  ///< of the file, bytes
};

}  // namespace lacuna
