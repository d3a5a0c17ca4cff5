#include "measurement/csv/measured_text.h"

#include "foundation/files/allowed_files.h"
#include "foundation/files/special_file.h"
#include "measurement/cells/utf8.h"
#include "foundation/recording_folder.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

namespace lacuna {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string without_access(const std::filesystem::path& path) {
  check_may_read(path);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return "is a folder; name the files in it one by one (a folder of ROS 2 has a metadata.yaml)";
  if (!std::filesystem::exists(path, ignored)) return "there is no such file";
  if (const std::string special = special_file(path); !special.empty() && !is_unnamed_pipe(path))
    return fmt::format("is {}, not a file; name a file", special);
  return {};
}

/// The content of the file, or a sentence about why it cannot be read.
std::string read_bytes(const std::filesystem::path& path, std::string& complaint) {
  complaint = without_access(path);
  if (!complaint.empty()) return {};
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    complaint = fmt::format("cannot be opened: {}", std::strerror(errno));
    return {};
  }
  std::error_code no_size;  // a pipe has none and is read piece by piece
  const auto size = std::filesystem::file_size(path, no_size);
  constexpr std::size_t kPiece = 1 << 20;
  std::string bytes;
  bytes.resize(no_size ? kPiece : static_cast<std::size_t>(size) + 1);
  std::size_t filled = 0;
  while (const std::size_t got = std::fread(bytes.data() + filled, 1, bytes.size() - filled, file.get())) {
    filled += got;
    if (filled == bytes.size()) bytes.resize(bytes.size() + kPiece);
  }
  if (std::ferror(file.get())) complaint = fmt::format("cannot be read completely: {}", std::strerror(errno));
  bytes.resize(filled);
  return bytes;
}

struct BinaryFormat {
  std::string_view first_bytes;
  std::string_view complaint;
};
using namespace std::string_view_literals;
constexpr BinaryFormat kBinaryFormats[] = {
    {"PK\x03\x04"sv,
     "is a spreadsheet or a ZIP archive, not CSV; export the sheet as CSV (UTF-8), or give arrays of NumPy a name that "
     "ends with .npz"},
    {"\xd0\xcf\x11\xe0"sv, "is an old Excel workbook, not CSV; export the sheet as CSV (UTF-8)"},
    {"\x1f\x8b"sv, "is compressed with gzip; unpack it with gunzip"},
    {"\x28\xb5\x2f\xfd"sv, "is compressed with zstd; unpack it with unzstd"},
    {"MATLAB 5.0 MAT-file"sv, "is a MATLAB file; give it a name that ends with .mat"},
    {"MATLAB 7.3 MAT-file"sv, "is a MATLAB file of version 7.3; in MATLAB write save('run.mat', '-v7')"},
    {"\x89HDF\r\n\x1a\n"sv,
     "is an HDF5 file; in Python write numpy.savez('run.npz', **{name: f[name][:] for name in ('t', 'q')}) with "
     "f = h5py.File('run.h5')"},
    {"PAR1"sv, "is a Parquet file; in Python write pandas.read_parquet('run.parquet').to_csv('run.csv', index=False)"},
    {"SQLite format 3"sv, "is an SQLite database; give a bag of ROS 2 a name that ends with .db3"},
    {"\x89MCAP0\r\n"sv, "is an MCAP file; give it a name that ends with .mcap"},
    {"\x93NUMPY"sv, "is an array of NumPy; give it a name that ends with .npy"},
    {"#ROSBAG"sv, "is a bag of ROS 1; convert it with rosbags-convert --src run.bag --dst run"},
};

/// Message for a robot file that was named as a recording; empty: it is not one.
std::string robot_file_in(const std::string& bytes) {
  const std::string_view head = std::string_view(bytes).substr(0, 4096);
  const std::size_t start = head.find_first_not_of(" \t\r\n");
  if (start == head.npos) return {};
  const bool is_xml = head[start] == '<',
             is_toml = head.substr(start).starts_with("[robot]") || head.find("\n[robot]") != head.npos;
  const bool is_robot = is_toml || head.find("<robot") != head.npos || head.find("<mujoco") != head.npos;
  if (is_robot)
    return "is a robot file, not a recording; name the robot under model.file or by --robot, and here a file with one "
           "column of times and one column per reading";
  return is_xml ? "is XML, not a recording; export the recording as CSV, with one column of times and one column per "
                  "reading"
                : "";
}

std::string not_text(const std::string& bytes) {
  if (bytes.empty()) return "is empty; it needs a header line with column names and one line per sample";
  for (const BinaryFormat& format : kBinaryFormats)
    if (bytes.starts_with(format.first_bytes)) return std::string(format.complaint);
  if (std::string robot = robot_file_in(bytes); !robot.empty()) return robot;
  const std::string_view head = std::string_view(bytes).substr(0, 4096);
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r';
  };
  const auto controls = static_cast<std::size_t>(std::count_if(head.begin(), head.end(), is_control));
  if (controls * 50 > head.size()) return "is a binary file, not CSV; export the recording as text";
  return {};
}

}  // namespace

std::string why_no_file(const std::filesystem::path& path) {
  if (is_recording_folder(path)) return {};
  if (std::string reason = without_access(path); !reason.empty()) return reason;
  if (is_unnamed_pipe(path)) return "is a pipe, from which only CSV can be read; name a file";
  if (::access(path.c_str(), R_OK) != 0) return fmt::format("cannot be opened: {}", std::strerror(errno));
  return {};
}

std::string read_measured_text(const std::filesystem::path& path, FileReport& report) {
  std::string complaint;
  std::string text = read_bytes(path, complaint);
  if (const std::optional<Utf16> order = complaint.empty() ? utf16_in(text) : std::nullopt) {
    text = utf8_from_utf16(text, *order);
    report.note("utf16", 0, [] { return std::string("is UTF-16 text; read as such"); });
  }
  if (complaint.empty()) complaint = not_text(text);
  if (!complaint.empty()) {
    report.problem("file", 0, [&] { return complaint; });
    return {};
  }
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  if (text.find('\n') == std::string::npos && text.find('\r') != std::string::npos) {
    std::replace(text.begin(), text.end(), '\r', '\n');
    report.note("file", 0, [] { return std::string("lines end in \\r alone; read as line ends"); });
  }
  return text;
}

}  // namespace lacuna
