#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// What differs between what a document says and what was printed; empty: nothing. Runs of blanks count as one, bars
/// and the length of rules are not compared, numbers may differ by `tolerance` relative to the larger one, or by one in
/// their last digit, what is left of an error that falls ("−94 %") likewise, a figure with its uncertainty (N ± M) by a
/// quarter of M, M by 20 %, and others in its line by 10 %, probabilities P by 0.01, chances p and what chance reaches
/// ("chance:") by 10 %; how long something took may be anything. A line "…" stands for any lines.
std::string difference(const std::vector<std::string>& said, const std::vector<std::string>& printed, double tolerance);

std::vector<std::string> lines_of(const std::string& text);

}  // namespace lacuna
