#pragma once

#include <map>
#include <string>

namespace lacuna {

/// The files of the folder drafts/, compiled into the program: text by name, without ".in".
const std::map<std::string, std::string>& draft_texts();

}  // namespace lacuna
