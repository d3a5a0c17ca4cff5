#include "loading/plugin_library.h"

#include "foundation/digest.h"
#include "loading/child_process.h"
#include "loading/elf_file.h"
#include "loading/plugin_table.h"

#include <lacuna/error.h>

#define BOOST_DLL_USE_STD_FS
#include <boost/core/demangle.hpp>
#include <boost/dll/shared_library.hpp>

#include <string_view>

namespace lacuna {
namespace {

using boost::dll::shared_library;

/// Loads for good: the handle is never given back.
const shared_library& load_for_good(const std::filesystem::path& file) {
  static auto* const handles = new std::vector<std::unique_ptr<shared_library>>;
  auto handle =
      std::make_unique<shared_library>(file, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  handles->push_back(std::move(handle));
  return *handles->back();
}

const PluginTable* table_of(const shared_library& library) {
  return library.has(kPluginSymbol) ? library.get<const PluginTable*()>(kPluginSymbol)() : nullptr;
}

/// The part of the loader's message that says something, its symbol names made readable.
std::string loader_complaint(std::string_view message) {
  constexpr std::string_view kStart = "system message: ";
  constexpr std::string_view kUndefined = "undefined symbol: ";
  if (const auto start = message.find(kStart); start != message.npos) message.remove_prefix(start + kStart.size());
  if (const auto end = message.rfind("):"); end != message.npos) message = message.substr(0, end);
  const auto undefined = message.find(kUndefined);
  if (undefined == message.npos)
    return "cannot be loaded (" + std::string(message) + "); install what it needs or build it again";
  std::string symbol(message.substr(undefined + kUndefined.size()));
  symbol = symbol.substr(0, symbol.find_first_of(", \t"));
  return "cannot be loaded: it calls " + boost::core::demangle(symbol.c_str()) +
         ", which nothing defines; add the missing source file or library to the plugin and build it again";
}

std::string in_child(const std::filesystem::path& file, const std::string& ending) {
  return file.string() + ": " + ending + " when it was loaded; copy it or build it again, or take it out of the folder";
}

/// What happens to a file in the child process: everything that will happen to it in this one.
std::string rehearse(const std::filesystem::path& file) {
  const shared_library library(file, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  return table_problem(table_of(library));
}

}  // namespace

PluginLibrary PluginLibrary::open(const std::filesystem::path& file) {
  PluginLibrary plugin;
  plugin.file_ = file;
  plugin.sha256_ = sha256_of_file(file);
  const shared_library& library = load_for_good(file);
  if (!library.has(kPluginSymbol))
    throw Error(std::string("has no function ") + kPluginSymbol +
                "; end one of its source files with LACUNA_PLUGIN(...), or take it out of the plugin folder");
  plugin.table_ = table_of(library);
  const std::string problem = table_problem(plugin.table_);
  if (!problem.empty()) throw Error(problem);
  return plugin;
}

std::vector<PluginLoad> PluginLibrary::load_all(const std::vector<std::filesystem::path>& files) {
  std::vector<PluginLoad> loads(files.size());
  std::vector<std::size_t> complete;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string problem = elf_problem(files[i]);
    if (problem.empty())
      complete.push_back(i);
    else
      loads[i].problem = files[i].string() + ": " + problem;
  }
  const std::vector<ChildAnswer> rehearsals =
      ask_in_child(complete.size(), [&](std::size_t index) { return rehearse(files[complete[index]]); });
  for (std::size_t index = 0; index < complete.size(); ++index) {
    const std::filesystem::path& file = files[complete[index]];
    PluginLoad& load = loads[complete[index]];
    try {
      if (rehearsals[index].death.empty())
        load.library = open(file);
      else
        load.problem = in_child(file, rehearsals[index].death);
    } catch (const boost::dll::fs::system_error& error) {
      load.problem = file.string() + ": " + loader_complaint(error.what());
    } catch (const Error& error) {
      load.problem = file.string() + ": " + error.what();
    }
  }
  return loads;
}

PluginLibrary PluginLibrary::load(const std::filesystem::path& file) {
  PluginLoad load = std::move(load_all({file}).front());
  if (!load.library) throw Error(load.problem);
  return *std::move(load.library);
}

}  // namespace lacuna
