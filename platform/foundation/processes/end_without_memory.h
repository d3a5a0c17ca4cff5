#pragma once

namespace lacuna {

/// Makes the process call `last` where memory is used up in a place that must not throw: in a destructor, such as that
/// of a JSON document, or in a thread. Otherwise such an end would be an abort, which looks like a fault of the
/// program. Not during a call of a plugin: that counts as the plugin's end. `last` must allocate nothing and end the
/// process.
void set_end_without_memory(void (*last)());

}  // namespace lacuna
