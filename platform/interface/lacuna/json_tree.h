#pragma once

#include <lacuna/value_tree.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace lacuna {

/// Reads one JSON value into a tree. In addition to JSON (RFC 8259), `NaN`, `Infinity` and `-Infinity` are numbers,
/// because some programs write them. true and false are 1 and 0.
class JsonTree {
 public:
  static constexpr std::size_t kDeepest = 64;

  /// The fault of `text`, half a sentence; empty: none. Views in the tree refer to `text`.
  std::string read(std::string_view text, ValueTree& tree) {
    begin_ = next_ = text.data();
    end_ = text.data() + text.size();
    fault_ = nullptr;
    tree.clear();
    skip_space();
    read_value({}, tree);
    skip_space();
    if (!fault_ && next_ != end_) fault_ = "text follows its end";
    if (!fault_) return {};
    return std::string(fault_) + " at character " + std::to_string(next_ - begin_ + 1);
  }

 private:
  bool fail(const char* fault) {
    if (!fault_) fault_ = fault;
    return false;
  }
  bool at_end() const { return next_ == end_; }
  void skip_space() {
    while (!at_end() && (*next_ == ' ' || *next_ == '\t' || *next_ == '\n' || *next_ == '\r')) ++next_;
  }
  bool take(char wanted) {
    skip_space();
    if (at_end() || *next_ != wanted) return false;
    ++next_;
    return true;
  }
  bool take_word(std::string_view word) {
    if (std::string_view(next_, static_cast<std::size_t>(end_ - next_)).substr(0, word.size()) != word) return false;
    next_ += word.size();
    return true;
  }

  bool read_value(std::string_view key, ValueTree& tree) {
    skip_space();
    if (at_end()) return fail("it ends too early");
    switch (*next_) {
      case '{': return read_object(key, tree);
      case '[': return read_list(key, tree);
      case '"': return read_text_value(key, tree);
      case 't': return read_word("true", key, 1.0, tree);
      case 'f': return read_word("false", key, 0.0, tree);
      case 'N': return read_word("NaN", key, std::numeric_limits<double>::quiet_NaN(), tree);
      case 'I': return read_word("Infinity", key, std::numeric_limits<double>::infinity(), tree);
      case 'n':
        if (!take_word("null")) return fail("a value is missing");
        tree.add_nothing(key);
        return true;
      default: return read_number(key, tree);
    }
  }

  bool read_word(std::string_view word, std::string_view key, double value, ValueTree& tree) {
    if (!take_word(word)) return fail("a value is missing");
    tree.add_number(key, value);
    return true;
  }

  bool read_text_value(std::string_view key, ValueTree& tree) {
    std::string_view text;
    if (!read_text(text, tree)) return false;
    tree.add_text(key, text);
    return true;
  }

  bool read_object(std::string_view key, ValueTree& tree) {
    if (tree.depth() == kDeepest) return fail("it is nested too deeply");
    ++next_;
    tree.begin(ValueTree::Kind::object, key);
    if (take('}')) return close(tree);
    do {
      if (!read_member(tree)) return false;
    } while (take(','));
    return take('}') ? close(tree) : fail("a comma or } is missing");
  }

  bool read_member(ValueTree& tree) {
    std::string_view name;
    skip_space();
    if (at_end() || *next_ != '"') return fail("a name in quotes is missing");
    if (!read_text(name, tree)) return false;
    return take(':') ? read_value(name, tree) : fail("a colon is missing");
  }

  bool read_list(std::string_view key, ValueTree& tree) {
    if (tree.depth() == kDeepest) return fail("it is nested too deeply");
    ++next_;
    tree.begin(ValueTree::Kind::list, key);
    if (take(']')) return close(tree);
    do {
      if (!read_value({}, tree)) return false;
    } while (take(','));
    return take(']') ? close(tree) : fail("a comma or ] is missing");
  }

  static bool close(ValueTree& tree) {
    tree.end();
    return true;
  }

  bool read_number(std::string_view key, ValueTree& tree) {
    const char* const start = next_;
    const bool is_negative = *next_ == '-';
    if (is_negative) ++next_;
    if (is_negative && take_word("Infinity")) {
      tree.add_number(key, -std::numeric_limits<double>::infinity());
      return true;
    }
    const char* const digits = next_;
    skip_digits();
    const auto count = next_ - digits;
    if (count == 0) return give_back(start, "a value is missing");
    if (count > 1 && *digits == '0') return give_back(start, "a number begins with 0");
    const char* const whole_end = next_;
    if (!at_end() && *next_ == '.') {
      ++next_;
      const char* const part = next_;
      skip_digits();
      if (next_ == part) return give_back(start, "a number ends with a decimal point");
    }
    const bool has_exponent = !at_end() && (*next_ == 'e' || *next_ == 'E');
    if (has_exponent && !skip_exponent()) return give_back(start, "a number has no exponent after its e");
    tree.add_number(key, number_of(start, whole_end, has_exponent, count > kFewestLongDigits));
    return true;
  }

