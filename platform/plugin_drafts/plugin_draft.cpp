#include "plugin_drafts/plugin_draft.h"

#include "formula/effect_source.h"
#include "plugin_drafts/draft_texts.h"

#include <lacuna/error.h>

#include <algorithm>

namespace lacuna {
namespace {

const DraftKind& kind_of(const std::string& noun) {
  const std::vector<DraftKind>& kinds = draft_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const DraftKind& kind) { return kind.noun == noun; });
  if (found == kinds.end()) throw Error("there is no draft of a plugin of the kind \"" + noun + "\"");
  return *found;
}

/// "robot format" as in the file names of its draft.
std::string file_word(std::string noun) {
  std::replace(noun.begin(), noun.end(), ' ', '_');
  return noun;
}

}  // namespace

const std::vector<DraftKind>& draft_kinds() {
  static const std::vector<DraftKind> all = {
      {"metric", "RMS of predicted - measured", "`[estimation] metric = \"@NAME@\"`"},
      {"model encoding", "each free parameter has one gene, its position in the search range from 0 to 1",
       "`[model] encoding = \"@NAME@\"`"},
      {"mutation", "one gene, chosen at random, is changed within its bounds",
       "`[[estimation.mutation]] operator = \"@NAME@\"`"},
      {"objective metric", "the largest error of a parameter against its true value, as a share of its search range",
       "`[estimation] objective = \"@NAME@\"`"},
      {"recording format", "columns of numbers with spaces between them",
       "`[target] files = [\"run.@NAME@\"]`, with a file such as `sample.@NAME@`"},
      {"robot", "a rod on a hinge, driven by a motor", "`[model] robot = \"@NAME@\"`"},
      {"robot format", "a chain of rods, one per line",
       "`[model] file = \"arm.@NAME@\"`, with a file such as `sample.@NAME@`"},
      {"search", "the best individuals are kept and their children are tried", "`[estimation] search = \"@NAME@\"`"},
      {"target", "a pendulum with dry friction, computed by the plugin", "`[target] kind = \"@NAME@\"`"},
      {"test encoding", "constant commands, one level after another", "`[test] encoding = \"@NAME@\"`"},
      {"test fitness", "standard deviation of the sensor readings that the best model predicts for a test",
       "`[exploration] fitness = \"@NAME@\"`"}};
  return all;
}

std::map<std::string, std::string> plugin_draft(const std::string& noun, const std::string& name) {
  const DraftKind& kind = kind_of(noun);
  const std::map<std::string, std::string>& texts = draft_texts();
  const std::string word = file_word(noun);
  const auto sample = texts.find(word + ".sample");
  const std::string sample_name = "sample." + name;
  const std::map<std::string, std::string> words = {
      {"CLASS", camel_case(name) + "Plugin"},
      {"DOES", kind.does},
      {"KIND", noun},
      {"NAME", name},
      {"OPTIONS", noun == "target"        ? " CARRY_OUT"
                  : sample == texts.end() ? ""
                                          : " SAMPLE " + sample_name},
      {"USE", filled(kind.use, {{"NAME", name}})},
  };
  std::map<std::string, std::string> files;
  for (const char* common : {"CMakeLists.txt", "README.md"}) files[common] = filled(texts.at(common), words);
  files[name + ".cpp"] = filled(texts.at(word + ".cpp"), words);
  if (sample != texts.end()) files[sample_name] = sample->second;
  return files;
}

}  // namespace lacuna
