#pragma once

#include "plugins/built_catalog.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lacuna {

/// Default values of a component's parameters, in order.
template <class Component>
std::vector<double> default_values(const Component& component) {
  std::vector<double> values;
  for (const ParameterDeclaration& declaration : component.parameters()) values.push_back(declaration.default_value);
  return values;
}

/// Runs a check on every plugin of a kind in this build, with its defaults: `check(component, parameters)`. A failure
/// names the plugin.
template <class Interface, class Check>
void on_every(Check&& check) {
  int checked = 0;
  for (const PluginListing& listing : built_catalog().list()) {
    if (listing.kind != ComponentKind<Interface>::noun) continue;
    SCOPED_TRACE(listing.kind + " " + listing.name);
    const Interface& component = built_catalog().get<Interface>(listing.name);
    check(component, default_values(component));
    ++checked;
  }
  EXPECT_GT(checked, 0) << "there is no " << ComponentKind<Interface>::noun << " in this build";
}

/// A stream of one number as its key.
inline RandomStream stream_of(std::uint64_t key) { return RandomStream(std::vector<std::uint64_t>{key}); }

/// Whether a genome is one of the layout's: a value a gene, within its bounds, whole where it must be.
inline testing::AssertionResult fits(const GenomeLayout& layout, const Genome& genome) {
  if (genome.size() != layout.size())
    return testing::AssertionFailure() << genome.size() << " values for " << layout.size() << " genes";
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const Gene& gene = layout.genes[i];
    if (!(genome[i] >= gene.lower && genome[i] <= gene.upper))
      return testing::AssertionFailure() << gene.name << " = " << genome[i] << " is beyond its bounds";
    if (gene.kind == GeneKind::integer && genome[i] != std::floor(genome[i]))
      return testing::AssertionFailure() << gene.name << " = " << genome[i] << " is no whole number";
  }
  return testing::AssertionSuccess();
}

/// Real and whole-number genes of different ranges, one of them of one value only.
inline GenomeLayout mixed_layout() {
  GenomeLayout layout;
  layout.genes = {{"mass", "kg", GeneKind::real, 1.0, 7.0},     {"delay", "s", GeneKind::real, 0.0, 0.2},
                  {"parent", "1", GeneKind::integer, 0.0, 3.0}, {"offset", "rad", GeneKind::real, -2.0, 2.0},
                  {"teeth", "1", GeneKind::integer, -5, 20.0},  {"fixed", "m", GeneKind::real, 0.3, 0.3},
                  {"gain", "1", GeneKind::real, 0.5, 1.5},      {"kind", "1", GeneKind::integer, 0.0, 1.0}};
  return layout;
}

/// The same genes in rows of two.
inline GenomeLayout layout_in_rows() {
  GenomeLayout layout = mixed_layout();
  layout.row = 2;
  return layout;
}

}  // namespace lacuna
