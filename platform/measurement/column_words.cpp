#include "measurement/column_words.h"

#include "measurement/column_name.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace lacuna {
namespace {

struct RoleWords {
  ColumnRole role;
  std::vector<std::string_view> words;
};

/// In the order in which they count.
const std::array<RoleWords, 6>& role_words() {
  static const std::array<RoleWords, 6> kRoles{{
      {ColumnRole::trial, {"trial", "run", "episode", "experiment", "segment", "repetition", "rep", "versuch"}},
      {ColumnRole::reference, {"ref", "reference", "des", "desired", "setpoint", "goal", "target", "soll"}},
      {ColumnRole::command,
       {"tau", "torque", "effort", "force", "u", "cmd", "command", "current", "i", "voltage", "volt", "vir", "pwm",
        "duty", "moment", "input", "drive"}},
      {ColumnRole::velocity,
       {"dot", "qd", "dq", "qdot", "vel", "velocity", "omega", "speed", "rate", "w", "dtheta", "v", "rpm", "gyro"}},
      {ColumnRole::position,
       {"q", "qm", "pos", "position", "angle", "theta", "phi", "alpha", "psi", "x", "y", "z", "encoder", "enc",
        "displacement", "winkel"}},
      {ColumnRole::time,
       {"t", "time", "timestamp", "stamp", "zeit", "clock", "sec", "secs", "seconds", "ms", "us", "millis", "micros"}},
  }};
  return kRoles;
}

/// Words that often stand in names and tell nothing.
constexpr std::string_view kFillers[] = {"motor", "joint",  "meas",  "measured", "actual", "act",
                                         "raw",   "sensor", "value", "m",        "data",   "signal"};

bool has(const std::vector<std::string_view>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

enum class Kind { lower, upper, digit, other };

Kind kind_of(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (std::isdigit(byte)) return Kind::digit;
  if (std::isupper(byte)) return Kind::upper;
  return std::isalpha(byte) ? Kind::lower : Kind::other;
}

bool starts_word(Kind before, Kind now) {
  if (before == now) return false;
  return !(before == Kind::upper && now == Kind::lower);  // "Angle" is one word
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  Kind before = Kind::other;
  for (const char c : name_without_unit(name)) {
    const Kind now = kind_of(c);
    if (now != Kind::other) {
      if (starts_word(before, now)) words.emplace_back();
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    before = now;
  }
  return words;
}

std::optional<ColumnRole> role_in_words(const std::vector<std::string>& words) {
  for (const RoleWords& role : role_words())
    for (const std::string& word : words)
      if (has(role.words, word)) return role.role;
  return std::nullopt;
}

std::string joint_in_words(const std::vector<std::string>& words) {
  std::string joint;
  for (const std::string& word : words) {
    const bool known = std::any_of(role_words().begin(), role_words().end(),
                                   [&](const RoleWords& role) { return has(role.words, word); });
    const bool filler = std::find(std::begin(kFillers), std::end(kFillers), word) != std::end(kFillers);
    if (!known && !filler) joint += (joint.empty() ? "" : "_") + word;
  }
  return joint;
}

}  // namespace lacuna
