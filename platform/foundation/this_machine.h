#pragma once

#include <string>

namespace lacuna {

/// Eight hexadecimal digits for names of files in folders that machines share: another machine has others, mostly.
const std::string& digits_of_this_machine();

}  // namespace lacuna
