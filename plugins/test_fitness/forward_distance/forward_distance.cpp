#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/test_fitness.h>

namespace lacuna {

/// Forward distance of the best model's centre of mass during the test, m.
class ForwardDistance : public TestFitness {
 public:
  std::string summary() const override;
  std::string unit() const override { return "m"; }
  std::size_t models(std::span<const double> parameters) const override;
  /// Throws `Error` where there is no prediction or the path has no sample.
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

std::string ForwardDistance::summary() const { return "How far forward the best model gets, m"; }

std::size_t ForwardDistance::models(std::span<const double>) const { return 1; }

double ForwardDistance::score(const Test&, std::span<const TestPrediction> predictions, std::span<const double>) const {
  if (predictions.empty()) throw Error("there is no prediction of the distance; one model must predict the test");
  const TimeSeries::Samples& path = predictions.front().centre_of_mass.samples;
  if (path.rows() == 0 || path.cols() == 0)
    throw Error("the predicted path of the centre of mass has no sample; make the test longer than a control period");
  constexpr int kForward = 0;  // x
  return path(path.rows() - 1, kForward) - path(0, kForward);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestFitness, lacuna::ForwardDistance>("forward_distance"))
