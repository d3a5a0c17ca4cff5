#pragma once

#include <string>

namespace lacuna {

/// Eight hexadecimal digits for file names in folders shared by machines; they almost always differ between machines.
const std::string& digits_of_this_machine();

/// The same for processes with a common process table: those of one machine, in one namespace, since it was started.
/// Empty where the system does not give it.
const std::string& digits_of_this_start();

}  // namespace lacuna
