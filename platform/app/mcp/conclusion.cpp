#include "app/mcp/conclusion.h"

#include "app/mcp/shortened.h"
#include "foundation/text/counted.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

constexpr int kWasDone = 0, kWasBadInput = 2, kWasStopped = 75;
constexpr std::size_t kMostText = 20000;  // bytes of what a command prints

/// Sentence, verdict and next calls that an agent gets with the command's result.
struct Conclusion {
  std::string sentence;
  ordered_json more = ordered_json::object();  ///< verdict, probability, record_next
  ordered_json next = ordered_json::array();
};

/// The arguments that go on to the next call: which experiment it is and where its results are.
ordered_json same_experiment(const ordered_json& arguments) {
  ordered_json kept = ordered_json::object();
  for (const char* name : {"experiment", "set", "plugin_path", "db"})
    if (arguments.contains(name)) kept[name] = arguments[name];
  return kept;
}

ordered_json step(const std::string& tool, const std::string& reason, ordered_json arguments) {
  return {{"tool", tool}, {"arguments", std::move(arguments)}, {"reason", reason}};
}

std::string text_at(const ordered_json& json, const char* key) {
  return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string();
}

const ordered_json& list_at(const ordered_json& json, const char* key) {
  static const ordered_json none = ordered_json::array();
  return json.contains(key) && json[key].is_array() ? json[key] : none;
}

/// "coulomb_friction @ joint.hinge + ..." of the first candidate.
std::string answer_of(const ordered_json& diagnosis) {
  std::vector<std::string> effects;
  const ordered_json& ranking = list_at(diagnosis, "ranking");
  if (!ranking.empty())
    for (const ordered_json& effect : list_at(ranking.front(), "effects"))
      effects.push_back(text_at(effect, "effect") + " @ " + text_at(effect, "where"));
  return fmt::format("{}", fmt::join(effects, " + "));
}

std::string sentence_of_verdict(const std::string& verdict, const ordered_json& diagnosis) {
  if (verdict == "effect_found") return "The model is missing " + answer_of(diagnosis) + ".";
  if (verdict == "nothing_missing") return "These recordings show no missing effect of the library.";
  if (verdict == "not_in_library")
    return "A force is missing that no effect of the library describes; result.formulas has a formula for it.";
  return "These recordings cannot show which effect is missing; result.findings says why.";
}

void add_test_to_record(const ordered_json& diagnosis, const ordered_json& arguments, Conclusion& conclusion) {
  const std::string test = text_at(diagnosis, "next_test");
  conclusion.more["record_next"] = nullptr;
  if (test.empty()) return;
  conclusion.more["record_next"] = {{"test", test},
                                    {"setup", diagnosis.value("next_test_setup", ordered_json())},
                                    {"worth", text_at(diagnosis, "next_test_worth")}};
  ordered_json trial = same_experiment(arguments);
  trial["test"] = test;
  trial["csv"] = "next-test.csv";
  if (const ordered_json setup = diagnosis.value("next_test_setup", ordered_json());
      setup.is_object() && !text_at(setup, "name").empty())
    trial["setup"] = text_at(setup, "name");
  conclusion.next.push_back(step("trial", "writes the commands of the test that separates the candidates", trial));
}

Conclusion of_diagnosis(const ordered_json& diagnosis, const ordered_json& arguments) {
  const std::string verdict = text_at(diagnosis, "verdict");
  Conclusion conclusion{sentence_of_verdict(verdict, diagnosis)};
  const ordered_json probability = diagnosis.value("probability", ordered_json());
  conclusion.more = {{"verdict", verdict}, {"probability", probability}};
  conclusion.sentence += probability.is_number()
                             ? fmt::format(" The verdict is right with probability {}.", probability.dump())
                             : " This verdict has no stated probability.";
  if (verdict == "effect_found") {
    ordered_json add = same_experiment(arguments);
    add["answer"] = true;
    conclusion.next.push_back(step("add", "adds the effects that were found and fits again", add));
  }
  add_test_to_record(diagnosis, arguments, conclusion);
  return conclusion;
}

Conclusion of_comparison(const ordered_json& comparison, const ordered_json& arguments) {
  const std::string advice = text_at(comparison, "advice");
  Conclusion conclusion{advice};
  if (advice.find("lacuna diagnose") != std::string::npos)
    conclusion.next.push_back(step("diagnose", "finds the missing effect", same_experiment(arguments)));
  return conclusion;
}

std::string errors_of_change(const ordered_json& change) {
  std::vector<std::string> parts;
  const ordered_json before = change.value("before", ordered_json::object())["channels"];
  const ordered_json after = change.value("after", ordered_json::object())["channels"];
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
    if (before[i]["times_floor"].is_number() && after[i]["times_floor"].is_number())
      parts.push_back(fmt::format("{} {:.3g} → {:.3g} × floor", text_at(after[i], "channel"),
                                  before[i]["times_floor"].get<double>(), after[i]["times_floor"].get<double>()));
  return fmt::format("{}", fmt::join(parts, "; "));
}

