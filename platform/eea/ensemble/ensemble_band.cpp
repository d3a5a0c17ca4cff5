#include "eea/ensemble/ensemble_band.h"

#include "foundation/statistics.h"

#include <cmath>
#include <cstddef>

namespace lacuna {
namespace {

/// Factor on the standard deviation between this number of models.
double spread_factor(std::size_t models) {
  const auto count = static_cast<double>(models);
  const double t = within_95_of_students_t(count - 1.0);
  return t * std::sqrt(1.0 + 1.0 / count);
}

}  // namespace

EnsembleBand band_of(const std::vector<TimeSeries::Samples>& predictions, const std::vector<double>& noise) {
  const auto count = static_cast<double>(predictions.size());
  EnsembleBand band{predictions.front(), TimeSeries::Samples::Zero(predictions[0].rows(), predictions[0].cols())};
  for (std::size_t i = 1; i < predictions.size(); ++i) band.mean += predictions[i];
  band.mean /= count;
  if (predictions.size() > 1) {
    for (const TimeSeries::Samples& prediction : predictions)
      band.half_width.array() += (prediction - band.mean).array().square();
    const double factor = spread_factor(predictions.size());
    band.half_width *= factor * factor / (count - 1.0);
  }
  for (std::size_t c = 0; c < noise.size(); ++c) {
    const double reading = std::isfinite(noise[c]) ? kWithin95 * noise[c] : 0.0;
    band.half_width.col(static_cast<Eigen::Index>(c)).array() += reading * reading;
  }
  band.half_width = band.half_width.cwiseSqrt();
  return band;
}

}  // namespace lacuna
