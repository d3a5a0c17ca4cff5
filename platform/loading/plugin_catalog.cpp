#include "loading/plugin_catalog.h"

#include "foundation/text/shell_word.h"
#include "foundation/text/counted.h"
#include "loading/child_process.h"
#include "loading/component_kinds.h"
#include "loading/conformance.h"
#include "loading/effect_probe.h"

#include <sys/stat.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <span>
#include <tuple>

namespace lacuna {

/// A component of a file, made at first use.
struct PluginCatalog::Entry {
  std::string kind;
  ComponentOrigin origin;
  std::string sha256;
  std::string build_id;
  void* (*create)() = nullptr;
  std::string duplicate_of;  // the sentence, if another file has the same component
  std::string refusal;       // the sentence, if it cannot be used
  std::string remark;        // a sentence about a fault that does not change results
  std::mutex making;
  void* made = nullptr;

  void* make() const {
    void* component = guarded_call(origin, "its factory", [this] { return create(); });
    if (component == nullptr)
      throw Error(to_string(origin) + ": its factory returned nothing; this is a fault of the plugin: repair it");
    return component;
  }
};

namespace {

std::vector<std::filesystem::path> plugin_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
    if (entry.path().extension() == ".so") files.push_back(std::filesystem::absolute(entry.path()).lexically_normal());
  std::sort(files.begin(), files.end());
  return files;
}

/// The files of all folders, each once, whatever spelling or link leads to it.
std::vector<std::filesystem::path> distinct_plugin_files(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> files;
  std::set<std::pair<dev_t, ino_t>> seen;
  for (const std::filesystem::path& folder : folders)
    for (const std::filesystem::path& file : plugin_files(folder)) {
      struct stat identity {};
      if (stat(file.c_str(), &identity) == 0 && !seen.emplace(identity.st_dev, identity.st_ino).second) continue;
      files.push_back(file);
    }
  return files;
}

constexpr std::size_t kMostProblems = 3;  ///< of other plugins; printed when a component is missing
constexpr const char* kRepair = "; this is a fault of the plugin: repair it or remove it from the plugin folder";

/// Faults in a component's description, and in the behaviour of its hooks.
template <class Interface>
EffectFindings findings_about(const Interface& component, const ComponentOrigin& origin) {
  if constexpr (std::is_same_v<Interface, PhysicalEffect>) {
    const EffectDescription description = guarded_call(origin, "describe", [&] { return component.describe(); });
    const EffectStages stages = guarded_call(origin, "stages", [&] { return component.stages(); });
    const std::string problem = effect_problem(description, stages, component.overridden());
    if (!problem.empty()) return {problem, {}};
    const PluginCall call(on_page(origin), "its hooks");
    return try_effect(component, description);
  } else if constexpr (std::is_same_v<Interface, RobotFormat>) {
    guarded_call(origin, "summary", [&] { return component.summary(); });
    guarded_call(origin, "read", [&] { return component.read({"nothing", ""}); });
    return {endings_problem(guarded_call(origin, "endings", [&] { return component.endings(); }), ".toml"), {}};
  } else if constexpr (std::is_same_v<Interface, RecordingFormat>) {
    guarded_call(origin, "summary", [&] { return component.summary(); });
    guarded_call(origin, "contents", [&] { return component.contents(""); });
    guarded_call(origin, "read", [&] { return component.read("", {}); });
    return {endings_problem(guarded_call(origin, "endings", [&] { return component.endings(); }), ".csv"), {}};
  } else {
    guarded_call(origin, "summary", [&] { return component.summary(); });
    return {declaration_problem(guarded_call(origin, "parameters", [&] { return component.parameters(); })), {}};
  }
}

EffectFindings findings_about(std::string_view kind, const void* component, const ComponentOrigin& origin) {
  EffectFindings findings;
  for_component_kind(kind, [&]<class Interface>(std::type_identity<Interface>) {
    findings = findings_about(*static_cast<const Interface*>(component), origin);
  });
  return findings;
}

/// Findings travel as one text.
std::string packed(const EffectFindings& findings) { return findings.problem + '\0' + findings.remark; }

EffectFindings unpacked(const std::string& answer) {
  const std::size_t end = answer.find('\0');
  return end == std::string::npos ? EffectFindings{} : EffectFindings{answer.substr(0, end), answer.substr(end + 1)};
}

std::string refusal_of(const ComponentOrigin& origin, const ChildAnswer& rehearsal) {
  if (!rehearsal.death.empty())
    return to_string(origin) + ": " + (rehearsal.call.empty() ? "its code" : rehearsal.call) + " " + rehearsal.death +
           kRepair;
  const std::string problem = unpacked(rehearsal.answer).problem;
  return problem.empty() ? std::string() : to_string(origin) + ": " + problem + kRepair;
}

std::string remark_of(const ComponentOrigin& origin, const ChildAnswer& rehearsal) {
  const std::string remark = unpacked(rehearsal.answer).remark;
  return remark.empty() ? std::string() : to_string(origin) + ": " + remark;
}

/// While it exists, the command may restart without a component that ends the process: it has only examined its
/// plugins.
class NothingDoneYet {
 public:
  NothingDoneYet() { CallPage::allow_new_beginning(true); }
  ~NothingDoneYet() { CallPage::allow_new_beginning(before_); }
  NothingDoneYet(const NothingDoneYet&) = delete;
  NothingDoneYet& operator=(const NothingDoneYet&) = delete;