  static constexpr std::ptrdiff_t kFewestLongDigits = 6;

  bool give_back(const char* start, const char* fault) {
    next_ = start;
    return fail(fault);
  }
  void skip_digits() {
    while (!at_end() && *next_ >= '0' && *next_ <= '9') ++next_;
  }
  bool skip_exponent() {
    ++next_;
    if (!at_end() && (*next_ == '+' || *next_ == '-')) ++next_;
    const char* const digits = next_;
    skip_digits();
    return next_ != digits;
  }

  /// From `start` to `next_`. A number with many digits before its point keeps all of them.
  LongNumber number_of(const char* start, const char* whole_end, bool has_exponent, bool is_long) const {
    LongNumber number;
    if (!has_exponent && (is_long || whole_end == next_) &&
        std::from_chars(start, whole_end, number.whole).ec == std::errc()) {
      if (whole_end == next_) return number;
      std::from_chars(whole_end, next_, number.part);
      if (*start == '-') number.part = -number.part;
      return number;
    }
    number.whole = 0;
    if (std::from_chars(start, next_, number.part).ec == std::errc()) return number;
    const std::string_view text(start, static_cast<std::size_t>(next_ - start));
    const std::size_t exponent = text.find_first_of("eE");
    const bool is_small = exponent != text.npos && text.substr(exponent + 1).starts_with('-');
    number.part = is_small ? 0.0 : std::numeric_limits<double>::infinity();
    return number;
  }

  bool read_text(std::string_view& text, ValueTree& tree) {
    const char* const start = ++next_;
    while (!at_end() && *next_ != '"' && *next_ != '\\') ++next_;
    if (at_end()) return fail("a text is not closed");
    if (*next_ == '"') {
      text = {start, static_cast<std::size_t>(next_++ - start)};
      return true;
    }
    std::string unescaped(start, next_);
    while (!at_end() && *next_ != '"')
      if (!read_character(unescaped)) return false;
    if (at_end()) return fail("a text is not closed");
    ++next_;
    text = tree.keep(std::move(unescaped));
    return true;
  }

  bool read_character(std::string& into) {
    if (*next_ != '\\') {
      into += *next_++;
      return true;
    }
    if (++next_ == end_) return fail("a text is not closed");
    constexpr std::string_view kNames = "\"\\/bfnrt", kMeant = "\"\\/\b\f\n\r\t";
    const char escape = *next_++;
    if (escape == 'u') return read_code_unit(into);
    const std::size_t known = kNames.find(escape);
    if (known == kNames.npos) return fail("a text has an unknown escape");
    into += kMeant[known];
    return true;
  }

  /// A code point beyond 0xffff is written as two code units; a single half becomes a question mark.
  bool read_code_unit(std::string& into) {
    unsigned code = 0;
    if (!read_hex(code)) return fail("a text has \\u without four hexadecimal digits");
    if (code >= 0xd800 && code < 0xdc00 && take_word("\\u")) {
      unsigned low = 0;
      if (!read_hex(low)) return fail("a text has \\u without four hexadecimal digits");
      code = low >= 0xdc00 && low < 0xe000 ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : '?';
    }
    if (code >= 0xd800 && code < 0xe000) code = '?';
    append_utf8(code, into);
    return true;
  }

  bool read_hex(unsigned& code) {
    if (end_ - next_ < 4) return false;
    const auto [stopped, error] = std::from_chars(next_, next_ + 4, code, 16);
    if (error != std::errc() || stopped != next_ + 4) return false;
    next_ += 4;
    return true;
  }

  static void append_utf8(unsigned code, std::string& into) {
    const auto byte = [&](unsigned value) { into += static_cast<char>(static_cast<unsigned char>(value)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
      byte(0xc0 | (code >> 6));
    } else {
      if (code < 0x10000) {
        byte(0xe0 | (code >> 12));
      } else {
        byte(0xf0 | (code >> 18));
        byte(0x80 | ((code >> 12) & 0x3f));
      }
      byte(0x80 | ((code >> 6) & 0x3f));
    }
    byte(0x80 | (code & 0x3f));
  }

  const char* begin_ = nullptr;
  const char* next_ = nullptr;
  const char* end_ = nullptr;
  const char* fault_ = nullptr;
};

}  // namespace lacuna
