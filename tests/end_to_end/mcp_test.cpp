#include "end_to_end/mcp_client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

/// An agent at work with the program's commands.
namespace lacuna {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Mcp : public testing::Test {
 protected:
  Mcp() { program_.copy_first_steps(); }

  Program program_;
};

constexpr const char* kRig = "first-steps.toml";

std::string text(const json& result) { return result["content"][0]["text"]; }

TEST_F(Mcp, NegotiatesTheRevisionOfTheProtocol) {
  McpClient client(program_);
  const auto agreed = [&](const std::string& wanted) {
    return client.request("initialize", {{"protocolVersion", wanted}})["protocolVersion"].get<std::string>();
  };
  EXPECT_EQ(agreed("2025-06-18"), "2025-06-18");
  EXPECT_EQ(agreed("2024-11-05"), "2024-11-05");
  EXPECT_EQ(agreed("2099-01-01"), "2025-11-25");
  EXPECT_EQ(client.request("initialize", json::object())["code"], -32602);
  EXPECT_EQ(client.request("ping", json::object()), json::object());
}

TEST_F(Mcp, ListsToolsWithTheSchemasOfTheirOptions) {
  McpClient client(program_);
  client.initialize();
  std::set<std::string> names;
  const json listed = client.request("tools/list", json::object());
  for (const json& tool : listed["tools"]) {
    names.insert(tool["name"]);
    EXPECT_EQ(tool["inputSchema"]["type"], "object");
    EXPECT_EQ(tool["inputSchema"]["additionalProperties"], false);
    EXPECT_FALSE(tool["description"].get<std::string>().empty());
    for (const auto& [name, schema] : tool["inputSchema"]["properties"].items())
      EXPECT_FALSE(schema["description"].get<std::string>().empty()) << name;
    if (tool["name"] != "diagnose") continue;
    const json& properties = tool["inputSchema"]["properties"];
    EXPECT_EQ(tool["inputSchema"]["required"], json({"experiment"}));
    EXPECT_EQ(properties["among"]["type"], "array");
    EXPECT_EQ(properties["threads"]["type"], "integer");
    EXPECT_FALSE(properties.contains("quiet"));
  }
  for (const char* name : {"new", "check", "fit", "compare", "diagnose", "add", "undo", "history", "predict", "trial",
                           "export", "report", "sql", "plugins_list", "plugins_show"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST_F(Mcp, AnswersWhatItCannotDoByErrorsAndGoesOn) {
  McpClient client(program_);
  EXPECT_EQ(client.request("tools/list", json::object())["code"], -32600) << "before initialize";
  client.initialize();
  const auto code_of = [&](const std::string& line) {
    client.send(line);
    const json answer = client.receive();
    EXPECT_FALSE(answer["error"]["message"].get<std::string>().empty()) << line;
    return answer["error"]["code"].get<int>();
  };
  EXPECT_EQ(code_of("{\"jsonrpc\":"), -32700);
  EXPECT_EQ(code_of("\xff\xfe"), -32700);
  EXPECT_EQ(code_of(std::string(100000, '[')), -32700);
  EXPECT_EQ(code_of("\"" + std::string(5U << 20U, 'x') + "\""), -32700);
  EXPECT_EQ(code_of("[]"), -32600);
  EXPECT_EQ(code_of("7"), -32600);
  EXPECT_EQ(code_of(R"({"id":1,"method":"ping"})"), -32600);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":[],"method":"ping"})"), -32600);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1,"method":7})"), -32600);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1,"method":"ping","params":[]})"), -32602);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1,"method":"resources/list"})"), -32601);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/call"})"), -32602);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"diagnos"}})"), -32602);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"sql","arguments":[]}})"),
            -32602);
  client.send("");
  client.send(R"({"jsonrpc":"2.0","method":"notifications/of_the_future"})");
  client.send(R"({"jsonrpc":"2.0","id":9,"result":{}})");
  EXPECT_EQ(client.request("ping", json::object()), json::object());
}

TEST_F(Mcp, NamesEveryFaultOfACall) {
  McpClient client(program_);
  client.initialize();
  const json result =
      client.call("compare", {{"expriment", kRig}, {"threads", "two"}, {"set", {1}}, {"as_is", "yes"}, {"db", ""}});
  EXPECT_TRUE(result["isError"]);
  for (const char* fault :
       {"experiment: is missing", "expriment: is no argument of this tool (did you mean \"experiment\"?)",
        "threads: must be a whole number", "set: must be an array, each element a text", "as_is: must be true or false",
        "db: is empty"})
    EXPECT_THAT(text(result), HasSubstr(fault));
  McpClient older(program_);
  older.initialize("2025-06-18");
  EXPECT_EQ(older.call("check", json::object())["code"], -32602);
}

