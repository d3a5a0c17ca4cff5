#include "random.h"

#include <lacuna/plugin.h>

namespace lacuna {

std::string Random::summary() const { return "All tests are worth the same: the first random one is carried out"; }

std::size_t Random::models(std::span<const double>) const { return 0; }

double Random::score(const Test&, std::span<const TestPrediction>, std::span<const double>) const { return 0.0; }

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestFitness, lacuna::Random>("random"))