 private:
  bool before_ = CallPage::allows_new_beginning();
};

template <class Interface>
std::string summary_of(const Interface& component) {
  if constexpr (std::is_same_v<Interface, PhysicalEffect>)
    return component.describe().summary;
  else
    return component.summary();
}

std::string summary_of(std::string_view kind, const void* component) {
  std::string summary;
  for_component_kind(kind, [&]<class Interface>(std::type_identity<Interface>) {
    summary = summary_of(*static_cast<const Interface*>(component));
  });
  return summary;
}

}  // namespace

PluginCatalog::PluginCatalog(const std::vector<std::filesystem::path>& folders) : folders_(folders) {
  const NothingDoneYet may_begin_anew;
  ProcessWatch::begin();
  for (const PluginLoad& load : PluginLibrary::load_all(distinct_plugin_files(folders))) {
    if (load.library)
      add(*load.library);
    else
      problems_.push_back(load.problem);
  }
  std::stable_sort(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) {
    return std::tie(a->origin.kind, a->origin.name) < std::tie(b->origin.kind, b->origin.name);
  });
  find_duplicates();
  refuse_unfit();
  CallPage::watch_exits();  // before the destructors of the plugins, which are registered by now
}

void PluginCatalog::add(const PluginLibrary& library) {
  const PluginTable& table = library.table();
  for (const ComponentEntry& component : std::span(table.components, table.component_count)) {
    auto entry = std::make_shared<Entry>();
    entry->kind = component.kind;
    entry->origin = {component_noun(component.kind), component.name, library.file()};
    entry->origin.on_page = on_page(entry->origin);
    entry->sha256 = library.sha256();
    entry->build_id = table.build_id == nullptr ? "unknown" : table.build_id;
    entry->create = component.create;
    entries_.push_back(std::move(entry));
  }
}

/// In a child process.
std::string PluginCatalog::rehearse(const Entry& entry) {
  if (!entry.refusal.empty()) return {};
  ProcessWatch::look_closely();
  try {
    return packed(findings_about(entry.kind, entry.make(), entry.origin));
  } catch (const ComponentChangedProcess& change) {
    return packed({change.deed(), {}});
  } catch (const ProcessChanged& change) {
    return packed({change.deed(), {}});
  }
}

void PluginCatalog::refuse_unfit() {
  for (const auto& entry : entries_) entry->refusal = CallPage::refusal_of(to_string(entry->origin)).value_or("");
  std::vector<Entry*> asked;
  for (const auto& entry : entries_) asked.push_back(entry.get());
  while (!asked.empty()) {
    const std::vector<ChildAnswer> rehearsals =
        ask_in_child(asked.size(), [&](std::size_t index) { return rehearse(*asked[index]); });
    std::vector<Entry*> once_more;  // whose child was ended by a thread of another library
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (const std::string& library = rehearsals[i].library; !library.empty() && library != asked[i]->origin.file) {
        refuse_library(library, rehearsals[i].death);
        once_more.push_back(asked[i]);
      }
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (std::find(once_more.begin(), once_more.end(), asked[i]) != once_more.end()) continue;
      if (asked[i]->refusal.empty()) asked[i]->refusal = refusal_of(asked[i]->origin, rehearsals[i]);
      asked[i]->remark = remark_of(asked[i]->origin, rehearsals[i]);
    }
    asked = std::move(once_more);
  }
}

/// All components of a library that ended a process outside their calls.
void PluginCatalog::refuse_library(const std::string& file, const std::string& death) {
  for (const auto& entry : entries_)
    if (entry->origin.file == file)
      entry->refusal = to_string(entry->origin) + ": the library's code " + death + " outside of all calls" + kRepair;
}

