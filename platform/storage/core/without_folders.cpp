#include "storage/core/without_folders.h"

namespace lacuna {
namespace {

constexpr std::string_view kBefore = " \t\n\"'=([,:";  ///< of which one stands before a path, unless it comes first
constexpr std::string_view kAfter = " \t\n\"';:)]";

/// Where a path ends that begins at `begin`; one in quotes may have spaces in it.
std::size_t end_of_path(std::string_view text, std::size_t begin) {
  const char before = begin == 0 ? ' ' : text[begin - 1];
  const std::size_t quote = before == '\'' || before == '"' ? text.find(before, begin) : std::string_view::npos;
  const std::size_t end = quote != std::string_view::npos ? quote : text.find_first_of(kAfter, begin);
  return end == std::string_view::npos ? text.size() : end;
}

/// "/a/b/" → "b"; what is no path in a folder stays.
std::string_view last_name(std::string_view path) {
  while (path.size() > 1 && path.ends_with('/')) path.remove_suffix(1);
  const std::size_t slash = path.rfind('/');
  return slash == 0 || slash == std::string_view::npos ? path : path.substr(slash + 1);
}

bool begins_path(std::string_view text, std::size_t at) {
  return text[at] == '/' && (at == 0 || kBefore.find(text[at - 1]) != std::string_view::npos) &&
         !text.substr(at).starts_with("//");
}

}  // namespace

std::string without_folders(std::string_view text) {
  std::string kept;
  for (std::size_t at = 0; at < text.size();) {
    if (!begins_path(text, at)) {
      kept += text[at++];
      continue;
    }
    const std::size_t end = end_of_path(text, at);
    kept += last_name(text.substr(at, end - at));
    at = end;
  }
  return kept;
}

}  // namespace lacuna
