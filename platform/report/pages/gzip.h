#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// As a gzip file without name and time, so that the same bytes give the same file.
std::vector<std::byte> gzip(std::span<const std::byte> bytes);

}  // namespace lacuna
