#include "bag_file.h"

#include <lacuna/plugin.h>

namespace lacuna {
namespace {

class Rosbag2 : public RecordingFormat {
 public:
  std::string summary() const override { return "Bags of ROS 2 (.mcap, .db3): one table per topic, columns by path"; }
  std::vector<std::string> endings() const override { return {".mcap", ".db3"}; }
  RecordingContents contents(const std::string& file) const override { return rosbag2::contents_of(file); }
  ReadRows read(const std::string& file, const std::vector<TableQuery>& queries) const override {
    return rosbag2::rows_of(file, queries);
  }
};

}  // namespace
}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::RecordingFormat, lacuna::Rosbag2>("rosbag2"))