TEST_F(Mcp, TellsWhatACommandRefuses) {
  McpClient client(program_);
  client.initialize();
  const json result = client.call("add", {{"experiment", kRig}, {"effect", "coulmb_friction"}});
  EXPECT_TRUE(result["isError"]);
  EXPECT_EQ(result["structuredContent"]["exit_code"], 2);
  EXPECT_THAT(text(result), HasSubstr("coulomb_friction"));
  EXPECT_TRUE(client.call("compare", {{"experiment", "--help"}})["isError"]) << "a value is no option";
}

/// Wherever a name of another folder stands: among the arguments, in the experiment, behind a link.
TEST_F(Mcp, StaysInItsFolder) {
  const Program other;
  other.copy_first_steps();
  const std::string outside = (other.folder() / kRig).string();
  std::filesystem::create_symlink(other.folder(), program_.folder() / "link");
  McpClient client(program_);
  client.initialize();
  const auto refused = [&](const std::string& tool, const json& arguments) {
    const json result = client.call(tool, arguments);
    EXPECT_TRUE(result["isError"]) << arguments;
    EXPECT_THAT(text(result), HasSubstr("lies outside ")) << arguments;
  };
  refused("check", {{"experiment", outside}});
  refused("check", {{"experiment", "../" + other.folder().filename().string() + "/" + kRig}});
  refused("check", {{"experiment", "link/first-steps.toml"}});
  refused("check", {{"experiment", kRig}, {"plugin_path", {other.folder().string()}}});
  refused("check", {{"experiment", kRig},
                    {"set", {"model.file=\"" + (other.folder() / "robots/servo-pendulum.toml").string() + "\""}}});
  refused("check", {{"experiment", kRig}, {"set", {"target.files=[\"link/data/servo_pendulum/sine.csv\"]"}}});
  refused("fit", {{"experiment", kRig}, {"db", (other.folder() / "stolen.db").string()}});
  refused("compare", {{"experiment", kRig}, {"out", "link/pictures"}});
  refused("compare", {{"experiment", kRig}, {"json", (other.folder() / "stolen.json").string()}});
  refused("new", {{"experiment", "drafted.toml"}, {"from", {"link/data/servo_pendulum/sine.csv"}}});
  EXPECT_FALSE(std::filesystem::exists(other.folder() / "stolen.db"));
  EXPECT_FALSE(std::filesystem::exists(other.folder() / "stolen.json"));
  EXPECT_FALSE(std::filesystem::exists(other.folder() / "pictures"));
  EXPECT_FALSE(client.call("check", {{"experiment", (program_.folder() / kRig).string()}})["isError"]);
}

TEST(McpOutside, StartsNoProgramThatAFileNames) {
  const Program program;
  program.copy_outside_targets();
  McpClient client(program);
  client.initialize();
  const json result =
      client.call("trial", {{"experiment", "outside-pendulum.toml"}, {"test", "steps motor 0.1 N*m 1 Hz 2 s"}});
  EXPECT_TRUE(result["isError"]);
  EXPECT_THAT(text(result), HasSubstr("an agent may not start programs"));
}

TEST_F(Mcp, OutlivesAPluginThatEndsTheProgram) {
  const std::filesystem::path tests = std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests/bad_plugins/rig";
  std::filesystem::copy(tests, program_.folder());
  std::filesystem::create_directory(program_.folder() / "plugins");
  std::filesystem::copy_file(LACUNA_BINARY_DIRECTORY "/tests/bad_plugins/hostile.so",
                             program_.folder() / "plugins/hostile.so");
  McpClient client(program_, {{"HOSTILE", "add_loads abort"}});
  client.initialize();
  const json result = client.call("compare", {{"experiment", "rig.toml"},
                                              {"plugin_path", {"plugins"}},
                                              {"set", {R"(model.effects=[{effect="hostile",where="joint.axle"}])"}}});
  EXPECT_TRUE(result["isError"]);
  EXPECT_THAT(text(result), HasSubstr("add_loads ended the program by signal 6"));
  EXPECT_FALSE(client.call("compare", {{"experiment", "rig.toml"}})["isError"]);
}

TEST_F(Mcp, EndsACallAtItsLimitAndGoesOn) {
  McpClient client(program_, {}, {"--call-limit", "0.3"});
  client.initialize();
  const json result = client.call("diagnose", {{"experiment", kRig}});
  EXPECT_EQ(result["structuredContent"]["exit_code"], 75);
  EXPECT_THAT(text(result), HasSubstr("reached its limit of 0.3 s"));
  EXPECT_EQ(client.request("ping", json::object()), json::object());
}

