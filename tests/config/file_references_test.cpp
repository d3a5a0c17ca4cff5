#include "config/file_references.h"

#include "config/toml/text_file.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(FileReferences, AreThoseThatTheDeclarationsOfKeysGive) {
  for (const std::string& name : file_reference_names())
    EXPECT_EQ(read_text_file(LACUNA_SOURCE_DIRECTORY "/schema/" + name), file_reference(name))
        << "write it anew: lacuna check --print-reference " << name << " > schema/" << name;
}

}  // namespace
}  // namespace lacuna