Conclusion of_change(const ordered_json& change, const ordered_json& arguments) {
  const std::string what = text_at(change, "change"), errors = errors_of_change(change);
  Conclusion conclusion{what == "undo" ? "The last change of the model is undone."
                                       : fmt::format("{} is in the model. Error on the fit files: {}.", what, errors)};
  if (const std::size_t rises = list_at(change, "rises").size(); rises > 0) {
    conclusion.sentence += fmt::format(" {} increased, see result.rises.", counted(rises, "error"));
    conclusion.next.push_back(step("undo", "undoes the change", same_experiment(arguments)));
  }
  conclusion.next.push_back(step("compare", "shows the errors, held-out files included", same_experiment(arguments)));
  return conclusion;
}

Conclusion of_history(const ordered_json& history, const ordered_json& arguments) {
  const std::string missing = text_at(history, "missing");
  Conclusion conclusion{"result.revisions has the error of each stored revision" +
                        (missing.empty() ? "." : "; " + missing + ".")};
  if (!missing.empty()) conclusion.next.push_back(step("compare", missing, same_experiment(arguments)));
  return conclusion;
}

Conclusion of_done(const Tool& tool, const ordered_json& result, const ordered_json& arguments) {
  const ordered_json same = same_experiment(arguments);
  if (tool.name == "diagnose") return of_diagnosis(result, arguments);
  if (tool.name == "compare") return of_comparison(result, arguments);
  if (tool.name == "add" || tool.name == "undo") return of_change(result, arguments);
  if (tool.name == "history") return of_history(result, arguments);
  Conclusion done{"Done."};
  if (tool.name == "new") {
    done.sentence = "The draft is written. The text lists what was guessed and the lines to fill in.";
    done.next.push_back(step("check", "after the lines are filled in", same));
  } else if (tool.name == "check") {
    done.sentence = "The experiment file, its robot and its recordings are in order.";
    done.next.push_back(step("compare", "tells whether something is missing", same));
  } else if (tool.name == "fit") {
    done.sentence = "The free values are fitted; result.values has them with 95 % intervals.";
    done.next.push_back(step("compare", "tells whether something is missing", same));
  }
  return done;
}

Conclusion conclusion_of(const Tool& tool, const ordered_json& arguments, const CallOutcome& outcome) {
  if (outcome.exit_code == kWasDone) return of_done(tool, outcome.result, arguments);
  if (outcome.exit_code == kWasBadInput)
    return {"Bad input; nothing was done. The notes say where the problem is and what to do."};
  if (outcome.exit_code != kWasStopped)
    return {"The command failed, so there is nothing to conclude. The notes say why."};
  Conclusion stopped{"The command stopped before its end. To continue, call it again with the same arguments."};
  if (tool.name == "diagnose" && outcome.result.is_object()) {
    stopped.more = {{"verdict", text_at(outcome.result, "verdict")}, {"probability", nullptr}};
    stopped.sentence = "The verdict is preliminary. " + stopped.sentence;
  }
  stopped.next.push_back(step(tool.name, "continues", arguments));
  return stopped;
}

/// What is not UTF-8 is written as U+FFFD.
std::string dumped_text(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json text_block(std::string text) {
  if (text.size() > kMostText) text = text.substr(0, kMostText) + fmt::format("\n... ({} bytes in all)", text.size());
  return {{"type", "text"}, {"text", text}};
}

}  // namespace

ordered_json call_answer(const Tool& tool, const ordered_json& arguments, const CallOutcome& outcome) {
  const Conclusion conclusion = conclusion_of(tool, arguments, outcome);
  ordered_json structured = {{"exit_code", outcome.exit_code}, {"conclusion", conclusion.sentence}};
  structured.update(conclusion.more);
  structured["next"] = conclusion.next;
  structured["notes"] = outcome.notes;
  const std::string brief = dumped_text(structured);
  if (!outcome.result.is_null()) structured["result"] = shortened(outcome.result);
  std::string text = fmt::format("{}\n\n{}\n", conclusion.sentence, fmt::join(outcome.notes, "\n"));
  text += !outcome.printed.empty() || outcome.result.is_null() ? outcome.printed : dumped_text(structured["result"]);
  const bool has_failed =
      outcome.exit_code != kWasDone && !(outcome.exit_code == kWasStopped && outcome.result.is_object());
  return {
      {"content", {text_block(text), text_block(brief)}}, {"structuredContent", structured}, {"isError", has_failed}};
}

}  // namespace lacuna
