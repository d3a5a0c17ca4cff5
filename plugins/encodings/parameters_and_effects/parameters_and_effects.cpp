#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/model_encoding.h>
#include <lacuna/plugin.h>
#include <lacuna/value_genes.h>

#include <algorithm>

namespace lacuna {

/// Values and switches: one real gene per free parameter, as in the encoding `parameters`, then one from 0 to 1 per
/// optional effect, which is on where its gene is above 0.5. Models with other effects on are alternative hypotheses.
class ParametersAndEffects : public ModelEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where no effect is optional, a parameter has no finite bounds, or `at_most` is not a whole number.
  GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const override;
  /// `structure` names the optional effects that are on, in the model's order.
  ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                       std::span<const double> genome) const override;
};

namespace {

constexpr double kOn = 0.5;  // above it

std::vector<std::size_t> optional_effects(const ModelSpace& space) {
  std::vector<std::size_t> optional;
  for (std::size_t i = 0; i < space.effects.size(); ++i)
    if (space.effects[i].optional) optional.push_back(i);
  return optional;
}

const ParameterDeclaration& at_most() {
  static const ParameterDeclaration declared = {
      "at_most",
      "1",
      0.0,
      0.0,
      1000.0,
      Scale::linear,
      "Largest number of optional effects in a model: those with the largest switches; 0: any number"};
  return declared;
}

/// Largest number of optional effects that are on.
std::size_t most_on(std::span<const double> parameters, std::size_t optional) {
  const std::size_t most = count_parameter(at_most(), parameters[0]);
  return most == 0 ? optional : std::min(most, optional);
}

/// Switches that are on: of those above the middle the `most` largest, the first of equal ones.
std::vector<bool> switched_on(std::span<const double> switches, std::size_t most) {
  std::vector<std::size_t> on;
  for (std::size_t i = 0; i < switches.size(); ++i)
    if (switches[i] > kOn) on.push_back(i);
  std::stable_sort(on.begin(), on.end(), [&](std::size_t a, std::size_t b) { return switches[a] > switches[b]; });
  if (on.size() > most) on.resize(most);
  std::vector<bool> is_on(switches.size(), false);
  for (const std::size_t i : on) is_on[i] = true;
  return is_on;
}

}  // namespace

std::string ParametersAndEffects::summary() const {
  return "One gene per free parameter, and one per optional effect: whether the model has it";
}

ParameterDeclarations ParametersAndEffects::parameters() const { return {at_most()}; }

GenomeLayout ParametersAndEffects::layout(const ModelSpace& space, std::span<const double> parameters) const {
  const std::vector<std::size_t> optional = optional_effects(space);
  if (optional.empty())
    throw Error(
        "the model has no optional effect to switch; write optional = true into an entry of model.effects, or take "
        "encoding = \"parameters\"");
  most_on(parameters, optional.size());  // it counts
  GenomeLayout layout;
  append_value_genes(space.free, layout.genes);
  for (const std::size_t i : optional)
    layout.genes.push_back({"effect." + space.effects[i].id, "1", GeneKind::real, 0.0, 1.0});
  return layout;
}

ModelProposal ParametersAndEffects::decode(const ModelSpace& space, std::span<const double> parameters,
                                           std::span<const double> genome) const {
  const std::vector<std::size_t> optional = optional_effects(space);
  if (genome.size() != space.free.size() + optional.size())
    throw Error("a genome of " + std::to_string(genome.size()) + " genes does not fit a model with " +
                std::to_string(space.free.size()) + " free parameters and " + std::to_string(optional.size()) +
                " optional effects");
  const std::vector<bool> on = switched_on(genome.subspan(space.free.size()), most_on(parameters, optional.size()));
  ModelProposal model;
  model.values = values_of_genes(space.free, genome);
  for (std::size_t i = 0; i < optional.size(); ++i) {
    if (on[i])
      model.structure += (model.structure.empty() ? "" : " + ") + space.effects[optional[i]].id;
    else
      model.without.push_back(optional[i]);
  }
  if (model.structure.empty()) model.structure = "no optional effect";
  return model;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::ModelEncoding, lacuna::ParametersAndEffects>("parameters_and_effects"))
