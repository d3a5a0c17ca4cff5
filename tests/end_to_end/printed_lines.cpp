#include "end_to_end/printed_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>

namespace lacuna {
namespace {

const std::string kAnything = "…";

/// A line without what may differ: bars, the time that a fit or a run took, the hash of a run (the tests of `lacuna
/// hash` compare those), and the width of a table's columns.
std::string comparable(const std::string& line) {
  static const std::regex kBar("(█|▉|▊|▋|▌|▍|▎|▏)+"), kSeconds("(fitted [0-9]+ values?), [0-9.]+ m?s\\b"),
      kDuration("· ([0-9]+ (h|min) )?[0-9.]+ (s|min)(?= ·|$)"), kShare("storage [0-9.]+ %"), kHash("[0-9a-f]{64}"),
      kBlanks("\\s+"), kRule("-{3,}");
  std::string text = std::regex_replace(line, kBar, "");
  text = std::regex_replace(text, kSeconds, "$1");
  text = std::regex_replace(text, kDuration, "· time");
  text = std::regex_replace(text, kShare, "storage share");
  text = std::regex_replace(text, kHash, "hash");
  text = std::regex_replace(text, kRule, "---");
  text = std::regex_replace(text, kBlanks, " ");
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// One unit of the last digit that `number` shows.
double last_digit(const std::string& number) {
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 1.0 : std::pow(10.0, -static_cast<double>(number.size() - point - 1));
}

bool close(const std::string& said, const std::string& printed, double tolerance) {
  const double a = std::stod(said), b = std::stod(printed);
  return std::abs(a - b) <= std::max({tolerance * std::abs(a), tolerance * std::abs(b), 1.001 * last_digit(said)});
}

/// Last digits differ from processor to processor, and with them what rests on many of them, by less than this: figures
/// with their uncertainty, "+1108 ± 204", by a quarter of it and it by a fifth, others in their line and what chance
/// reaches by a tenth, probabilities that a verdict is right by their last digit, chances (p) by a tenth. A figure
/// of another version of the program differs by more.
constexpr double kOfUncertainty = 0.25, kUncertainty = 1.2, kBesideAnEstimate = 0.1, kChance = 0.1;
const std::regex kEstimate("([+-]?[0-9]+(?:\\.[0-9]+)?) ± ([0-9]+(?:\\.[0-9]+)?)"),
    kProbability("\\b(probability|p) ([01]\\.[0-9]+)"), kFall("−([0-9]+(?:\\.[0-9]+)?) %");

/// Whether two lines have as many such figures, each close to the other's.
template <class Close>
bool all_close(const std::string& said, const std::string& printed, const std::regex& figure, const Close& is_close) {
  std::sregex_iterator x(said.begin(), said.end(), figure), y(printed.begin(), printed.end(), figure), end;
  for (; x != end && y != end; ++x, ++y)
    if (!is_close(*x, *y)) return false;
  return x == end && y == end;
}

bool close_estimates(const std::smatch& a, const std::smatch& b) {
  const double more = std::max(std::stod(a[2]), std::stod(b[2])), less = std::min(std::stod(a[2]), std::stod(b[2]));
  return std::abs(std::stod(a[1]) - std::stod(b[1])) <= std::max(kOfUncertainty * more, last_digit(a[1])) &&
         more <= std::max(kUncertainty * less, less + last_digit(a[2]));
}

bool close_probabilities(const std::smatch& a, const std::smatch& b) {
  return a[1] == b[1] && close(a[2], b[2], a[1] == "p" ? kChance : 0.0);
}

/// By what is left of an error: 5.7 % and 9.0 % are not close, although −94.3 % and −91.0 % are.
bool close_falls(const std::smatch& a, const std::smatch& b, double tolerance) {
  const double x = 100.0 - std::stod(a[1]), y = 100.0 - std::stod(b[1]);
  return std::abs(x - y) <= std::max(tolerance * std::max(std::abs(x), std::abs(y)), 1.001 * last_digit(a[1]));
}

std::string without_uncertain(std::string line) {
  line = std::regex_replace(line, kEstimate, "estimate");
  line = std::regex_replace(line, kProbability, "$1 probability");
  return std::regex_replace(line, kFall, "fall");
}

bool same_line(const std::string& said, const std::string& printed, double tolerance) {
  static const std::regex kNumber("[0-9]+(\\.[0-9]+)?");
  std::string a = comparable(said), b = comparable(printed);
  if (!all_close(a, b, kEstimate, close_estimates) || !all_close(a, b, kProbability, close_probabilities)) return false;
  if (!all_close(a, b, kFall, [&](const auto& x, const auto& y) { return close_falls(x, y, tolerance); })) return false;
  if (std::regex_search(a, kEstimate)) tolerance = std::max(tolerance, kBesideAnEstimate);
  if (a.starts_with("chance:")) tolerance = std::max(tolerance, kChance);
  a = without_uncertain(a);
  b = without_uncertain(b);
  if (std::regex_replace(a, kNumber, "#") != std::regex_replace(b, kNumber, "#")) return false;
  std::sregex_iterator x(a.begin(), a.end(), kNumber), y(b.begin(), b.end(), kNumber), end;
  for (; x != end && y != end; ++x, ++y)
    if (!close(x->str(), y->str(), tolerance)) return false;
  return true;
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string difference(const std::vector<std::string>& said, const std::vector<std::string>& printed,
                       double tolerance) {
  std::size_t at = 0;
  bool any = false;
  for (const std::string& line : said) {
    if (line == kAnything) {
      any = true;
      continue;
    }
    while (any && at < printed.size() && !same_line(line, printed[at], tolerance)) ++at;
    any = false;
    if (at == printed.size()) return "is not printed: " + line;
    if (!same_line(line, printed[at], tolerance)) return "said:    " + line + "\nprinted: " + printed[at];
    ++at;
  }
  return any || at == printed.size() ? "" : "is printed too: " + printed[at];
}

}  // namespace lacuna
