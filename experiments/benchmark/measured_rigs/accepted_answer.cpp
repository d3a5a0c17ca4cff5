#include "measured_rigs/accepted_answer.h"

#include "config/toml/toml_parser.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hidden_effects {
namespace {

using lacuna::TomlNode;

std::vector<std::string> texts(const TomlNode* list) {
  std::vector<std::string> all;
  if (list)
    for (const TomlNode& one : list->items) all.push_back(one.text);
  return all;
}

AcceptedAnswer read(const TomlNode& table) {
  AcceptedAnswer answer;
  if (const TomlNode* name = table.find("name")) answer.rig = name->text;
  answer.experiments = texts(table.find("experiments"));
  answer.nothing_missing = texts(table.find("nothing_missing"));
  answer.may = texts(table.find("may"));
  answer.check = texts(table.find("check"));
  if (const TomlNode* needs = table.find("needs"))
    for (const TomlNode& one : needs->items) answer.needs.push_back(texts(&one));
  if (answer.rig.empty() || answer.experiments.empty() || answer.needs.empty())
    throw std::runtime_error("each [[rig]] has a name, experiments and needs");
  return answer;
}

bool is_meant(const std::string& wanted, const EffectAt& found) {
  return wanted == found.effect || wanted == found.effect + " @ " + found.place ||
         (found.place.ends_with(".*") &&
          wanted.starts_with(found.effect + " @ " + found.place.substr(0, found.place.size() - 1)));
}

bool is_one_of(const Alternatives& wanted, const EffectAt& found) {
  return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& one) { return is_meant(one, found); });
}

}  // namespace

std::vector<AcceptedAnswer> read_accepted_answers(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  std::vector<AcceptedAnswer> answers;
  const TomlNode whole = lacuna::parse_toml(text.str(), file.string());
  if (const TomlNode* rigs = whole.find("rig"))
    for (const TomlNode& one : rigs->items) answers.push_back(read(one));
  if (answers.empty()) throw std::runtime_error(file.string() + ": has no [[rig]]");
  return answers;
}

Grade grade(const AcceptedAnswer& accepted, const std::string& experiment, const DiagnosisRecord& diagnosis) {
  if (diagnosis.verdict == "cannot_tell") return Grade::undecided;
  const auto& nothing = accepted.nothing_missing;
  if (std::find(nothing.begin(), nothing.end(), experiment) != nothing.end())
    return diagnosis.verdict == "nothing_missing" ? Grade::right : Grade::wrong;
  if (diagnosis.verdict != "effect_found" || diagnosis.ranking.empty()) return Grade::wrong;
  const RankedModelRecord& answer = diagnosis.ranking.front();
  Alternatives allowed = accepted.may;
  for (const Alternatives& one : accepted.needs) allowed.insert(allowed.end(), one.begin(), one.end());
  int strangers = 0, stood_for = 0;  // an effect may stand for one that the data do not tell from it
  for (const RankedEffectRecord& effect : answer.effects) strangers += is_one_of(allowed, effect.what) ? 0 : 1;
  for (const Alternatives& wanted : accepted.needs) {
    const auto meant = [&](const EffectAt& found) { return is_one_of(wanted, found); };
    if (std::any_of(answer.effects.begin(), answer.effects.end(),
                    [&](const RankedEffectRecord& effect) { return meant(effect.what); }))
      continue;
    if (std::none_of(answer.look_alikes.begin(), answer.look_alikes.end(), meant)) return Grade::wrong;
    ++stood_for;
  }
  return strangers <= stood_for ? Grade::right : Grade::wrong;
}

}  // namespace hidden_effects
