#pragma once

#include "plugin_checks/genome_inputs.h"
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

/// Whether a genome is one of the layout's: a value a gene, within its bounds, whole where it must be.
inline testing::AssertionResult fits(const GenomeLayout& layout, const Genome& genome) {
  const std::string fault = genome_fault(layout, genome);
  return fault.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << fault;
}

}  // namespace lacuna
