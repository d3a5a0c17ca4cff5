#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/checked_plugin.h"
#include "app/workspace/component_details.h"
#include "app/workspace/new_plugin.h"
#include "foundation/text/problem.h"
#include "loading/component_kinds.h"
#include "loading/plugin_catalog.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

struct PluginsOptions {
  CommonOptions common;
  std::string name;
  std::string kind;      ///< of what is listed; empty: all
  bool verbose = false;  ///< with files and digests
};

void add_plugins_options(CLI::App& command, CommonOptions& options) {
  add_plugin_path_option(command, options);
  add_result_option(command, "json", options.json, "Write results as JSON to FILE (default: standard output)");
}

Json listing_json(const PluginListing& listing) {
  Json json = {{"kind", listing.kind},          {"name", listing.name},     {"summary", listing.summary},
               {"file", listing.file.string()}, {"sha256", listing.sha256}, {"build", listing.build_id}};
  if (!listing.problem.empty()) json["problem"] = listing.problem;
  if (!listing.remark.empty()) json["remark"] = listing.remark;
  return json;
}

void print_listings(const std::vector<PluginListing>& listings, bool verbose) {
  std::size_t kind = 0, name = 0;
  for (const PluginListing& listing : listings) {
    kind = std::max(kind, listing.kind.size());
    name = std::max(name, listing.name.size());
  }
  for (const PluginListing& listing : listings) {
    const std::string text = listing.problem.empty() ? listing.summary : "cannot be used: " + listing.problem;
    fmt::print("{:<{}}  {:<{}}  {}\n", listing.kind, kind, listing.name, name, text);
    if (verbose) fmt::print("{:<{}}{}\n", "", kind + name + 4, listing.file.string());
  }
}

std::vector<std::string> component_kinds() {
  std::vector<std::string> kinds;
  for_each_component_kind(
      [&]<class Interface>(std::type_identity<Interface>) { kinds.emplace_back(ComponentKind<Interface>::noun); });
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

void check_kind(const std::string& kind) {
  const std::vector<std::string> kinds = component_kinds();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw_problem({}, fmt::format("--kind {}: there is no such kind{}; the kinds are {}", kind,
                                  did_you_mean(kind, kinds), fmt::join(kinds, ", ")));
}

void list_plugins(const PluginsOptions& options) {
  if (!options.kind.empty()) check_kind(options.kind);
  const PluginCatalog catalog(plugin_search_path(options.common.plugin_paths));
  std::vector<PluginListing> listings = catalog.list();
  if (!options.kind.empty())
    std::erase_if(listings, [&](const PluginListing& listing) { return listing.kind != options.kind; });
  if (options.common.json) {
    Json json = {{"components", Json::array()}, {"problems", catalog.problems()}};
    for (const PluginListing& listing : listings) json["components"].push_back(listing_json(listing));
    write_output(*options.common.json, json.dump(2) + "\n");
    return;
  }
  print_listings(listings, options.verbose);
  std::fflush(stdout);
  for (const std::string& problem : catalog.problems()) std::fprintf(stderr, "%s\n", problem.c_str());
  for (const PluginListing& listing : listings)
    if (!listing.remark.empty()) std::fprintf(stderr, "%s\n", listing.remark.c_str());
}

void show_plugin(const PluginsOptions& options) {
  const PluginCatalog catalog(plugin_search_path(options.common.plugin_paths));
  const std::vector<ComponentDetails> found = details_of(catalog, options.name);
  if (options.common.json) {
    Json json = {{"components", Json::array()}};
    for (const ComponentDetails& details : found) json["components"].push_back(json_of(details));
    write_output(*options.common.json, json.dump(2) + "\n");
    return;
  }
  for (const ComponentDetails& details : found) std::fputs(text_of(details, options.verbose).c_str(), stdout);
}

}  // namespace

void add_plugins_command(CLI::App& program) {
  CLI::App* plugins = program.add_subcommand("plugins", "List, show, check and write plugins");
  plugins->require_subcommand(1);
  auto options = std::make_shared<PluginsOptions>();  // shared: CLI11 keeps the callbacks, which must own the options
  CLI::App* list = plugins->add_subcommand("list", "List all plugins: effects, metrics, formats and other kinds");
  list->add_option("--kind", options->kind, "Only components of this kind, such as effect")->option_text("KIND");
  list->add_flag("--verbose", options->verbose, "Also print the file of each");
  add_plugins_options(*list, options->common);
  list->callback([options] { list_plugins(*options); });
  CLI::App* show = plugins->add_subcommand("show", "Show a plugin's parameters and, for an effect, its equation");
  show->add_option("name", options->name, "Name of the plugin (see lacuna plugins list)")
      ->required()
      ->option_text("NAME");
  show->add_flag("--verbose", options->verbose, "Also print its file, digest and build");
  add_plugins_options(*show, options->common);
  show->callback([options] { show_plugin(*options); });
  add_new_plugin_command(*plugins);
  add_check_plugin_command(*plugins);
}

}  // namespace lacuna