TEST_F(Mcp, AnswersMeanwhileAndCancels) {
  McpClient client(program_);
  client.initialize();
  const int diagnosis = client.ask("tools/call", {{"name", "diagnose"}, {"arguments", {{"experiment", kRig}}}});
  const int waiting = client.ask("tools/call", {{"name", "check"}, {"arguments", {{"experiment", kRig}}}});
  EXPECT_EQ(client.request("ping", json::object()), json::object());
  client.send(
      json{{"jsonrpc", "2.0"}, {"id", diagnosis}, {"method", "tools/call"}, {"params", {{"name", "sql"}}}}.dump());
  EXPECT_EQ(client.receive()["error"]["code"], -32600) << "an id that is under way";
  client.notify("notifications/cancelled", {{"requestId", diagnosis}, {"reason", "enough"}});
  client.notify("notifications/cancelled", {{"requestId", 12345}});
  EXPECT_FALSE(client.answer_to(waiting)["result"]["isError"]);
  EXPECT_THAT(client.others, testing::IsEmpty()) << "a cancelled request has no answer";
}

TEST_F(Mcp, ReadsTheDatabaseAndChangesNothingThroughSql) {
  McpClient client(program_);
  client.initialize();
  ASSERT_FALSE(client.call("fit", {{"experiment", kRig}})["isError"]);
  const json rows = client.call("sql", {{"database", "first-steps.db"}, {"sql", "SELECT count(*) AS n FROM runs"}});
  EXPECT_EQ(rows["structuredContent"]["result"], json::array({{{"n", 1}}})) << rows;
  EXPECT_TRUE(client.call("sql", {{"database", "first-steps.db"}, {"sql", "DELETE FROM run"}})["isError"]);
  EXPECT_TRUE(client.call("sql", {{"database", "first-steps.db"}, {"sql", "ATTACH '/etc/passwd' AS p"}})["isError"]);
  EXPECT_FALSE(client.call("sql", {{"views", true}})["isError"]);
}

TEST_F(Mcp, ExportsRowsInTheFormatThatIsAskedFor) {
  McpClient client(program_);
  client.initialize();
  ASSERT_FALSE(client.call("fit", {{"experiment", kRig}})["isError"]);
  json rows = {{"source", "first-steps.db"}, {"what", "revisions"}, {"csv", "revisions.csv"}};
  const json written = client.call("export", rows);
  ASSERT_FALSE(written["isError"]) << written;
  EXPECT_TRUE(std::filesystem::exists(program_.folder() / "revisions.csv"));
  rows.erase("csv");
  const json refused = client.call("export", rows);
  EXPECT_TRUE(refused["isError"]);
  EXPECT_THAT(refused.dump(), testing::HasSubstr("--csv"));
}

TEST_F(Mcp, AnswersCallsThatWereSentBeforeTheInputEnded) {
  const json begin = {{"jsonrpc", "2.0"},
                      {"id", 1},
                      {"method", "initialize"},
                      {"params", {{"protocolVersion", "2025-11-25"}, {"capabilities", json::object()}}}};
  const json call = {{"jsonrpc", "2.0"},
                     {"id", 2},
                     {"method", "tools/call"},
                     {"params", {{"name", "check"}, {"arguments", {{"experiment", kRig}}}}}};
  program_.write("messages", begin.dump() + "\n" + call.dump() + "\n");
  const Outcome outcome = program_.shell("lacuna mcp < messages");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("\"id\":1"), HasSubstr("\"id\":2")));
}

TEST_F(Mcp, DraftsAnExperimentAndNamesTheBlanks) {
  McpClient client(program_);
  client.initialize();
  const json result = client.call("new", {{"experiment", "mine.toml"}, {"from", {"data/servo_pendulum/sine.csv"}}});
  EXPECT_FALSE(result["isError"]) << result;
  EXPECT_THAT(text(result), HasSubstr("fill in"));
  EXPECT_TRUE(std::filesystem::exists(program_.folder() / "mine.toml"));
}

TEST_F(Mcp, ShowsEffectsAndWritesTheReport) {
  McpClient client(program_);
  client.initialize();
  const json listed = client.call("plugins_list", {{"kind", "effect"}})["structuredContent"]["result"];
  EXPECT_GT(listed["components"].size(), 20U);
  const json shown = client.call("plugins_show", {{"name", "coulomb_friction"}})["structuredContent"]["result"];
  EXPECT_EQ(shown["components"][0]["name"], "coulomb_friction");
  ASSERT_FALSE(client.call("compare", {{"experiment", kRig}, {"out", "pictures"}, {"json", "all.json"}})["isError"]);
  EXPECT_THAT(json::parse(program_.read("all.json"))["advice"], HasSubstr("something is missing"));
  EXPECT_TRUE(std::filesystem::exists(program_.folder() / "pictures/chirp.csv-angle.svg"));
  const json page = client.call("report", {{"database", "first-steps.db"}, {"out", "report.html"}});
  if (text(page).find("Node.js") != std::string::npos) GTEST_SKIP() << "this build has no pages";
  EXPECT_FALSE(page["isError"]) << page;
  EXPECT_THAT(program_.read("report.html"), testing::StartsWith("<!"));
}

}  // namespace
}  // namespace lacuna
