#pragma once

namespace lacuna {

/// Has the process call `last` where memory is used up in a place that must not throw: in a destructor, as that of a
/// JSON document, or in a thread. Otherwise such an end is an abort, taken for a fault of the program. Not where a
/// plugin is being called: that is the plugin's end. `last` allocates nothing and ends the process.
void set_end_without_memory(void (*last)());

}  // namespace lacuna
