#include "bad_effect.h"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <vector>

/// Components that describe themselves well and do one thing each that only several calls, threads, processes or values
/// bring to light.
namespace {

/// An effect that pushes a joint.
class Push : public bad::Effect {
 public:
  lacuna::EffectDescription describe() const override {
    lacuna::EffectDescription description = bad::Effect::describe();
    description.equation = "tau = size";
    description.placements = {lacuna::ElementKind::joint};
    description.parameters = {{"size", "{force}", 1.0, 0.0, 10.0, lacuna::Scale::linear, "Of the push"}};
    return description;
  }
  void add_loads(const lacuna::StepView& view, const lacuna::EffectContext& context, std::span<const double>,
                 lacuna::StepLoads& loads) const override {
    const auto joint = static_cast<std::size_t>(context.elements[0]);
    loads.joints[static_cast<std::size_t>(view.first_coordinate[joint])].force += push(context.parameters[0], view);
  }

 private:
  virtual double push(double size, const lacuna::StepView& view) const = 0;
};

class CountsItsCalls : public Push {
  double push(double size, const lacuna::StepView&) const override {
    static double calls = 0.0;
    return size + ++calls;
  }
};

class KnowsItsProcess : public Push {
  double push(double size, const lacuna::StepView&) const override {
    static const double born = 1e-3 * getppid();
    return size + born + static_cast<double>(reinterpret_cast<std::uintptr_t>(&born) % 1009);
  }
};

class KnowsOfOthers : public Push {
  double push(double size, const lacuna::StepView&) const override {
    static std::atomic<int> inside = 0;
    ++inside;
    usleep(100);
    const int others = inside-- - 1;
    return size + others;
  }
};

class DividesByZero : public Push {
  double push(double size, const lacuna::StepView&) const override { return 1.0 / size; }
};

class ThrowsAtTheBound : public Push {
  double push(double size, const lacuna::StepView&) const override {
    if (size >= 10.0) throw std::domain_error("too large");
    return size;
  }
};

class Aborts : public Push {
  double push(double, const lacuna::StepView&) const override { std::abort(); }
};

class Hangs : public Push {
  double push(double, const lacuna::StepView&) const override {
    for (;;) pause();
  }
};

class Sound : public Push {
  double push(double size, const lacuna::StepView& view) const override { return size * view.positions[0]; }
};

/// Remembers every sample, and takes what was not measured for 0.
class Hoarding : public lacuna::ScoreAccumulator {
 public:
  void add(std::span<const double> predicted, std::span<const double> measured) override {
    samples_.emplace_back(predicted.begin(), predicted.end());
    for (std::size_t i = 0; i < predicted.size(); ++i)
      sum_ += measured[i] == measured[i] ? (predicted[i] - measured[i]) * (predicted[i] - measured[i]) : predicted[i];
  }
  double bound() const override { return 0.0; }
  double score() const override { return sum_; }
  void reset() override { sum_ = 0.0; }

 private:
  std::vector<std::vector<double>> samples_;
  double sum_ = 0.0;
};

class HoardingMetric : public lacuna::FitnessMetric {
 public:
  std::string summary() const override { return "Broken on purpose"; }
  std::unique_ptr<lacuna::ScoreAccumulator> accumulator(const lacuna::ComparisonShape&,
                                                        std::span<const double>) const override {
    return std::make_unique<Hoarding>();
  }
};

class LeavesTheBounds : public lacuna::MutationOperator {
 public:
  std::string summary() const override { return "Broken on purpose"; }
  lacuna::Genome vary(std::span<const lacuna::Genome> parents, const lacuna::GenomeLayout&, std::span<const double>,
                      lacuna::RandomStream& random) const override {
    lacuna::Genome child = parents.front();
    child[0] += 100.0 * random.uniform();
    return child;
  }
};

}  // namespace

#if defined(LACUNA_ENDS)
LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, Aborts>("aborts"),
              lacuna::component<lacuna::PhysicalEffect, Hangs>("hangs"))
#else
LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, CountsItsCalls>("counts_its_calls"),
              lacuna::component<lacuna::PhysicalEffect, KnowsItsProcess>("knows_its_process"),
              lacuna::component<lacuna::PhysicalEffect, KnowsOfOthers>("knows_of_others"),
              lacuna::component<lacuna::PhysicalEffect, DividesByZero>("divides_by_zero"),
              lacuna::component<lacuna::PhysicalEffect, ThrowsAtTheBound>("throws_at_the_bound"),
              lacuna::component<lacuna::PhysicalEffect, Sound>("sound"),
              lacuna::component<lacuna::FitnessMetric, HoardingMetric>("hoarding_metric"),
              lacuna::component<lacuna::MutationOperator, LeavesTheBounds>("leaves_the_bounds"))
#endif
