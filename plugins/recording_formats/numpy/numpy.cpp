#include "numpy_file.h"

#include <lacuna/plugin.h>

namespace lacuna {
namespace {

class Numpy : public RecordingFormat {
 public:
  std::string summary() const override { return "Arrays of NumPy (.npy, .npz), structured types by path"; }
  std::vector<std::string> endings() const override { return {".npy", ".npz"}; }
  RecordingContents contents(const std::string& file) const override { return numpy::contents_of(file); }
  ReadRows read(const std::string& file, const std::vector<TableQuery>& queries) const override {
    return numpy::rows_of(file, queries);
  }
};

}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RecordingFormat, lacuna::Numpy>("numpy"))
