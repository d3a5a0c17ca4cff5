#include "measurement/names/header_names.h"

#include "measurement/names/column_lexicon.h"
#include "measurement/names/column_name.h"
#include "measurement/names/column_words.h"
#include "measurement/cells/number_cell.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

namespace lacuna {
namespace {

constexpr std::string_view kRunWords[] = {"data set",  "dataset", "run",   "trial",  "lauf",   "versuch", "messung",
                                          "messreihe", "essai",   "prova", "ensayo", "series", "serie"};
constexpr std::string_view kNewest = "latest: ";
constexpr std::string_view kBetween = " \t_/.:-|,;#()[]";  ///< words
constexpr std::string_view kBeforeNumber = " #_-.";

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_between(char c) { return kBetween.find(c) != kBetween.npos; }

std::string_view without_ends(std::string_view text) {
  while (!text.empty() && is_between(text.front()) && text.front() != '(' && text.front() != '[') text.remove_prefix(1);
  while (!text.empty() && is_between(text.back()) && text.back() != ')' && text.back() != ']') text.remove_suffix(1);
  return text;
}

/// Where "Run #1" begins at the end of a lower-case name, including brackets around it; npos: nowhere.
std::size_t run_at_end(std::string_view name) {
  std::string_view rest = name;
  const bool bracketed = rest.ends_with(')') || rest.ends_with(']');
  if (bracketed) rest.remove_suffix(1);
  const std::size_t with_number = rest.size();
  while (!rest.empty() && is_digit(rest.back())) rest.remove_suffix(1);
  if (rest.size() == with_number) return name.npos;
  while (!rest.empty() && kBeforeNumber.find(rest.back()) != kBeforeNumber.npos) rest.remove_suffix(1);
  for (const std::string_view word : kRunWords) {
    if (!rest.ends_with(word)) continue;
    const std::size_t at = rest.size() - word.size();
    if (at == 0 || !is_between(rest[at - 1])) continue;
    return bracketed && (rest[at - 1] == '(' || rest[at - 1] == '[') ? at - 1 : at;
  }
  return name.npos;
}

/// Where a lower-case name continues after "Run 1: ", or "Latest: " as Logger Pro calls the newest one; 0: it does not
/// begin so.
std::size_t run_at_start(std::string_view name) {
  for (const std::string_view word : kRunWords) {
    if (!name.starts_with(word)) continue;
    std::size_t at = word.size();
    while (at < name.size() && kBeforeNumber.find(name[at]) != kBeforeNumber.npos) ++at;
    const std::size_t number = at;
    while (at < name.size() && is_digit(name[at])) ++at;
    if (at == number || at == name.size() || !is_between(name[at])) continue;
    while (at < name.size() && is_between(name[at]) && name[at] != '(' && name[at] != '[') ++at;
    return at == name.size() ? 0 : at;
  }
  return name.starts_with(kNewest) && name.size() > kNewest.size() ? kNewest.size() : 0;
}

std::string in_lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

struct Meaning {
  std::optional<ColumnRole> role;
  std::string unit;
};

Meaning meaning_of(const std::string& name) { return {role_in_words(words_of(name)), unit_in_name(name)}; }

bool says_as_much(const std::string& shorter, const std::string& longer) {
  if (std::none_of(shorter.begin(), shorter.end(), [](char c) { return !is_between(c); })) return false;
  const Meaning now = meaning_of(shorter), before = meaning_of(longer);
  return (now.unit == before.unit || before.unit.empty()) &&
         (!before.role || before.role == ColumnRole::trial || now.role == before.role);
}

/// Whether a name means only the time.
bool is_bare_time(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return !words.empty() && std::all_of(words.begin(), words.end(),
                                       [](const std::string& word) { return kind_of_word(word) == WordKind::time; });
}

/// Number of characters with which all names begin, up to the end of a separator.
std::size_t shared_beginning(const std::vector<std::string>& names) {
  std::string_view shared = names.front();
  for (const std::string_view name : names) {
    const auto differ = std::mismatch(shared.begin(), shared.end(), name.begin(), name.end());
    shared = shared.substr(0, static_cast<std::size_t>(differ.first - shared.begin()));
  }
  while (!shared.empty() && (!is_between(shared.back()) || shared.back() == '(' || shared.back() == '['))
    shared.remove_suffix(1);
  return shared.size();
}

std::string reversed(std::string text) {
  std::reverse(text.begin(), text.end());
  return text;
}

/// Removes words shared by `count` of the names, if no name loses information.
void shorten(std::vector<std::string>& names, const std::vector<std::size_t>& which, std::size_t count, bool at_end) {
  if (count == 0) return;
  std::vector<std::string> shorter = names;
  for (const std::size_t i : which) {
    const std::string_view name = names[i];
    shorter[i] = at_end ? name.substr(0, name.size() - count) : name.substr(count);
    if (!says_as_much(shorter[i], names[i])) return;
  }
  names = std::move(shorter);
}

}  // namespace

CoreName name_and_run(const std::string& written) {
  const std::string name(trimmed(written)), lower = in_lower_case(name);
  if (const std::size_t at = run_at_end(lower); at != lower.npos)
    if (const std::string_view rest = without_ends(std::string_view(name).substr(0, at)); !rest.empty())
      return {std::string(rest), std::string(without_ends(std::string_view(name).substr(at)))};
  if (const std::size_t at = run_at_start(lower); at > 0)
    return {name.substr(at), std::string(without_ends(std::string_view(name).substr(0, at)))};
  return {name, ""};
}

std::vector<CoreName> core_names(const std::vector<std::string>& names) {
  std::vector<CoreName> cores;
  for (const std::string& name : names) cores.push_back(name_and_run(name));
  std::vector<std::string> texts;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < cores.size(); ++i) {
    texts.push_back(cores[i].text);
    if (!texts.back().empty() && !is_bare_time(texts.back())) all.push_back(i);
  }
  if (all.size() < 2) return cores;
  std::vector<std::string> shared;
  for (const std::size_t i : all) shared.push_back(texts[i]);
  shorten(texts, all, shared_beginning(shared), false);
  for (std::size_t k = 0; k < all.size(); ++k) shared[k] = reversed(texts[all[k]]);
  shorten(texts, all, shared_beginning(shared), true);
  for (std::size_t i = 0; i < cores.size(); ++i) cores[i].text = texts[i];
  return cores;
}

}  // namespace lacuna
