#include "storage/made_up_run.h"
#include "storage/queries/query.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace lacuna {
namespace {

/// What schema/database.md, or another text, says.
struct Documentation {
  std::map<std::string, std::vector<std::string>> columns;    ///< of each view and table, in their order
  std::map<std::string, std::vector<std::string>> sentences;  ///< lines of text under each heading
  std::map<std::string, std::vector<std::string>> examples;   ///< SQL blocks under each heading
};

std::string between(const std::string& line, const std::string& before, const std::string& after) {
  if (!line.starts_with(before)) return "";
  return line.substr(before.size(), line.find(after, before.size()) - before.size());
}

Documentation read_documentation(const std::string& document) {
  std::ifstream file(LACUNA_SOURCE_DIRECTORY "/" + document);
  Documentation documentation;
  std::string heading;
  bool in_example = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "```sql") {
      in_example = true;
      documentation.examples[heading].emplace_back();
    } else if (line.starts_with("```")) {
      in_example = false;
    } else if (in_example) {
      documentation.examples[heading].back() += line + '\n';
    } else if (const std::string name = between(line, "### `", "`"); !name.empty()) {
      heading = name;
    } else if (const std::string column = between(line, "| `", "`"); !column.empty()) {
      documentation.columns[heading].push_back(column);
    } else {
      documentation.sentences[heading].push_back(line);
    }
  }
  return documentation;
}

/// Keeps everything, as text.
class Rows : public QueryOutput {
 public:
  void begin(const std::vector<std::string>&) override { counts.push_back(0); }
  void row(const std::vector<Cell>& cells) override {
    ++counts.back();
    rows.emplace_back();
    for (const Cell& cell : cells) {
      const auto* text = std::get_if<std::string>(&cell);
      rows.back().push_back(text != nullptr ? *text : "");
    }
  }
  void end() override {}
  std::vector<std::vector<std::string>> rows;
  std::vector<int> counts;  ///< of the rows of each statement
};

class DatabaseDocumentation : public testing::Test {
 protected:
  DatabaseDocumentation() {
    ResultStore store(database_);
    test::fill_small_database(store);
    test::add_made_up_run(database_);
  }
  std::vector<std::string> first_column(const std::string& sql) const {
    Rows rows;
    run_queries(database_, sql, rows);
    std::vector<std::string> texts;
    for (const auto& row : rows.rows) texts.push_back(row[0]);
    return texts;
  }
  std::size_t count_of_examples_that_find_something(const Documentation& documentation) const {
    std::size_t examples = 0;
    for (const auto& [heading, queries] : documentation.examples) {
      for (const std::string& query : queries) {
        Rows rows;
        EXPECT_NO_THROW(run_queries(database_, query, rows)) << query;
        EXPECT_FALSE(std::any_of(rows.counts.begin(), rows.counts.end(), [](int count) { return count == 0; }))
            << query;
        examples += rows.counts.size();
      }
    }
    return examples;
  }
  std::vector<std::string> views_and_tables() const {
    return first_column("SELECT name FROM sqlite_master WHERE type IN ('view', 'table') AND name NOT LIKE 'sqlite_%'");
  }

  TestFolder folder_;
  Database database_ = Database::open(folder_ / "rig.db");
  const Documentation documentation_ = read_documentation("schema/database.md");
};

TEST_F(DatabaseDocumentation, ExplainsEveryColumnOfEveryViewAndTable) {
  std::set<std::string> there;
  for (const std::string& name : views_and_tables()) {
    there.insert(name);
    ASSERT_TRUE(documentation_.columns.contains(name)) << name << " has no heading in schema/database.md";
    EXPECT_EQ(documentation_.columns.at(name), first_column("SELECT name FROM pragma_table_xinfo('" + name + "')"))
        << name;
  }
  for (const auto& [name, columns] : documentation_.columns) EXPECT_TRUE(there.contains(name)) << name << " is no more";
}

TEST_F(DatabaseDocumentation, HasExamplesThatFindSomething) {
  EXPECT_GE(count_of_examples_that_find_something(documentation_), view_descriptions().size());
}

TEST_F(DatabaseDocumentation, TheGuideAsksWhatARunOfTheAlgorithmAnswers) {
  EXPECT_EQ(count_of_examples_that_find_something(read_documentation("docs/how-to/query-the-database.md")), 6U);
}

TEST_F(DatabaseDocumentation, SaysOfEveryViewWhatTheProgramSays) {
  const std::vector<std::string> views = first_column("SELECT name FROM sqlite_master WHERE type = 'view'");
  EXPECT_EQ(view_descriptions().size(), views.size());
  for (const ViewDescription& view : view_descriptions()) {
    EXPECT_THAT(views, testing::Contains(view.name));
    ASSERT_FALSE(view.sentence.empty()) << view.name;
    EXPECT_THAT(documentation_.sentences.at(view.name), testing::Contains(view.sentence));
    EXPECT_THAT(documentation_.examples.at(view.name), testing::Contains(view.example + '\n'));
  }
}

TEST_F(DatabaseDocumentation, ViewsNeedNoExtensionOfSqlite) {
  for (const std::string& name : first_column("SELECT sql FROM sqlite_master WHERE type = 'view'")) {
    EXPECT_EQ(name.find("jsonb"), std::string::npos) << "unknown to SQLite 3.40";
    EXPECT_EQ(name.find("median"), std::string::npos) << "unknown to SQLite 3.40";
  }
}

}  // namespace
}  // namespace lacuna
