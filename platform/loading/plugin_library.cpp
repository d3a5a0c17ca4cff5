#include "loading/plugin_library.h"

#include "foundation/files/allowed_files.h"
#include "foundation/digest.h"
#include "foundation/processes/guarded_call.h"
#include "foundation/plugins/plugin_libraries.h"
#include "foundation/processes/process_state.h"
#include "foundation/processes/process_watch.h"
#include "loading/child_process.h"
#include "loading/elf_file.h"
#include "loading/plugin_catalog.h"
#include "loading/plugin_table.h"

#include <lacuna/error.h>

#define BOOST_DLL_USE_STD_FS
#include <boost/core/demangle.hpp>
#include <boost/dll/shared_library.hpp>

#include <memory>
#include <string_view>

namespace lacuna {
namespace {

using boost::dll::shared_library;

/// Loads for good: the handle is never closed.
const shared_library& load_for_good(const std::filesystem::path& file) {
  static auto* const handles = new std::vector<std::unique_ptr<shared_library>>;
  auto handle =
      std::make_unique<shared_library>(file, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  handles->push_back(std::move(handle));
  return *handles->back();
}

using TableFunction = const PluginTable*();

/// Throws `Error` where the library has no such function, or where the function throws.
const PluginTable* table_of(const shared_library& library, const std::filesystem::path& file) {
  if (!library.has(kPluginSymbol))
    throw Error(std::string("has no function ") + kPluginSymbol +
                "; end one of its source files with LACUNA_PLUGIN(...), or take it out of the plugin folder");
  TableFunction& function = library.get<TableFunction>(kPluginSymbol);
  try {
    return guarded_call({"plugin library", file.filename().string(), file}, kPluginSymbol, function);
  } catch (const ComponentError& error) {
    throw Error(error.reason());
  }
}

/// The informative part of the loader's message, with readable symbol names.
std::string loader_complaint(std::string_view message) {
  constexpr std::string_view kStart = "system message: ";
  constexpr std::string_view kUndefined = "undefined symbol: ";
  if (const auto start = message.find(kStart); start != message.npos) message.remove_prefix(start + kStart.size());
  if (const auto end = message.rfind("):"); end != message.npos) message = message.substr(0, end);
  const auto undefined = message.find(kUndefined);
  if (undefined == message.npos)
    return "cannot be loaded (" + std::string(message) + "); install the missing library or build it again";
  std::string symbol(message.substr(undefined + kUndefined.size()));
  symbol = symbol.substr(0, symbol.find_first_of(", \t"));
  return "cannot be loaded: it calls " + boost::core::demangle(symbol.c_str()) +
         ", which is defined nowhere; add the missing source file or library to the plugin and build it again";
}

std::string in_child(const std::filesystem::path& file, const std::string& ending) {
  return file.string() + ": " + ending + " when it was loaded; copy it or build it again, or remove it from the folder";
}

/// The process state that libraries must leave; none: no library has been loaded here.
std::unique_ptr<const ProcessState>& state_before_loading() {
  static auto* const state = new std::unique_ptr<const ProcessState>;
  return *state;
}

void remember_state() {
  state_before_loading() = nullptr;  // restores its copies of the streams, which must not be part of the next state
  state_before_loading() = std::make_unique<const ProcessState>();
}

/// Changes by the library that was just loaded, set back; empty: none.
std::string sentence_of_changes() {
  const std::vector<std::string> changes = state_before_loading()->set_back(ProcessState::Extent::complete);
  if (changes.empty()) return {};
  remember_state();  // a change that could not be set back is not blamed on the next library
  return "changes " + enumerated(changes) +
         " when it is loaded, on which other code relies; remove this from its static objects and link options, or "
         "remove the plugin from the folder";
}

/// Name for the loading of a library in a parent process, before its components are known.
const char* file_on_page(const std::filesystem::path& file) { return component_on_page(file.string()); }
constexpr const char* kLoading = "its code that runs on loading";

/// Loads the file in the child process exactly as this process will. Returns the changes of the process.
std::string rehearse(const std::filesystem::path& file) {
  const PluginCall call(file_on_page(file), kLoading);
  ProcessWatch::look_closely();
  if (state_before_loading() == nullptr) remember_state();
  std::string changes;
  try {
    const shared_library library(file, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
    changes = sentence_of_changes();
    table_problem(table_of(library, file));
  } catch (...) {  // this process will meet and report it
  }
  return changes;
}

bool is_of_program(const std::filesystem::path& file) {
  static const std::filesystem::path folder = installed_plugins();
  return !folder.empty() && file.parent_path() == folder.lexically_normal();
}

}  // namespace

void PluginLibrary::forget_process() {
  ProcessWatch::forget();
  state_before_loading() = nullptr;
}

PluginLibrary PluginLibrary::open(const std::filesystem::path& file) {
  PluginLibrary plugin;
  plugin.file_ = file;
  plugin.sha256_ = sha256_of_file(file);
  const PluginCall call(file_on_page(file), kLoading);
  const shared_library& library = load_for_good(file);
  const std::string changes = sentence_of_changes();
  if (!changes.empty()) throw Error(changes);
  plugin.table_ = table_of(library, file);
  PluginLibraries::add(reinterpret_cast<const void*>(&library.get<TableFunction>(kPluginSymbol)), file.string(),
                       is_of_program(file));
  const std::string problem = table_problem(plugin.table_);
  if (!problem.empty()) throw Error(problem);
  return plugin;
}

std::vector<PluginLoad> PluginLibrary::load_all(const std::vector<std::filesystem::path>& files) {
  std::vector<PluginLoad> loads(files.size());
  std::vector<std::size_t> complete;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string refusal = why_may_not_read(files[i]);
    const std::string problem = refusal.empty() ? elf_problem(files[i]) : refusal;
    if (const auto refused = CallPage::refusal_of(files[i].string()))
      loads[i].problem = *refused;
    else if (problem.empty())
      complete.push_back(i);
    else
      loads[i].problem = files[i].string() + ": " + problem;
  }
  state_before_loading() = nullptr;  // the state of the child is separate
  const std::vector<ChildAnswer> rehearsals =
      ask_in_child(complete.size(), [&](std::size_t index) { return rehearse(files[complete[index]]); });
  remember_state();
  for (std::size_t index = 0; index < complete.size(); ++index) {
    const std::filesystem::path& file = files[complete[index]];
    PluginLoad& load = loads[complete[index]];
    try {
      if (!rehearsals[index].death.empty())
        load.problem = in_child(file, rehearsals[index].death);
      else if (!rehearsals[index].answer.empty())
        load.problem = file.string() + ": " + rehearsals[index].answer;
      else
        load.library = open(file);
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
