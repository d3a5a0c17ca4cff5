#pragma once

#include <stdexcept>
#include <string>

namespace lacuna {

/// What every part of Lacuna throws when it cannot do its work. The message is a
/// sentence for the user: where, what is wrong, and what to do about it.
class __attribute__((visibility("default"))) Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace lacuna
