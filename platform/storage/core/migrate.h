#pragma once

#include "storage/core/database.h"

#include <string>
#include <vector>

namespace lacuna {

/// Throws `Error` for a file that is not a database, not one of ours, or of a newer version.
/// Writes nothing.
void check_header(const Database& database, const std::vector<Migration>& migrations);

bool is_of_version(const Database& database, const std::vector<Migration>& migrations);

/// Applies what is missing, all in one transaction.
void bring_up_to_date(Database& database, const std::vector<Migration>& migrations);

/// The same for a file: one of an older version is copied to `FILE.before-version-N` first.
void migrate(Database& database, const std::vector<Migration>& migrations);

/// Makes the views anew if they are not those of this text.
void refresh_views(Database& database, const std::string& views);

}  // namespace lacuna
