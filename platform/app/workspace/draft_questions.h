#pragma once

#include "app/workspace/rig_draft.h"

#include <iosfwd>
#include <string>

namespace lacuna {

/// Whether a person types and reads: both standard input and standard output are terminals.
bool asks_at_terminal();

/// Asks for each blank of the drafted files what belongs there, and puts the answers in. A default stands in brackets;
/// without an answer, or at the end of the input, a blank without a default stays. An answer that cannot be is asked
/// for again with the reason.
void ask_for_blanks(const RigDraft& draft, std::string& experiment, std::string& robot);

/// The same of one file called `name`, for a test that types.
std::string with_answers(const RigDraft& draft, const std::string& name, const std::string& text, std::istream& in,
                         std::ostream& out);

}  // namespace lacuna
