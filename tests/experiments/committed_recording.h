#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

/// Recordings that lie in experiments/data/ are those that their generators write.
namespace bench {

/// Compares experiments/data/FOLDER/TRIAL.csv with the text that generate_FOLDER makes of it, line by line.
inline void expect_committed(const std::string& folder, const std::string& trial, const std::string& text) {
  const std::string file = LACUNA_SOURCE_DIRECTORY "/experiments/data/" + folder + "/" + trial + ".csv";
  std::ifstream committed(file);
  ASSERT_TRUE(committed) << file;
  std::istringstream generated(text);
  std::string expected, found;
  for (int line = 1; std::getline(generated, expected); ++line) {
    ASSERT_TRUE(std::getline(committed, found)) << file << " ends before line " << line;
    ASSERT_EQ(found, expected) << file << ":" << line << "; write it again with generate_" << folder;
  }
  EXPECT_FALSE(std::getline(committed, found)) << file << " goes on after its end";
}

}  // namespace bench
