#include "eea/definition/test_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {

TestValue::TestValue(std::vector<Part> parts) : parts_(std::move(parts)) {
  for (const Part& part : parts_) {
    const Chosen<TestFitness>& fitness = part.fitness;
    models_of_part_.push_back(
        guarded_call(fitness.origin, "models", [&] { return fitness->models(fitness.parameters); }));
    wants_slopes_ |=
        guarded_call(fitness.origin, "wants_slopes", [&] { return fitness->wants_slopes(fitness.parameters); });
  }
  if (!parts_.empty()) models_ = *std::max_element(models_of_part_.begin(), models_of_part_.end());
}

std::string TestValue::name() const {
  std::string name;
  for (const Part& part : parts_)
    name += name.empty() ? part.fitness.origin.name : fmt::format(" + {:g} {}", part.weight, part.fitness.origin.name);
  return name;
}

std::string TestValue::unit() const { return parts_.empty() ? std::string() : parts_.front().fitness->unit(); }

double TestValue::score(const Test& test, std::span<const TestPrediction> predictions) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) sum += parts_[i].weight * score_of_part(i, test, predictions);
  return sum;
}

double TestValue::score_of_part(std::size_t part, const Test& test, std::span<const TestPrediction> predictions) const {
  const Chosen<TestFitness>& fitness = parts_[part].fitness;
  const auto judges = predictions.first(std::min(predictions.size(), models_of_part_[part]));
  return guarded_call(fitness.origin, "score", [&] { return fitness->score(test, judges, fitness.parameters); });
}

std::string TestValue::why_not_finite(const Test& test, std::span<const TestPrediction> predictions) const {
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (const double score = score_of_part(i, test, predictions); !std::isfinite(score))
      return fmt::format("{}: its score of the test is {}", to_string(parts_[i].fitness.origin), score);
  return {};
}

}  // namespace lacuna
