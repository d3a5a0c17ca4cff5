#pragma once

#include <cstddef>
#include <string>

namespace lacuna {

/// A number of things for sentences: "1 trial", "3 trials", "2 bodies", "2 passes".
std::string counted(std::size_t count, const std::string& noun);

/// A noun behind its article, by the noun's first letter: "a joint", "an actuator".
std::string with_article(const std::string& noun);

}  // namespace lacuna
