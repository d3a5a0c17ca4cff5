#include "measurement/names/column_words.h"

#include "measurement/names/column_lexicon.h"
#include "measurement/names/column_name.h"

#include <algorithm>
#include <cctype>

namespace lacuna {
namespace {

enum class CharacterKind { lower, upper, digit, other };

CharacterKind kind_of(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (std::isdigit(byte)) return CharacterKind::digit;
  if (std::isupper(byte)) return CharacterKind::upper;
  return std::isalpha(byte) || byte >= 0x80 ? CharacterKind::lower : CharacterKind::other;
}

bool starts_word(CharacterKind before, CharacterKind now) {
  if (before == now) return false;
  return !(before == CharacterKind::upper && now == CharacterKind::lower);  // "Angle" is one word
}

/// The kinds of words that occur. A letter counts less than a word.
class KindsOfWords {
 public:
  explicit KindsOfWords(const std::vector<std::string>& words) : words_(words) {}

  bool have(WordKind kind) const { return strong(kind) || weak(kind); }
  bool strong(WordKind kind) const { return any(kind, false); }
  bool weak(WordKind kind) const { return any(kind, true); }
  /// Whether they only number trials.
  bool number_trials() const {
    return have(WordKind::trial) && std::all_of(words_.begin(), words_.end(), [](const std::string& word) {
             const std::optional<WordKind> kind = kind_of_word(word);
             return kind == WordKind::trial || kind == WordKind::counter ||
                    std::isdigit(static_cast<unsigned char>(word.front()));
           });
  }

 private:
  bool any(WordKind kind, bool letter) const {
    return std::any_of(words_.begin(), words_.end(), [&](const std::string& word) {
      return (word.size() == 1) == letter && kind_of_word(word) == kind;
    });
  }
  const std::vector<std::string>& words_;
};

/// The quantity: a command, a velocity, a position or a time.
std::optional<ColumnRole> quantity_in(const KindsOfWords& words) {
  const bool moves = words.strong(WordKind::velocity) || words.strong(WordKind::position);
  if (words.strong(WordKind::effort) || words.strong(WordKind::voltage) || (!moves && words.strong(WordKind::current)))
    return ColumnRole::command;
  if (words.strong(WordKind::velocity)) return ColumnRole::velocity;
  if (words.strong(WordKind::position)) return ColumnRole::position;
  if (words.strong(WordKind::time)) return ColumnRole::time;
  if (words.weak(WordKind::current) || words.have(WordKind::input)) return ColumnRole::command;
  if (words.weak(WordKind::velocity)) return ColumnRole::velocity;
  if (words.weak(WordKind::position)) return ColumnRole::position;
  return words.have(WordKind::time) ? std::optional(ColumnRole::time) : std::nullopt;
}

/// "set", "point" → "setpoint".
void join_set_points(std::vector<std::string>& words) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i - 1] != "set" || (words[i] != "point" && words[i] != "value")) continue;
    words[i - 1] = "setpoint";
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> pieces;
  CharacterKind before = CharacterKind::other;
  for (const char c : name_without_unit(name)) {
    const CharacterKind now = kind_of(c);
    if (now != CharacterKind::other) {
      if (starts_word(before, now)) pieces.emplace_back();
      pieces.back() += c;
    }
    before = now;
  }
  std::vector<std::string> words;
  for (const std::string& piece : pieces)
    for (std::string& part : parts_of_compound(plain_letters(piece))) words.push_back(std::move(part));
  join_set_points(words);
  return words;
}

std::optional<ColumnRole> role_in_words(const std::vector<std::string>& words) {
  const KindsOfWords kinds(words);
  if (kinds.number_trials()) return ColumnRole::trial;
  if (kinds.have(WordKind::bystander)) return ColumnRole::other;
  if (kinds.have(WordKind::supply) && (kinds.strong(WordKind::voltage) || kinds.strong(WordKind::current)))
    return ColumnRole::other;
  const std::optional<ColumnRole> quantity = quantity_in(kinds);
  const bool moves = quantity == ColumnRole::velocity || quantity == ColumnRole::position;
  if (quantity && !moves) return quantity;
  if (kinds.have(WordKind::wanted)) return ColumnRole::reference;
  if (kinds.have(WordKind::ordered)) return moves ? ColumnRole::reference : ColumnRole::command;
  return quantity;
}

bool tell_measured(const std::vector<std::string>& words) { return KindsOfWords(words).have(WordKind::measured); }
bool tell_wanted(const std::vector<std::string>& words) {
  const KindsOfWords kinds(words);
  return kinds.have(WordKind::wanted) || kinds.have(WordKind::ordered);
}
bool name_a_quantity(const std::vector<std::string>& words) {
  const KindsOfWords kinds(words);
  return kinds.strong(WordKind::position) || kinds.strong(WordKind::velocity);
}
bool tell_velocity(const std::vector<std::string>& words) { return KindsOfWords(words).have(WordKind::velocity); }
bool tell_effort(const std::vector<std::string>& words) { return KindsOfWords(words).have(WordKind::effort); }
bool tell_voltage(const std::vector<std::string>& words) { return KindsOfWords(words).have(WordKind::voltage); }

std::optional<int> number_in(const std::vector<std::string>& words) {
  constexpr std::size_t kMostDigits = 6;
  const auto last = std::find_if(words.rbegin(), words.rend(), [](const std::string& word) {
    return std::all_of(word.begin(), word.end(), [](char c) { return std::isdigit(static_cast<unsigned char>(c)); });
  });
  if (last == words.rend() || last->empty() || last->size() > kMostDigits) return std::nullopt;
  return std::stoi(*last);
}

std::string joint_in_words(const std::vector<std::string>& words) {
  std::string joint;
  for (const std::string& word : words)
    if (!kind_of_word(word)) joint += (joint.empty() ? "" : "_") + word;
  return joint;
}

}  // namespace lacuna
