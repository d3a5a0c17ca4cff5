#include <lacuna/error.h>
#include <lacuna/fitness_metric.h>
#include <lacuna/plugin.h>

#include <cmath>
#include <limits>

namespace lacuna {

/// The seed's subjective error (Bongard and Lipson, Eq. 1): the mean of |predicted − measured| over all samples and
/// channels, each channel in its own unit. A measured NaN is left out of sum and count; a predicted value that is not
/// finite makes the score infinite, and so does a comparison without measurements.
class MeanAbsoluteDifference : public FitnessMetric {
 public:
  std::string summary() const override;
  std::unique_ptr<ScoreAccumulator> accumulator(const ComparisonShape& shape,
                                                std::span<const double> parameters) const override;
};

namespace {

constexpr double kWorst = std::numeric_limits<double>::infinity();

class Accumulator : public ScoreAccumulator {
 public:
  explicit Accumulator(const ComparisonShape& shape)
      : channels_(shape.channels), values_(shape.samples * shape.channels) {}

  void add(std::span<const double> predicted, std::span<const double> measured) override {
    if (predicted.size() != channels_ || measured.size() != channels_)
      throw Error("a sample has " + std::to_string(predicted.size()) + " predicted and " +
                  std::to_string(measured.size()) + " measured values instead of " + std::to_string(channels_));
    for (std::size_t i = 0; i < channels_; ++i) add_value(predicted[i], measured[i]);
  }

  /// Later samples may agree exactly, and all may count.
  double bound() const override { return values_ > skipped_ ? sum_ / static_cast<double>(values_ - skipped_) : sum_; }

  double score() const override { return compared_ > 0 ? sum_ / static_cast<double>(compared_) : kWorst; }

  void reset() override {
    sum_ = 0.0;
    compared_ = 0;
    skipped_ = 0;
  }

 private:
  void add_value(double predicted, double measured) {
    if (std::isnan(measured)) {
      ++skipped_;
      return;
    }
    ++compared_;
    if (std::isfinite(predicted))
      sum_ += std::abs(predicted - measured);
    else
      sum_ = kWorst;
  }

  std::size_t channels_;
  std::size_t values_;
  std::size_t compared_ = 0;
  std::size_t skipped_ = 0;
  double sum_ = 0.0;
};

}  // namespace

std::string MeanAbsoluteDifference::summary() const {
  return "Mean of |predicted - measured| over all samples and channels";
}

std::unique_ptr<ScoreAccumulator> MeanAbsoluteDifference::accumulator(const ComparisonShape& shape,
                                                                      std::span<const double>) const {
  return std::make_unique<Accumulator>(shape);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::FitnessMetric, lacuna::MeanAbsoluteDifference>("mean_absolute_difference"))
