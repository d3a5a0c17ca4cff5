#include "end_to_end/guide.h"
#include "end_to_end/mcp_client.h"
#include "end_to_end/printed_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace lacuna {
namespace {

using nlohmann::json;

/// Two processors need not agree in more digits.
constexpr double kFigures = 0.05;

/// Where `shown` is not part of `came`: objects may have more members; a text that ends with "…" shows its beginning,
/// other texts and lists are shown whole. Empty: nowhere.
std::string difference_of(const json& shown, const json& came, const std::string& place) {
  if (shown.is_object()) {
    for (const auto& [name, value] : shown.items()) {
      if (!came.is_object() || !came.contains(name)) return place + "." + name + " is missing";
      if (std::string found = difference_of(value, came[name], place + "." + name); !found.empty()) return found;
    }
    return "";
  }
  if (shown.is_array() && came.is_array() && shown.size() == came.size()) {
    for (std::size_t i = 0; i < shown.size(); ++i)
      if (std::string found = difference_of(shown[i], came[i], place + "[" + std::to_string(i) + "]"); !found.empty())
        return found;
    return "";
  }
  if (shown.is_number() && came.is_number()) {
    const double a = shown, b = came;
    if (std::abs(a - b) <= kFigures * std::max(std::abs(a), std::abs(b))) return "";
  }
  if (shown.is_string() && came.is_string()) {
    std::string said = shown, printed = came;
    const std::string rest = "…";
    if (said.ends_with(rest)) {
      said.resize(said.size() - rest.size());
      printed = printed.substr(0, said.size());
    }
    if (difference({said}, {printed}, kFigures).empty()) return "";
  }
  return shown == came ? "" : place + " is " + came.dump();
}

/// Lines "→ {...}" are sent, lines "← {...}" are part of the next answer, notifications about progress left out.
TEST(McpGuide, IsAConversationThatTheServerHolds) {
  const Program program;
  program.copy_first_steps();
  McpClient client(program);
  const std::string sent = "→ ", received = "← ";  // each before an object
  int answers = 0;
  for (const std::string& line : lines_of(source_file("docs/how-to/let-an-agent-drive.md"))) {
    SCOPED_TRACE(line);
    if (line.starts_with(sent + "{")) client.send(line.substr(sent.size()));
    if (!line.starts_with(received + "{")) continue;
    json came = client.receive();
    while (came.value("method", "") == "notifications/progress") came = client.receive();
    EXPECT_EQ(difference_of(json::parse(line.substr(received.size())), came, "answer"), "") << came.dump(2);
    ++answers;
  }
  EXPECT_GE(answers, 6);
}

}  // namespace
}  // namespace lacuna
