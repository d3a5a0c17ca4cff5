#pragma once

#include <vector>

namespace hidden_effects {

/// `values` through a Butterworth filter of second order forwards and backwards, so without delay: what is above
/// `cutoff` Hz falls with the fourth power. The ends are continued by point reflection (F. Gustafsson, IEEE Trans.
/// Signal Processing 44 (1996) 988-992, on such ends). `interval` in s.
std::vector<double> zero_phase(const std::vector<double>& values, double interval, double cutoff);

/// Up to which frequency, Hz, signals stand out of the noise: the highest below which their power density, averaged
/// over the signals and over neighbours, stays above thirty times that of the upper half of the band. Between `least`
/// and `most`.
double bandwidth(const std::vector<std::vector<double>>& signals, double interval, double least, double most);

}  // namespace hidden_effects
