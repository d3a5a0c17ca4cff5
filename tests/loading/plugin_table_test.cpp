#include "loading/plugin_table.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

void* make_nothing() { return nullptr; }

/// A table as `LACUNA_PLUGIN` writes it, to be spoilt.
class Table : public testing::Test {
 protected:
  Table() {
    std::copy(std::begin(kPluginMagic), std::end(kPluginMagic), table_.magic);
    table_.interface_version = kInterfaceVersion;
    table_.table_size = sizeof(PluginTable);
    table_.compiler = LACUNA_COMPILER;
    table_.standard_library = LACUNA_STANDARD_LIBRARY;
    table_.layouts = layouts_.data();
    table_.layout_count = layouts_.size();
    table_.components = &component_;
    table_.component_count = 1;
  }
  std::vector<TypeLayout> layouts_{std::begin(kInterfaceLayouts), std::end(kInterfaceLayouts)};
  ComponentEntry component_{"physical_effect", "drag", &make_nothing};
  PluginTable table_{};
};

TEST_F(Table, OfThisBuildIsAccepted) { EXPECT_THAT(table_problem(&table_), IsEmpty()); }

TEST_F(Table, NoneOrOneWithoutMagicIsRefused) {
  EXPECT_THAT(table_problem(nullptr), HasSubstr("no plugin table"));
  table_.magic[0] = 'X';
  EXPECT_THAT(table_problem(&table_), HasSubstr("no plugin table"));
}

TEST_F(Table, OfAnotherVersionIsReadNoFurther) {
  table_.interface_version = kInterfaceVersion + 1;
  table_.compiler = reinterpret_cast<const char*>(1);
  EXPECT_THAT(table_problem(&table_),
              AllOf(HasSubstr("version " + std::to_string(kInterfaceVersion + 1)), HasSubstr("build it again")));
}

TEST_F(Table, OfAnotherCompilerOrLibraryIsRefused) {
  table_.compiler = "g++ 4";
  EXPECT_THAT(table_problem(&table_), HasSubstr("compiler \"g++ 4\""));
  table_.compiler = LACUNA_COMPILER;
  table_.standard_library = nullptr;
  EXPECT_THAT(table_problem(&table_), HasSubstr("standard library \"\""));
}

TEST_F(Table, NamesTheTypeThatIsLaidOutDifferently) {
  const auto robot = std::find_if(layouts_.begin(), layouts_.end(),
                                  [](const TypeLayout& layout) { return std::string(layout.type) == "RobotSpec"; });
  ASSERT_NE(robot, layouts_.end());
  robot->size += 8;
  EXPECT_THAT(table_problem(&table_), HasSubstr("RobotSpec in " + std::to_string(sizeof(RobotSpec) + 8)));
}

TEST_F(Table, NamesTheTypeThatIsNotDeclared) {
  table_.layout_count -= 1;
  EXPECT_THAT(table_problem(&table_), HasSubstr(kInterfaceLayouts[std::size(kInterfaceLayouts) - 1].type));
}

TEST_F(Table, ComponentsNeedAKnownKindANameAndAFactory) {
  component_.kind = "physical_efect";
  EXPECT_THAT(table_problem(&table_), HasSubstr("unknown kind \"physical_efect\""));
  component_ = {"physical_effect", "Air Drag", &make_nothing};
  EXPECT_THAT(table_problem(&table_), HasSubstr("lower-case"));
  component_ = {"physical_effect", "drag", nullptr};
  EXPECT_THAT(table_problem(&table_), HasSubstr("no factory"));
  table_.component_count = 0;
  EXPECT_THAT(table_problem(&table_), HasSubstr("no components"));
}

}  // namespace
}  // namespace lacuna
