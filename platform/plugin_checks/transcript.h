#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// What the calls of a component gave, in their order, as numbers: what two goes are compared by, to the bit.
class Transcript {
 public:
  /// Which numbers are no fault of what gave them: finite ones alone, infinite ones too, NaN too.
  enum class May { be_finite, be_infinite, be_anything };

  /// `call`: a literal, as in "add_loads".
  void add(const char* call, std::span<const double> numbers, May may = May::be_finite);
  void add(const char* call, double number, May may = May::be_finite) { add(call, std::span(&number, 1), may); }
  void add_text(const char* call, std::string_view text);

  std::size_t size() const { return count_; }  ///< numbers, texts not counted
  /// The first call that gave a number that is none, or is infinite and may not be: "add_loads gave nan"; empty: none.
  const std::string& not_finite() const { return not_finite_; }
  /// Of all numbers' bits and all texts.
  std::string digest() const;
  /// The first call that gave something else; empty: none did.
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
