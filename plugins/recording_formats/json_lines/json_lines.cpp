#include "json_rows.h"

#include <lacuna/plugin.h>

namespace lacuna {
namespace {

class JsonLines : public RecordingFormat {
 public:
  std::string summary() const override { return "JSON Lines: one object per line, columns by path"; }
  std::vector<std::string> endings() const override { return {".jsonl", ".ndjson"}; }
  RecordingContents contents(const std::string& file) const override { return json_lines::contents_of(file); }
  ReadRows read(const std::string& file, const std::vector<TableQuery>& queries) const override {
    return json_lines::rows_of(file, queries);
  }
};

}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RecordingFormat, lacuna::JsonLines>("json_lines"))
