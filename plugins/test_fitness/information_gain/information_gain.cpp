#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/test_fitness.h>

#include <Eigen/Cholesky>

#include <limits>

namespace lacuna {

/// Expected information of a test about the models' free values: the mean over the models of the decrease of their
/// uncertainty given the trials so far and the ranges, in nats, to first order (Bayesian D-optimality).
///
/// Literature: D. V. Lindley, Annals of Mathematical Statistics 27 (1956) 986-1005; K. Chaloner and I. Verdinelli,
/// Statistical Science 10 (1995) 273-304.
class InformationGain : public TestFitness {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  std::string unit() const override { return "1"; }
  std::size_t models(std::span<const double> parameters) const override;
  bool wants_slopes(std::span<const double>) const override { return true; }
  /// Throws `Error` where there is no prediction or the noise is unknown.
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

namespace {

enum Parameter : std::size_t { kModels };

/// For a positive definite matrix; NaN for any other.
double log_determinant(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return std::numeric_limits<double>::quiet_NaN();
  return 2.0 * factor.matrixLLT().diagonal().array().log().sum();
}

/// Squared standard deviations over the whole range of a value, all channels together.
Eigen::MatrixXd information_of(const TestPrediction& prediction) {
  const auto values = static_cast<Eigen::Index>(prediction.slopes.size());
  const TimeSeries::Samples& readings = prediction.sensors.samples;
  if (static_cast<Eigen::Index>(prediction.noise.size()) != readings.cols())
    throw Error("the noise of the sensors is unknown, so the information of readings cannot be computed");
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(values, values);
  Eigen::MatrixXd slopes(readings.rows(), values);
  for (Eigen::Index channel = 0; channel < readings.cols(); ++channel) {
    slopes.setZero();
    for (Eigen::Index k = 0; k < values; ++k)
      if (const TimeSeries::Samples& slope = prediction.slopes[static_cast<std::size_t>(k)]; slope.size() > 0)
        slopes.col(k) = slope.col(channel) / prediction.noise[static_cast<std::size_t>(channel)];
    information += slopes.transpose() * slopes;
  }
  return information;
}

}  // namespace

std::string InformationGain::summary() const {
  return "Expected information of a test about the models' free values, in nats";
}

ParameterDeclarations InformationGain::parameters() const {
  return {{"models", "1", 1.0, 1.0, 100.0, Scale::linear, "Number of models over which the mean is taken"}};
}

std::size_t InformationGain::models(std::span<const double> parameters) const {
  return count_parameter(this->parameters()[kModels], parameters[kModels]);
}

double InformationGain::score(const Test&, std::span<const TestPrediction> predictions, std::span<const double>) const {
  if (predictions.empty()) throw Error("there is no prediction to evaluate; one model must predict the test");
  double sum = 0.0;
  for (const TestPrediction& prediction : predictions) {
    if (prediction.slopes.empty()) continue;  // no free values, so no information
    const Eigen::MatrixXd& known = prediction.information;
    sum += 0.5 * (log_determinant(known + information_of(prediction)) - log_determinant(known));
    if (!prediction.sensors.samples.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  }
  return sum / static_cast<double>(predictions.size());
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestFitness, lacuna::InformationGain>("information_gain"))
