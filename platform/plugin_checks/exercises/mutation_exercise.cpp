#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/genome_inputs.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr std::uint64_t kChildren = 100;

class MutationExercise : public Exercise {
 public:
  explicit MutationExercise(const MutationOperator& mutation) : mutation_(mutation), layout_(taken_layout()) {}

  ParameterDeclarations declared() const override { return mutation_.parameters(); }

  void go(const Setting& setting, Transcript& transcript) const override {
    for (std::uint64_t key = 0; key < kChildren; ++key) {
      RandomStream random = stream_of(key);
      transcript.add("vary", mutation_.vary(parents(layout_, key), layout_, setting, random));
    }
  }

  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    if (mutation_.parents() == 0) return {"parents() is 0; a child needs at least one parent"};
    for (const Setting& setting : settings())
      if (const std::string fault = child_fault(setting); !fault.empty()) {
        broken.push_back("a child does not match the layout: " + fault + "; bring genes back with `reflected_value`");
        break;
      }
    if (gives_one_child()) broken.emplace_back("all random streams give the same child; draw from the stream");
    return broken;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    const std::vector<Genome> of_two = parents(layout_, 1);
    RandomStream random = stream_of(1);
    return {repeated_call("vary", true, 100, [&] { mutation_.vary(of_two, layout_, setting, random); })};
  }

 private:
  std::vector<Genome> parents(const GenomeLayout& layout, std::uint64_t key) const {
    RandomStream random = stream_of(key);
    std::vector<Genome> all;
    for (std::size_t i = 0; i < std::max<std::size_t>(mutation_.parents(), 1); ++i)
      all.push_back(uniform_genome(layout, random));
    return all;
  }

  /// An operator for one encoding refuses other layouts with an `Error`.
  GenomeLayout taken_layout() const {
    try {
      RandomStream random = stream_of(1);
      mutation_.vary(parents(mixed_layout(), 1), mixed_layout(), settings_of(mutation_.parameters()).front(), random);
      return mixed_layout();
    } catch (const Error&) {
      return shape_layout();
    }
  }

  /// The values of its parameters; an operator may refuse some of them.
  std::string child_fault(const Setting& setting) const try {
    for (std::uint64_t key = 0; key < kChildren; ++key) {
      RandomStream random = stream_of(key);
      const std::string fault = genome_fault(layout_, mutation_.vary(parents(layout_, key), layout_, setting, random));
      if (!fault.empty()) return fault;
    }
    return {};
  } catch (const Error&) {
    if (setting == settings().front()) throw;
    return {};
  }

  bool gives_one_child() const {
    const Setting setting = settings().front();
    const std::vector<Genome> same = parents(layout_, 1);
    RandomStream first = stream_of(0);
    const Genome child = mutation_.vary(same, layout_, setting, first);
    for (std::uint64_t key = 1; key < kChildren; ++key) {
      RandomStream random = stream_of(key);
      if (mutation_.vary(same, layout_, setting, random) != child) return false;
    }
    return true;
  }

  const MutationOperator& mutation_;
  const GenomeLayout layout_;
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const MutationOperator& mutation, const ExerciseInputs&) {
  return std::make_unique<MutationExercise>(mutation);
}

}  // namespace lacuna
