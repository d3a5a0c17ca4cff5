#pragma once

#include "eea/ensemble/ensemble_band.h"
#include "storage/core/records.h"

#include <lacuna/trial.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lacuna {

/// Whether 95 % bands hold what they promise, on trials that were new to the models at the time.

/// Fewer trials say nothing about a band.
inline constexpr std::size_t kFewestHeldOut = 3;

/// A trial that models predicted before they were fitted to it.
struct HeldOutTrial {
  int number = 0;  ///< of the trial within its run
  int pass = 0;    ///< whose models predicted it
  /// One a channel of the model's: of each reading |measured − mean| / half-width.
  std::vector<std::vector<double>> ratios = {};
};

/// A share with its 95 % interval, which a bootstrap over whole trials gives: readings of one trial are not
/// independent.
struct Coverage {
  double share = kNotKnown, lower = kNotKnown, upper = kNotKnown;
};

/// What held-out trials say of the band of a channel; all trials weigh the same.
struct ChannelSupport {
  std::size_t trials = 0;    ///< that measured it
  Coverage inside;           ///< readings within the band
  double error = kNotKnown;  ///< root mean square of (measured − mean) / (half-width / 1.96); 1 where the band is right
  double factor = kNotKnown;  ///< by which the band would hold 95 % of the readings; above 1 it is too narrow
                              ///< infinite: none does, for it has no width where readings lie off it

  /// By which the band is to be wider: 1 where it is wide enough, where too few trials say so, or where none helps.
  double widening() const;
};

struct BandSupport {
  std::vector<HeldOutTrial> trials;
  std::vector<ChannelSupport> channels;  ///< one a channel of the model's
  ChannelSupport all;                    ///< the readings of all channels together
  /// Readings within the widened bands, each trial's with factors that the other trials alone gave.
  Coverage widened;

  bool enough() const { return all.trials >= kFewestHeldOut; }
};

/// How far each reading lies from the mean, in half-widths: `HeldOutTrial::ratios`. `map`: channel of the band's, for
/// each of the trial's. What was not measured is left out; what lies off a band without width is infinitely far.
std::vector<std::vector<double>> band_ratios(const EnsembleBand& band, const Trial& trial,
                                             const std::vector<Eigen::Index>& map);

/// `seed`: of the bootstrap. Each trial has as many channels as the others.
BandSupport support_of(std::vector<HeldOutTrial> trials, std::uint64_t seed = 1);

/// Makes each channel as wide as its support says.
void widen(EnsembleBand& band, const BandSupport& support);

}  // namespace lacuna
