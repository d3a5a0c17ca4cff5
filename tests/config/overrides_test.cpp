#include "config/overrides.h"

#include "config/toml/toml_parser.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr const char* kText = "[engine]\nstep = 0.001\n[model]\neffects = [{ id = \"a\" }]\n";

TomlNode with(const std::vector<std::string>& overrides) {
  TomlNode tree = parse_toml(kText, "f.toml");
  ProblemList problems;
  apply_overrides(tree, overrides, problems);
  problems.throw_if_any();
  return tree;
}

std::string complaint_about(const std::string& override) {
  try {
    with({override});
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "no complaint_about";
}

TEST(Overrides, ReplaceAndAddValues) {
  const TomlNode tree =
      with({"engine.step=1", "engine.step=2", "fit.starts=3", "model.effects[0].start.\"p.q\"=[1, 2]"});
  EXPECT_EQ(tree.find("engine")->find("step")->integer, 2);
  EXPECT_EQ(tree.find("fit")->find("starts")->integer, 3);
  EXPECT_EQ(tree.find("model")->find("effects")->items[0].find("start")->find("p.q")->items.size(), 2U);
}

TEST(Overrides, TakeWhatIsNoTomlAsText) {
  EXPECT_EQ(with({"model.robot=my-robot"}).find("model")->find("robot")->text, "my-robot");
  EXPECT_EQ(with({"engine.step=2 ms"}).find("engine")->find("step")->text, "2 ms");
  EXPECT_EQ(with({"a=x=y"}).find("a")->text, "x=y");
}

TEST(Overrides, SayWhatIsWrongWithThem) {
  EXPECT_THAT(complaint_about("engine.step"), HasSubstr("--set engine.step: write KEY=VALUE"));
  EXPECT_THAT(complaint_about("=3"), HasSubstr("a key is empty"));
  EXPECT_THAT(complaint_about("engine..step=3"), HasSubstr("a key is empty"));
  EXPECT_THAT(complaint_about("engine.step.x=3"), HasSubstr("\"x\" does not follow a table, but a number"));
  EXPECT_THAT(complaint_about("model.effects[1].id=b"), HasSubstr("there is no item [1]; the list has 1"));
  EXPECT_THAT(complaint_about("model.effects[x]=b"), HasSubstr("write an index as a number"));
  EXPECT_THAT(complaint_about("engine[0]=b"), HasSubstr("[0] does not follow a list"));
  EXPECT_THAT(complaint_about("engine.step=\"x"), HasSubstr("is not a TOML value"));
  EXPECT_THAT(complaint_about("engine.step=1\nx = 2"), HasSubstr("is not a TOML value"));
}

}  // namespace
}  // namespace lacuna
