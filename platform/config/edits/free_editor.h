#pragma once

#include "config/schema/experiment.h"

#include <string>

namespace lacuna {

/// Edits of `model.free` in the text of an experiment file. Everything else stays as it is, byte for byte; each result
/// is read again and compared: it differs from the text by that value alone.

/// The text with one address more that is fitted. Throws `BadInput` where the text is not TOML, and `Error` where the
/// address is there, there is no [model], or the table cannot be edited in its layout.
std::string insert_free_value(const std::string& text, const FreeRange& value);

/// The text without it. Throws as above, and `Error` where the table does not have it.
std::string remove_free_value(const std::string& text, const std::string& address);

}  // namespace lacuna
