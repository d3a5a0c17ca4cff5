#include "foundation/text/plain_text.h"
#include "report/figures/figure.h"
#include "report/figures/history_picture.h"
#include "report/figures/robot_drawing.h"
#include "report/text/history_text.h"

#include <lacuna/error.h>

#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>
#include <utility>

namespace lacuna {
namespace {

using testing::HasSubstr;
using namespace std::string_literals;

/// What a reader of the picture sees: the text without tags, with references resolved.
std::string shown_in(const std::string& svg) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kReferences = {
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&#x26;", '&'}, {"&#x3E;", '>'}}};
  std::string text;
  bool in_tag = false;
  for (std::size_t i = 0; i < svg.size(); ++i) {
    if (svg[i] == '<' || (in_tag && svg[i] == '>')) {
      in_tag = svg[i] == '<';
    } else if (!in_tag && svg[i] == '&') {
      std::size_t length = 0;
      for (const auto& [reference, character] : kReferences) {
        if (svg.compare(i, reference.size(), reference) != 0) continue;
        text += character;
        length = reference.size();
      }
      EXPECT_GT(length, 0U) << "another reference: " << svg.substr(i, 12);
      i += length > 0 ? length - 1 : 0;
    } else if (!in_tag) {
      text += svg[i];
    }
  }
  EXPECT_EQ(svg.find("]]>"), svg.npos) << "which XML refuses";
  return text;
}

/// The text in all places of a figure, told apart by what follows it.
Figure panels_with(const std::string& text) {
  const Series line{text + "-key", Mark::line_points, kBlue, {0, 1}, {1, 2}, {}};
  Panel panel{text + "-y", {line}, 1.0, {text + "-x tick"}};
  Panel named{"", {{"", Mark::bars, kOrange, {60.0}, {0.0}, {0.4}}}, 1.0, {}};
  named.y_names = {text + "-y tick"};
  return {text + "-title", text + "-x", {panel, named}};
}

Figure columns_with(const std::string& text) {
  Panel panel{text + "-y", {{text + "-key", Mark::points, kGrey, {0, 1}, {1, 2}, {}}}, 1.0, {}};
  panel.x_label = text + "-x of panel";
  Figure figure{text + "-title", "", {panel, panel}};
  figure.columns = 2;
  return figure;
}

/// A folder in which the program works, and in which a command of a text would make the file P.
class HostileText : public testing::TestWithParam<std::string> {
 public:
  HostileText() { std::filesystem::current_path(folder_.path()); }
  ~HostileText() override {
    EXPECT_FALSE(std::filesystem::exists("P")) << "a text was carried out";
    std::filesystem::current_path(before_);
  }

 protected:
  const std::filesystem::path before_ = std::filesystem::current_path();
  const TestFolder folder_;
};

TEST_P(HostileText, StandsInPanelsAsItIs) {
  const std::string shown = shown_in(svg_of(panels_with(GetParam())));
  for (const char* place : {"-title", "-x", "-y", "-key", "-x tick", "-y tick"})
    EXPECT_THAT(shown, HasSubstr(plain_text(GetParam()) + place));
}

TEST_P(HostileText, StandsInColumnsAsItIs) {
  const std::string shown = shown_in(svg_of(columns_with(GetParam())));
  for (const char* place : {"-title", "-y", "-key", "-x of panel"})
    EXPECT_THAT(shown, HasSubstr(plain_text(GetParam()) + place));
}

TEST_P(HostileText, IsNoCommandWhereAColourIsDue) {
  const Figure figure{"t", "x", {{"y", {{"s", Mark::line, GetParam(), {0, 1}, {1, 2}, {}}}, 1.0, {}}}};
  try {
    svg_of(figure);
  } catch (const Error&) {
    // most are no colours
  }
}

TEST_P(HostileText, StandsInDrawingsOfRobotsAsItIs) {
  RobotSpec robot;
  robot.bodies.emplace_back().name = GetParam();
  write_robots_svg(GetParam() + "-title", {{GetParam() + "-row", {{GetParam() + "-caption", robot}}}},
                   folder_ / "robots.svg");
  const std::string shown = shown_in(read_bytes(folder_ / "robots.svg"));
  for (const char* place : {"-title", "-row", "-caption"})
    EXPECT_THAT(shown, HasSubstr(plain_text(GetParam()) + place));
}

INSTANTIATE_TEST_SUITE_P(Characters, HostileText,
                         testing::Values("`touch P`", "$(touch P) $0 $p0s0", "@GPVAL_VERSION @a", "'", "''' 'a''b' '",
                                         "'; system('touch P'); '", "\"", "\"; system(\"touch P\"); \"", "\\",
                                         "\\\\ \\n \\101 \\", "a\nsystem('touch P')\n!touch P\n", "a\r!touch P\r",
                                         "a\0`touch P`"s, "\t\x1B[31m\x7F", "-persist", "-e \"!touch P\"", "# a",
                                         "{/Bold a}_b^c~d", "%s %g %n %% 95%", "&#x41; &#38; &lt;",
                                         "<script>a</script> ]]> <!-- -->", "caf\xE9 \xC0\xA7", "EOD\nEOD", "0451",
                                         "é·日"));

TEST(HostileFigure, IsNotTouchedByTheUsersSettings) {
  const TestFolder home;
  home.write(".gnuplot", "system('touch " + (home / "P").string() + "')\nset title 'mine'\n");
  const char* const own = std::getenv("HOME");
  const std::string before = own == nullptr ? "" : own;
  setenv("HOME", home.path().c_str(), 1);
  setenv("GNUTERM", "postscript", 1);
  const std::string svg = svg_of(panels_with("a"));
  setenv("HOME", before.c_str(), 1);
  unsetenv("GNUTERM");
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_EQ(shown_in(svg).find("mine"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(home / "P"));
}

TEST(HostileFigure, MayHaveAnyFolder) {
  const TestFolder folder;
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  for (const char* name : {"`touch P`", "-persist", "a\nb", "it's \"one\"", "$(touch P)"}) {
    write_svg(panels_with("a"), std::filesystem::path(name) / "angle.svg");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / name / "angle.svg")) << name;
  }
  std::filesystem::current_path(here);
  EXPECT_FALSE(std::filesystem::exists(folder / "P"));
}

TEST(HostileFigure, DoesNotFollowLinksInItsFolder) {
  const TestFolder folder;
  const auto mine = folder.write("mine.txt", "kept\n");
  std::filesystem::create_symlink(mine, folder / "angle.svg");
  write_svg(panels_with("a"), folder / "angle.svg");
  EXPECT_EQ(read_bytes(mine), "kept\n");
  EXPECT_THAT(read_bytes(folder / "angle.svg"), HasSubstr("</svg>"));
}

TEST(HostileFigure, StaysInItsFolder) {
  const TestFolder folder;
  HistoryRow row;
  row.number = 1;
  row.channel = "../../outside";
  row.unit = "rad";
  row.fit_rmse = row.held_out_rmse = row.floor = 1.0;
  const std::vector<std::filesystem::path> files = draw_history({row}, "title", folder / "a/b");
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].parent_path(), folder / "a/b");
}

}  // namespace
}  // namespace lacuna
