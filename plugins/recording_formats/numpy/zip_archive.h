#pragma once

#include "byte_stream.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna::numpy {

using namespace recording_bytes;

/// A member of a ZIP archive, stored or deflated.
struct ZipMember {
  std::string name;
  bool is_deflated = false;
  std::uint64_t packed_size = 0, size = 0;  ///< bytes
  std::uint64_t place = 0;                  ///< of its data in the file
  std::uint32_t checksum = 0;               ///< CRC-32
};

/// The members of an archive by its central directory (APPNOTE.TXT 6.3.10, with ZIP64). Throws `BadFile` for a file
/// that is not an archive, for compression other than deflate, and for encrypted members.
std::vector<ZipMember> members_of(RandomFile& file);

}  // namespace lacuna::numpy
