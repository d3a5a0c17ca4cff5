#include "formula/formula_scanner.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

namespace lacuna {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }

/// Signs of other languages and of typesetting, and their replacements.
struct Mistake {
  std::string_view text, advice;
};
constexpr std::array<Mistake, 9> kMistakes = {{
    {"**", "write powers with ^, as in v^2"},
    {",", "write decimals with a point, as in 0.5"},
    {"|", "write the absolute value as abs(v)"},
    {"\u2212", "write minus as -"},
    {"\u2013", "write minus as -"},
    {"\u00b7", "write products with *"},
    {"\u00d7", "write products with *"},
    {"\u00b2", "write squares as ^2"},
    {"=", "give the right-hand side alone: the force on the joint"},
}};

class Scanner {
 public:
  Scanner(const std::string& text, ProblemList& problems) : text_(text), problems_(problems) {}

  std::vector<FormulaToken> scan() {
    while (at_ < text_.size()) next();
    tokens_.push_back({FormulaToken::Kind::end, "", 0.0, column()});
    return tokens_;
  }

 private:
  int column() const { return static_cast<int>(at_) + 1; }

  void next() {
    const char c = text_[at_];
    if (std::isspace(static_cast<unsigned char>(c)))
      ++at_;
    else if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1])))
      number();
    else if (begins_name(c))
      name();
    else if (!mistake())
      sign(c);
  }

  void number() {
    double value = 0.0;
    const char* begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    const std::string word(begin, end);
    if (error != std::errc{} || !std::isfinite(value))
      problems_.add(formula_place(column()), "\"" + word + "\" is outside the range of numbers");
    tokens_.push_back({FormulaToken::Kind::number, word, value, column()});
    at_ += word.size();
  }

  void name() {
    std::size_t end = at_;
    while (end < text_.size() && (begins_name(text_[end]) || is_digit(text_[end]))) ++end;
    tokens_.push_back({FormulaToken::Kind::name, text_.substr(at_, end - at_), 0.0, column()});
    at_ = end;
  }

  bool mistake() {
    for (const auto& [text, advice] : kMistakes) {
      if (!std::string_view(text_).substr(at_).starts_with(text)) continue;
      problems_.add(formula_place(column()),
                    "\"" + std::string(text) + "\" is not allowed in a formula; " + std::string(advice));
      at_ += text.size();
      return true;
    }
    return false;
  }

  void sign(char c) {
    if (std::string_view("+-*/^()").find(c) != std::string_view::npos) {
      tokens_.push_back({FormulaToken::Kind::sign, std::string(1, c), 0.0, column()});
      ++at_;
      return;
    }
    std::size_t end = at_ + 1;  // a character outside of ASCII is several bytes
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0) == 0x80) ++end;
    problems_.add(formula_place(column()),
                  "\"" + text_.substr(at_, end - at_) + "\" is not allowed in a formula; known are + - * / ^ ( )");
    at_ = end;
  }

  const std::string& text_;
  ProblemList& problems_;
  std::size_t at_ = 0;
  std::vector<FormulaToken> tokens_;
};

}  // namespace

SourceLocation formula_place(int column) { return {"--formula", 1, column}; }

std::vector<FormulaToken> scan_formula(const std::string& text, ProblemList& problems) {
  return Scanner(text, problems).scan();
}

}  // namespace lacuna
