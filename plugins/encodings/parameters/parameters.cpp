#include <lacuna/error.h>
#include <lacuna/model_encoding.h>
#include <lacuna/plugin.h>
#include <lacuna/value_genes.h>

namespace lacuna {

/// One real gene per free parameter: the value itself, SI, within its search bounds. Decoding clamps to the bounds.
class Parameters : public ModelEncoding {
 public:
  std::string summary() const override;
  GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const override;
  ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                       std::span<const double> genome) const override;
};

std::string Parameters::summary() const { return "One gene per free parameter: its value in SI units"; }

GenomeLayout Parameters::layout(const ModelSpace& space, std::span<const double>) const {
  if (space.free.empty()) throw Error("the model has no free parameter to encode; name some under [model.free]");
  GenomeLayout layout;
  append_value_genes(space.free, layout.genes);
  return layout;
}

ModelProposal Parameters::decode(const ModelSpace& space, std::span<const double>,
                                 std::span<const double> genome) const {
  if (genome.size() != space.free.size())
    throw Error("a genome of " + std::to_string(genome.size()) + " genes does not fit a model with " +
                std::to_string(space.free.size()) + " free parameters");
  ModelProposal model;
  model.values = values_of_genes(space.free, genome);
  return model;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::ModelEncoding, lacuna::Parameters>("parameters"))
