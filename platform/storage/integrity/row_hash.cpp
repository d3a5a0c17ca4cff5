#include "storage/integrity/row_hash.h"

#include "foundation/digest.h"
#include "storage/integrity/row_key.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {

RowHash::RowHash(const Database& database, const TableOfRuns& table, const std::vector<std::string>& columns,
                 const std::vector<std::string>& key)
    : owner_(table.owner),
      row_(database, fmt::format("SELECT {} FROM {} WHERE {} ORDER BY {}", fmt::join(columns, ", "), table.name,
                                 rows_of_run(table), fmt::join(key, ", "))
                         .c_str()) {}

HashedRows RowHash::of(RunId run, const Stop& stop) {
  constexpr std::size_t kBlock = 1U << 20U;
  owner_ == RowOwner::key ? row_.with(key_base(run), last_key(run)) : row_.with(run);
  HashedRows content;
  if (!row_.step()) return content;
  Sha256 hash;
  std::string bytes;
  do {
    ++content.rows;
    for (int column = 0; column < row_.columns(); ++column) row_.append_bits(column, bytes);
    if (bytes.size() < kBlock) continue;
    stop.throw_if_requested();
    hash.add(bytes);
    bytes.clear();
  } while (row_.step());
  hash.add(bytes);
  content.sha256 = hash.hex();
  return content;
}

}  // namespace lacuna
