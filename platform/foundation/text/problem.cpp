#include "foundation/text/problem.h"

#include "foundation/text/plain_text.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace lacuna {
namespace {

std::string one_line_each(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    const std::string where = to_string(problem.location);
    const std::string message = plain_text(problem.message);
    if (!where.empty()) text.append(where).append(": ");
    text += message;
  }
  return text;
}

/// Insertions, deletions, substitutions and swaps of neighbours (optimal string alignment).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U), last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

/// "joint" of "joint.hinge"; empty of a name without a point.
std::string kind_of(const std::string& name) {
  const std::size_t point = name.find('.');
  return point == std::string::npos ? std::string() : name.substr(0, point);
}

constexpr std::size_t kShortestPart = 3;  // letters; shorter words occur in too many others

/// Whether `word` is the beginning or the end of `candidate`, set off by a point or an underscore.
bool is_part(const std::string& word, const std::string& candidate) {
  if (word.size() < kShortestPart || word.size() >= candidate.size()) return false;
  const auto separates = [](char c) { return c == '.' || c == '_'; };
  return (candidate.starts_with(word) && separates(candidate[word.size()])) ||
         (candidate.ends_with(word) && separates(candidate[candidate.size() - word.size() - 1]));
}

}  // namespace

std::string to_string(const SourceLocation& location) {
  std::string text = plain_text(location.file);
  if (location.line > 0) text += ":" + std::to_string(location.line);
  if (location.line > 0 && location.column > 0) text += ":" + std::to_string(location.column);
  return text;
}

BadInput::BadInput(std::vector<Problem> problems) : Error(one_line_each(problems)), problems_(std::move(problems)) {}

void ProblemList::add(Problem problem) {
  if (told_.emplace(to_string(problem.location), problem.message).second) problems_.push_back(std::move(problem));
}

void ProblemList::add_of_key(SourceLocation location, const std::string& key, const std::string& message,
                             const std::string& reason) {
  add(Problem{std::move(location), key.empty() ? message : key + ": " + message, key, reason});
}

void ProblemList::throw_if_any() const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.location.file, a.location.line, a.location.column) <
           std::tie(b.location.file, b.location.line, b.location.column);
  });
  throw BadInput(std::move(sorted));
}

void throw_problem(SourceLocation location, std::string message) {
  std::vector<Problem> problems;
  problems.push_back({std::move(location), std::move(message)});
  throw BadInput(std::move(problems));
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string* nearest = nullptr;
  std::size_t smallest = word.size() < 2 ? 1 : std::max<std::size_t>(word.size() / 3, 1) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= smallest) continue;
    smallest = distance;
    nearest = &candidate;
  }
  for (const std::string& candidate : candidates)
    if (nearest == nullptr && is_part(word, candidate)) nearest = &candidate;
  return nearest ? " (did you mean \"" + *nearest + "\"?)" : "";
}

std::string nearest_names(const std::string& word, std::vector<std::string> names) {
  const std::size_t all = names.size();
  if (all > kMostNearest) {
    std::vector<std::tuple<bool, std::size_t, std::string>> ranked;
    for (std::string& name : names)
      ranked.emplace_back(kind_of(name) != kind_of(word), edit_distance(word, name), std::move(name));
    std::sort(ranked.begin(), ranked.end());
    names.clear();
    for (std::size_t i = 0; i < kMostNearest; ++i) names.push_back(std::get<2>(ranked[i]));
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return all > kMostNearest ? text + " and " + std::to_string(all - kMostNearest) + " more" : text;
}

}  // namespace lacuna
