#pragma once

#include "eea/ensemble/ensemble_band.h"
#include "storage/core/records.h"

#include <lacuna/trial.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lacuna {

/// Checks whether 95 % bands contain 95 % of the readings, on trials that were new to the models. With fewer trials a
/// band cannot be checked.

/// Fewer trials say nothing about a band.
inline constexpr std::size_t kFewestHeldOut = 3;

/// A trial predicted by models before they were fitted to it.
struct HeldOutTrial {
  int number = 0;  ///< of the trial within its run
  int pass = 0;    ///< pass whose models predicted it
  /// One a channel of the model's: of each reading |measured − mean| / half-width.
  std::vector<std::vector<double>> ratios = {};
};

/// A share with its 95 % interval by a bootstrap over whole trials, because readings of one trial are not independent.
struct Coverage {
  double share = kNotKnown, lower = kNotKnown, upper = kNotKnown;
};

/// How well held-out trials confirm the band of a channel; all trials have the same weight.
struct ChannelSupport {
  std::size_t trials = 0;     ///< that measured it
  Coverage inside;            ///< readings within the band
  double error = kNotKnown;   ///< root mean square of (measured − mean) / (half-width / 1.96); 1 for a right band
  double factor = kNotKnown;  ///< factor on the band's width with which 95 % of the readings lie inside; above 1 the
                              ///< band is too narrow

  /// Factor by which the band must be widened: 1 where it is wide enough, has too few trials, or no factor helps.
  double widening() const;
};

struct BandSupport {
  std::vector<HeldOutTrial> trials;
  std::vector<ChannelSupport> channels;  ///< one per channel of the model's
  ChannelSupport all;                    ///< the readings of all channels together
  /// Readings within the widened bands, each trial's with factors that the other trials alone gave.
  Coverage widened;

  bool enough() const { return all.trials >= kFewestHeldOut; }
};

/// Distance of each reading from the mean in half-widths: `HeldOutTrial::ratios`. `map`: channel of the band for each
/// channel of the trial. Channels that were not measured are left out; readings outside a band of zero width are
/// infinitely far.
std::vector<std::vector<double>> band_ratios(const EnsembleBand& band, const Trial& trial,
                                             const std::vector<Eigen::Index>& map);

/// `seed`: of the bootstrap. All trials have the same number of channels.
BandSupport support_of(std::vector<HeldOutTrial> trials, std::uint64_t seed = 1);

/// Widens each channel by the factor of its support.
void widen(EnsembleBand& band, const BandSupport& support);

}  // namespace lacuna
