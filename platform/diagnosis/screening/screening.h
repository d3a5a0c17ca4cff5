#pragma once

#include "diagnosis/noise/whitened.h"
#include "diagnosis/screening/probe.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// What the score test says of one probe.
struct ProbeScore {
  std::size_t hypothesis = 0;
  std::size_t probe = 0;  ///< of the hypothesis
  double deviance = 0.0;  ///< score statistic: by how much twice the log likelihood would rise; χ² of 1 by chance
  double size = 0.0;      ///< best multiple of the probe, to first order
  double seen = 0.0;      ///< share of its response's power that the model's values and starts cannot take up
  double noncentrality = 0.0;  ///< squared norm of what can be seen of it at its size
};

struct Screening {
  std::vector<ProbeScore> scores;    ///< best first
  double chance_95 = 0.0;            ///< what the largest deviance of all probes stays below in 95 % of noise draws
  double p = 1.0;                    ///< how often noise alone reaches the best one's deviance, at least 1/(draws + 1)
  double p_low = 1.0, p_high = 1.0;  ///< were that deviance as much more, or less, as last digits may make it
};

/// Scores every probe and holds the best against the largest of all under `draws` draws of white noise through the same
/// projections (P. H. Westfall and
/// S. S. Young, Resampling-Based Multiple Testing, 1993).
Screening screen(const WhitenedSegments& whitened, const std::vector<std::vector<Probe>>& probes, std::uint64_t seed);

inline constexpr int kNullDraws = 1999;

}  // namespace lacuna
