#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/rounds/round.h"
#include "diagnosis/rounds/search_state.h"
#include "diagnosis/rounds/unaided.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A model that does with fewer effects nearly what an answer of several does, or just that with simpler ones.
struct FewerEffects {
  std::vector<EffectEntry> added;
  Refit fit;
  Gain gain;                            ///< over the model without any effect
  double share = 0.0;                   ///< of the answer's gain
  std::optional<std::size_t> of_first;  ///< the rival of the first step that it is
};

/// Everything referred to must live until `fewer_effects` returns.
struct FewerEffectsTask {
  const Contender& answer;
  const std::vector<Contender>& alternatives;  ///< to the answer, with another last effect
  const Contender& plain;                      ///< the model without any effect added
  const Unaided& unaided;                      ///< the same, under the noise of `now`
  const SearchStep& first;                     ///< of the model without any effect
  const PluginCatalog& catalog;
  const Round& now;                       ///< of the answer
  const std::vector<std::string>& among;  ///< names of effects; empty: all
  std::uint64_t seed = 1;
  int threads = 1;
};

/// The search goes forward, under a noise that holds what is not found yet; so two effects may stand where a single
/// one, which did not lead then, is enough. Under the noise of the answer's own round, each rival of the first step,
/// each part of the answer and each alternative to its last effect are refitted alone. Of the smallest that lose no
/// more than a tenth of the answer's gain and five standard errors, or 2 nats, the best is returned, or one with fewer
/// parameters that is at most a twentieth of that gain behind it: an effect that adds less than that is likelier to
/// make up for the form of another than to be there, and the next diagnosis, with the others in the model, finds it if
/// it is. Enough, too, is a model that explains most of the squared error above the floor where the answer removes less
/// than half of what that leaves in any channel. Where all are needed, the answer with one effect in the place of
/// another that declares it as a look-alike and has more parameters, if that loses no more than a standard error or 2
/// nats: beside an offset, friction of one level does what friction of two does. Nothing where the answer has one
/// effect only, or needs all that it has.
std::optional<FewerEffects> fewer_effects(const FewerEffectsTask& task);

/// What models leave of a channel's readings that were left out: mean square, in units of the noise floor's, less 1.
struct AboveFloor {
  double by_none = 0.0;  ///< no effect added
  double by_fewer = 0.0;
  double by_answer = 0.0;
};

/// Fewer effects explain most of what there is and leave something, of which the answer's others take less than half in
/// every channel: an effect that is there would take a channel's error to the floor, so these make up for the form of
/// the fewer.
bool rest_is_form(const std::vector<AboveFloor>& channels);

/// A sentence that begins with the effects that are enough.
std::string to_string(const FewerEffects& fewer, const std::vector<EffectEntry>& answer);

}  // namespace lacuna
