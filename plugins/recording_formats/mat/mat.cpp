#include "mat_file.h"

#include <lacuna/plugin.h>

namespace lacuna {
namespace {

class Mat : public RecordingFormat {
 public:
  std::string summary() const override { return "MAT files of MATLAB (version 5, save -v7), fields by path"; }
  std::vector<std::string> endings() const override { return {".mat"}; }
  RecordingContents contents(const std::string& file) const override { return mat::contents_of(file); }
  ReadRows read(const std::string& file, const std::vector<TableQuery>& queries) const override {
    return mat::rows_of(file, queries);
  }
};

}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RecordingFormat, lacuna::Mat>("mat"))
