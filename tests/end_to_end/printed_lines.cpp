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

/// What a program says of its own uncertainty differs with the last digits that it rests on: figures with theirs,
/// "+1108 ± 204", by that, which itself is no more than an estimate; probabilities by this much.
constexpr double kProbability = 0.15, kRare = 0.05;
const std::regex kEstimate("([+-]?[0-9]+(?:\\.[0-9]+)?) ± ([0-9]+(?:\\.[0-9]+)?)"),
    kProbabilityText("\\b([Pp] )([01]\\.[0-9]+)");
/// A line with such a figure ranks a model by what it leaves of the noise, which is as uncertain.
constexpr double kBesideAnEstimate = 0.3;
/// What chance reaches comes from draws.
constexpr double kByChance = 0.15;

bool close_estimates(const std::string& said, const std::string& printed) {
  std::sregex_iterator x(said.begin(), said.end(), kEstimate), y(printed.begin(), printed.end(), kEstimate), end;
  for (; x != end && y != end; ++x, ++y) {
    const double uncertainty = std::max(std::stod((*x)[2]), std::stod((*y)[2]));
    const double other = std::min(std::stod((*x)[2]), std::stod((*y)[2]));
    if (std::abs(std::stod((*x)[1]) - std::stod((*y)[1])) > uncertainty || uncertainty > 2.0 * other) return false;
  }
  return x == end && y == end;
}

bool close_probabilities(const std::string& said, const std::string& printed) {
  std::sregex_iterator x(said.begin(), said.end(), kProbabilityText),
      y(printed.begin(), printed.end(), kProbabilityText), end;
  for (; x != end && y != end; ++x, ++y) {
    const double a = std::stod((*x)[2]), b = std::stod((*y)[2]);
    if (std::abs(a - b) > kProbability || (a < kRare) != (b < kRare)) return false;
  }
  return x == end && y == end;
}

std::string without_uncertain(const std::string& line) {
  return std::regex_replace(std::regex_replace(line, kEstimate, "estimate"), kProbabilityText, "$1probability");
}

bool same_line(const std::string& said, const std::string& printed, double tolerance) {
  static const std::regex kNumber("[0-9]+(\\.[0-9]+)?");
  std::string a = comparable(said), b = comparable(printed);
  if (!close_estimates(a, b) || !close_probabilities(a, b)) return false;
  if (std::regex_search(a, kEstimate)) tolerance = std::max(tolerance, kBesideAnEstimate);
  if (a.starts_with("chance:")) tolerance = std::max(tolerance, kByChance);
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
