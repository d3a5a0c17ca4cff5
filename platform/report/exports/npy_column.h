#pragma once

#include "storage/queries/query.h"

#include <cstdint>
#include <string>

namespace lacuna {

/// What a column of cells is as an array of NumPy. All of its cells are shown to it before it is asked.
class NpyColumn {
 public:
  void see(const Cell& cell);

  /// The magic, the version and the description of an array of one dimension (NEP 1), up to the first number.
  std::string header() const;
  /// A cell as such an array has it, little-endian: whole numbers as int64 where nothing is missing, numbers as
  /// float64, NaN where one is missing, anything else as text of UCS-4, as long as the longest. Whole numbers beside
  /// missing ones or fractions are text where a float64 does not hold them.
  std::string bytes_of(const Cell& cell) const;

 private:
  enum class Type { whole, real, text };
  Type type() const;
  std::size_t longest() const;  ///< characters of a cell as text

  std::uint64_t count_ = 0;
  bool has_nothing_ = false, has_real_ = false, has_text_ = false, has_whole_ = false, has_long_whole_ = false;
  std::size_t longest_text_ = 0;  ///< characters
};

}  // namespace lacuna
