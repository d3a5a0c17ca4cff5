#pragma once

#include <lacuna/error.h>

#include "storage/core/statement.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace lacuna::test {

/// The integer that a query of one row answers.
inline std::int64_t ask(const Database& database, const char* sql) {
  Statement statement(database, sql);
  EXPECT_TRUE(statement.step());
  return statement.integer(0);
}

inline bool is_intact(const Database& database) {
  Statement check(database, "PRAGMA integrity_check");
  Statement keys(database, "PRAGMA foreign_key_check");
  return check.step() && check.text(0) == "ok" && !keys.step();
}

/// What an action complains of.
template <class Action>
std::string sentence_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace lacuna::test
