#include "app/terminal/output.h"

#include "foundation/text/problem.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Works in a folder of its own, as a command that begins there.
class OutputTest : public testing::Test {
 public:
  OutputTest() {
    fs::current_path(folder_.path());
    forget_command_files();
  }
  ~OutputTest() override {
    forget_command_files();
    fs::current_path(before_);
  }

 protected:
  /// What is said where results would go to `output` and `input` is read; empty: nothing.
  static std::string sentence(const std::string& output, const fs::path& input) {
    forget_command_files();
    try {
      check_output(output);
      refuse_outputs_among({input});
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }

 private:
  const fs::path before_ = fs::current_path();

 protected:
  const TestFolder folder_;
};

TEST_F(OutputTest, IsNoInputThatIsNotThereYet) {
  fs::create_directory("sub");
  fs::create_symlink("new.db", "dangling.db");
  const std::string whole = (folder_ / "new.db").string();
  for (const std::string& name : {std::string("new.db"), std::string("./new.db"), std::string("sub/../new.db"),
                                  std::string("dangling.db"), whole}) {
    EXPECT_THAT(sentence(name, "new.db"), HasSubstr("choose another file for the results")) << name;
    EXPECT_THAT(sentence("new.db", name), HasSubstr("choose another file for the results")) << name;
  }
  EXPECT_EQ(sentence("other.db", "new.db"), "");
}

TEST_F(OutputTest, IsNoLogOfADatabase) {
  fs::create_symlink("sub/new.db", "link.db");
  fs::create_directory("sub");
  for (const char* tail : {"-wal", "-shm", "-journal"}) {
    EXPECT_THAT(sentence(std::string("new.db") + tail, "new.db"), HasSubstr("has the name of a log of new.db")) << tail;
    EXPECT_THAT(sentence(std::string("sub/new.db") + tail, "link.db"), HasSubstr("log of link.db")) << tail;
  }
  EXPECT_EQ(sentence("new.db-json", "new.db"), "");
}

TEST_F(OutputTest, IsNoInputThatWasNamedBefore) {
  refuse_outputs_among({"new.db"});
  EXPECT_THROW(check_output("./new.db"), BadInput);
  EXPECT_THROW(check_output_folder("new.db"), BadInput);
  EXPECT_THROW(make_output_folder("new.db"), BadInput);
  EXPECT_THROW(file_for_picture("", "new.db"), BadInput);
  EXPECT_THROW(write_output("new.db", "text"), BadInput) << "although nobody checked it";
  EXPECT_FALSE(fs::exists("new.db"));
}

TEST_F(OutputTest, IsNamedByOneOptionOnly) {
  EXPECT_THROW(check_output("a.json", "./a.json"), BadInput);
  forget_command_files();
  check_output("a.json", "b.csv");
  EXPECT_THROW(check_output("./b.csv"), BadInput);
  EXPECT_THROW(check_output_folder("b.csv"), BadInput);
}

}  // namespace
}  // namespace lacuna
