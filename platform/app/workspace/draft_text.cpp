#include "app/workspace/draft_text.h"

#include "config/schema/blank.h"
#include "config/toml/toml_node.h"
#include "foundation/text/plain_text.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

constexpr int kCommentColumn = 40;

}  // namespace

std::string with_comment(const std::string& line, const std::string& comment) {
  return fmt::format("{:<{}}# {}\n", line + "  ", kCommentColumn, plain_text(comment));
}

std::string path_in_file(const std::filesystem::path& file, const std::filesystem::path& experiment) {
  const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
  const std::filesystem::path folder = std::filesystem::absolute(experiment).lexically_normal().parent_path();
  const std::string near = whole.lexically_proximate(folder).string();
  return near.starts_with("../../") ? whole.string() : near;
}

std::string blank(const std::string& unit) {
  return toml_text(unit.empty() ? std::string(kBlank) : kBlank + (" " + unit));
}

}  // namespace lacuna
