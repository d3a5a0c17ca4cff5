// Whatever a bag holds, it is read in whole rows or refused with sentences: an MCAP file, or a database, by the bytes
// that it begins with.

#include "bag_file.h"
#include "recording_format_fuzzing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = lacuna::fuzz::text_of(data, size);
  lacuna::fuzz::read_bytes_as(bytes.starts_with("SQLite") ? "run.db3" : "run.mcap", bytes, lacuna::rosbag2::contents_of,
                              lacuna::rosbag2::rows_of);
  return 0;
}
