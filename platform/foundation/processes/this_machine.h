#pragma once

#include <string>

namespace lacuna {

/// Eight hexadecimal digits for names of files in folders that machines share: another machine has others, mostly.
const std::string& digits_of_this_machine();

/// The same for processes that see each other by their numbers: those of one machine, in one namespace, since it was
/// started. Empty where the system does not tell.
const std::string& digits_of_this_start();

}  // namespace lacuna
