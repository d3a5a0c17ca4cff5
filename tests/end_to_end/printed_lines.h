#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// What differs between what a document says and what was printed; empty: nothing. Runs of blanks count as one, bars
/// and the length of rules are not compared, numbers may differ by `tolerance` relative to the larger one, or by one in
/// their last digit, one with its uncertainty (N ± M) by that, M by a factor of 2, and others in its line by 30 %,
/// probabilities (P, p) by 0.15, but not across 5 %, what chance reaches ("chance:") by 15 %; how long something took
/// may be anything. A line "…" stands for any lines.
std::string difference(const std::vector<std::string>& said, const std::vector<std::string>& printed, double tolerance);

std::vector<std::string> lines_of(const std::string& text);

}  // namespace lacuna
