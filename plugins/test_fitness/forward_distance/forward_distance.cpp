#include "forward_distance.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

namespace lacuna {

std::string ForwardDistance::summary() const { return "How far forward the best model gets, m"; }

std::size_t ForwardDistance::models(std::span<const double>) const { return 1; }

double ForwardDistance::score(const Test&, std::span<const TestPrediction> predictions, std::span<const double>) const {
  if (predictions.empty())
    throw Error("there is no prediction to take the distance from; one model must predict the test");
  const TimeSeries::Samples& path = predictions.front().centre_of_mass.samples;
  if (path.rows() == 0 || path.cols() == 0)
    throw Error("the predicted path of the centre of mass has no sample; is the test longer than a control period?");
  constexpr int kForward = 0;  // x
  return path(path.rows() - 1, kForward) - path(0, kForward);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestFitness, lacuna::ForwardDistance>("forward_distance"))
