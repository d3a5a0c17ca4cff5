#include "app/workspace/component_details.h"

#include "foundation/address.h"
#include "foundation/placement_unit.h"
#include "foundation/text/problem.h"
#include "loading/component_kinds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> placement_names(const EffectDescription& effect) {
  std::vector<std::string> names;
  for (const ElementKind kind : effect.placements) names.emplace_back(to_string(kind));
  return names;
}

ParameterDeclarations parameters_of(const PluginCatalog& catalog, const PluginListing& listing) {
  ParameterDeclarations parameters;
  for_each_component_kind([&]<class Interface>(std::type_identity<Interface>) {
    if constexpr (requires(const Interface& one) { one.parameters(); }) {
      if (listing.kind != ComponentKind<Interface>::noun) return;
      const auto component = catalog.make<Interface>(listing.name);
      parameters =
          guarded_call(catalog.origin<Interface>(listing.name), "parameters", [&] { return component->parameters(); });
    }
  });
  return parameters;
}

ComponentDetails details_of(const PluginCatalog& catalog, const PluginListing& listing) {
  ComponentDetails details;
  details.listing = listing;
  if (listing.kind == "effect") {
    const PhysicalEffect& effect = catalog.get<PhysicalEffect>(listing.name);
    details.effect =
        guarded_call(catalog.origin<PhysicalEffect>(listing.name), "describe", [&] { return effect.describe(); });
    details.parameters = details.effect->parameters;
  } else {
    details.parameters = parameters_of(catalog, listing);
  }
  return details;
}

const char* name_of(Scale scale) { return scale == Scale::linear ? "linear" : "logarithmic"; }

Json json_of(const ParameterDeclaration& parameter) {
  return {{"name", parameter.name},
          {"unit", unit_in_words(parameter.unit)},
          {"default", parameter.default_value},
          {"lower", parameter.lower},
          {"upper", parameter.upper},
          {"scale", name_of(parameter.scale)},
          {"description", parameter.description}};
}

/// A line "name   content" of the page, nothing where there is no content.
std::string parameter_line(const std::string& name, const std::string& content) {
  return content.empty() ? "" : fmt::format("{:<12}{}\n", name, content);
}

std::string parameter_table(const ParameterDeclarations& parameters) {
  std::size_t name_width = 0, unit_width = 0;
  for (const ParameterDeclaration& parameter : parameters) {
    name_width = std::max(name_width, parameter.name.size());
    unit_width = std::max(unit_width, unit_in_words(parameter.unit).size());
  }
  std::string text;
  for (const ParameterDeclaration& parameter : parameters)
    text += fmt::format("  {:<{}}  {:<{}}  {:g}, from {:g} to {:g}{}  {}\n", parameter.name, name_width,
                        unit_in_words(parameter.unit), unit_width, parameter.default_value, parameter.lower,
                        parameter.upper, parameter.scale == Scale::logarithmic ? " (logarithmic)" : "",
                        parameter.description);
  return text;
}

}  // namespace

std::vector<ComponentDetails> details_of(const PluginCatalog& catalog, const std::string& name) {
  std::vector<ComponentDetails> found;
  std::vector<std::string> names;
  for (const PluginListing& listing : catalog.list()) {
    names.push_back(listing.name);
    if (listing.name != name) continue;
    if (!listing.problem.empty()) throw Error(listing.problem);
    found.push_back(details_of(catalog, listing));
  }
  if (found.empty())
    throw_problem(
        {}, "there is no plugin \"" + name + "\"" + did_you_mean(name, names) + "; lacuna plugins list shows all");
  return found;
}

std::string text_of(const ComponentDetails& details, bool verbose) {
  const PluginListing& listing = details.listing;
  std::string text = fmt::format("{} {}: {}\n", listing.kind, listing.name, listing.summary);
  if (details.effect) {
    const EffectDescription& effect = *details.effect;
    text += parameter_line("equation", effect.equation);
    text += parameter_line("place on", fmt::format("{}", fmt::join(placement_names(effect), ", ")));
    text += parameter_line("shows in", effect.regime);
    text += parameter_line("look-alikes", fmt::format("{}", fmt::join(effect.look_alikes, ", ")));
    text += parameter_line("literature", effect.literature);
  }
  text += details.parameters.empty() ? "no parameters\n" : "parameters: unit, default and bounds, meaning\n";
  text += parameter_table(details.parameters);
  if (!verbose) return text;
  text += parameter_line("file", listing.file.string());
  text += parameter_line("sha256", listing.sha256);
  text += parameter_line("build", listing.build_id);
  return text;
}

Json json_of(const ComponentDetails& details) {
  const PluginListing& listing = details.listing;
  Json json = {{"kind", listing.kind}, {"name", listing.name}, {"summary", listing.summary}};
  if (details.effect) {
    json["equation"] = details.effect->equation;
    json["placements"] = placement_names(*details.effect);
    json["regime"] = details.effect->regime;
    json["look_alikes"] = details.effect->look_alikes;
    json["literature"] = details.effect->literature;
  }
  json["parameters"] = Json::array();
  for (const ParameterDeclaration& parameter : details.parameters) json["parameters"].push_back(json_of(parameter));
  json["file"] = listing.file.string();
  json["sha256"] = listing.sha256;
  json["build"] = listing.build_id;
  return json;
}

}  // namespace lacuna
