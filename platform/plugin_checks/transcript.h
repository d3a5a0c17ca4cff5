#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// The results of a component's calls, in their order, as numbers: two runs are compared by them, bit by bit.
class Transcript {
 public:
  /// Which numbers are allowed: only finite ones, infinite ones too, NaN too.
  enum class May { be_finite, be_infinite, be_anything };

  /// `call`: a literal, as in "add_loads".
  void add(const char* call, std::span<const double> numbers, May may = May::be_finite);
  void add(const char* call, double number, May may = May::be_finite) { add(call, std::span(&number, 1), may); }
  void add_text(const char* call, std::string_view text);

  std::size_t size() const { return count_; }  ///< number of numbers, without texts
  /// The first call that returned NaN, or an infinite number where none is allowed: "add_loads returned NaN"; empty:
  /// none.
  const std::string& not_finite() const { return not_finite_; }
  /// Over all bits of numbers and all texts.
  std::string digest() const;
  /// The first call with a different result; empty: none.
  static std::string first_difference(const Transcript& a, const Transcript& b);

 private:
  struct Entry {
    const char* call;
    std::string bytes;
  };

  std::vector<Entry> entries_;
  std::size_t count_ = 0;
  std::string not_finite_;
};

}  // namespace lacuna