void PluginCatalog::find_duplicates() {
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    Entry& first = *entries_[i - 1];
    Entry& second = *entries_[i];
    if (first.kind != second.kind || first.origin.name != second.origin.name) continue;
    second.duplicate_of = "two plugins have the " + second.origin.kind + " \"" + second.origin.name +
                          "\": " + first.origin.file.string() + " and " + second.origin.file.string() +
                          "; remove one of them from the search path";
    first.duplicate_of = second.duplicate_of;
    problems_.push_back(second.duplicate_of);
  }
}

ComponentOrigin PluginCatalog::origin(std::string_view kind, const std::string& name) const {
  for (const auto& entry : entries_)
    if (entry->kind == kind && entry->origin.name == name) return entry->origin;
  return {component_noun(kind), name, {}};
}

std::string PluginCatalog::remark_on_effect(const std::string& name) const {
  for (const auto& entry : entries_)
    if (entry->kind == ComponentKind<PhysicalEffect>::name && entry->origin.name == name) return entry->remark;
  return {};
}

std::string PluginCatalog::missing(std::string_view kind, const std::string& name) const {
  const std::string noun = component_noun(kind);
  std::vector<std::string> names;
  for (const auto& entry : entries_)
    if (entry->kind == kind) names.push_back(entry->origin.name);
  std::string text = "there is no " + noun + " \"" + name + "\"" + did_you_mean(name, names);
  text += names.empty() ? "; no plugin has " + with_article(noun) : "; there is " + nearest_names(name, names);
  if (names.size() > kMostNearest) text += "; lacuna plugins list --kind " + shell_word(noun) + " lists all";
  text += "; searched in";
  for (std::size_t i = 0; i < folders_.size(); ++i) text += (i == 0 ? " " : ", ") + folders_[i].string();
  if (folders_.empty()) text += " no folder (name one with --plugin-path)";
  for (std::size_t i = 0; i < std::min(problems_.size(), kMostProblems); ++i) text += "; " + problems_[i];
  if (problems_.size() > kMostProblems)
    text +=
        "; and " + std::to_string(problems_.size() - kMostProblems) + " more problems; lacuna plugins list shows them";
  return text;
}

const std::shared_ptr<PluginCatalog::Entry>& PluginCatalog::find(std::string_view kind, const std::string& name) const {
  for (const auto& entry : entries_) {
    if (entry->kind != kind || entry->origin.name != name) continue;
    if (!entry->duplicate_of.empty()) throw Error(entry->duplicate_of);
    if (!entry->refusal.empty()) throw Error(entry->refusal);
    return entry;
  }
  throw Error(missing(kind, name));
}

void* PluginCatalog::shared_component(const std::shared_ptr<Entry>& entry) {
  static std::mutex keeping;
  static auto* const kept = new std::vector<std::shared_ptr<Entry>>;  // until the process ends
  const std::scoped_lock lock(entry->making);
  if (entry->made == nullptr) {
    entry->made = entry->make();
    const std::scoped_lock keep(keeping);
    kept->push_back(entry);
  }
  return entry->made;
}

void* PluginCatalog::new_component(const std::shared_ptr<Entry>& entry) { return entry->make(); }

std::vector<std::string> PluginCatalog::names(std::string_view kind) const {
  std::vector<std::string> all;
  for (const auto& entry : entries_)
    if (entry->kind == kind && entry->refusal.empty() && entry->duplicate_of.empty()) all.push_back(entry->origin.name);
  return all;
}

std::vector<PluginListing> PluginCatalog::list() const {
  const NothingDoneYet may_begin_anew;
  std::vector<PluginListing> listings;
  for (const auto& entry : entries_) {
    PluginListing& listing = listings.emplace_back();
    listing.kind = entry->origin.kind;
    listing.name = entry->origin.name;
    listing.file = entry->origin.file;
    listing.sha256 = entry->sha256;
    listing.build_id = entry->build_id;
    listing.remark = entry->remark;
    listing.problem = entry->duplicate_of.empty() ? entry->refusal : entry->duplicate_of;
    if (!entry->refusal.empty()) continue;
    try {
      listing.summary =
          guarded_call(entry->origin, "its summary", [&] { return summary_of(entry->kind, shared_component(entry)); });
    } catch (const Error& error) {
      listing.problem = error.what();
    }
  }
  return listings;
}

}  // namespace lacuna
