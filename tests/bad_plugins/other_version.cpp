#include "bad_effect.h"

/// A table as version 0 of the interface might have had it: magic and version stand where they always do.
namespace {

struct OldTable {
  char magic[8] = {'L', 'A', 'C', 'U', 'N', 'A', 'P', '\0'};
  std::uint32_t interface_version = 0;
  std::uint32_t what_came_then = 12345;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const void* lacuna_plugin() {
  static constexpr OldTable table;
  return &table;
}
