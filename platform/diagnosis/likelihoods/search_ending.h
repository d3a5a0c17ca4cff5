#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/rounds/rejudge.h"
#include "diagnosis/rounds/round.h"
#include "diagnosis/rounds/search_state.h"
#include "diagnosis/rounds/unaided.h"

#include <optional>

namespace lacuna {

/// A search that has come to its end. Everything referred to must live until `end_search` returns.
struct SearchEnding {
  const DiagnosisTask& task;
  const BaseSolution& cut;  ///< of the trials
  const Contender& plain;   ///< the experiment's model
  const Contender& answer;
  const Rejudged& again;                  ///< the answer's last effect and its rivals, under the noise of `last`
  const Round& last;                      ///< of the answer: it found nothing more to add
  const std::optional<Unaided>& unaided;  ///< under the noise of `last`; nothing where it cannot be simulated
  std::optional<double> law_ahead;        ///< nats, where it ended since a formula outdoes the library
  SearchState& state;
  ProgressMeter& meter;
};

/// Verdict, probability and all that is said of an answer once it is found: in `state.so_far`.
void end_search(const SearchEnding& ending);

}  // namespace lacuna
