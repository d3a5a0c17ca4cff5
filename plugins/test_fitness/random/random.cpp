#include <lacuna/plugin.h>
#include <lacuna/test_fitness.h>

namespace lacuna {

/// All tests are equal, so exploration ends with its first random test. Needs no model.
class Random : public TestFitness {
 public:
  std::string summary() const override;
  std::string unit() const override { return "1"; }
  std::size_t models(std::span<const double> parameters) const override;
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

std::string Random::summary() const { return "All tests are equal: the first random one is carried out"; }

std::size_t Random::models(std::span<const double>) const { return 0; }

double Random::score(const Test&, std::span<const TestPrediction>, std::span<const double>) const { return 0.0; }

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestFitness, lacuna::Random>("random"))
