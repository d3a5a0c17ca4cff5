#include "runs/case_store.h"

#include "laws/law_kind.h"
#include "runs/dirty_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

Cell optional(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }
Cell count(std::size_t value) { return static_cast<std::int64_t>(value); }
Cell text_or_null(const std::string& words) { return words.empty() ? Cell() : Cell(words); }
Cell flag(bool value) { return std::int64_t{value ? 1 : 0}; }

/// Rows of one case: version, set and number stand before the values of each.
class Writer {
 public:
  Writer(Database& database, const CaseRecord& about)
      : database_(database), key_{about.version, about.set, std::int64_t{about.number}} {}

  void insert(const char* table, const Row& values) {
    Row row = key_;
    row.insert(row.end(), values.begin(), values.end());
    std::string places = "?";
    for (std::size_t i = 1; i < row.size(); ++i) places += ", ?";
    database_.change(fmt::format("INSERT INTO {} VALUES ({})", table, places), row);
  }

 private:
  Database& database_;
  Row key_;
};

/// The true value of a parameter of an effect that a case hides in the library's form.
double true_value(const CaseRecord& about, const EffectAt& what, const std::string& parameter) {
  for (const HiddenLawRecord& law : about.hidden) {
    if (!(law.answer == what) || !law.library_form) continue;
    for (const NamedValue& one : law.parameters)
      if (one.name == parameter) return one.value;
  }
  return kUnknown;
}

void write_case(Writer& writer, const CaseResult& result) {
  const CaseRecord& about = result.about;
  writer.insert("bench_case", {about.group, about.rig, about.noise, about.planned_strength, optional(about.strength),
                               flag(about.absorbed), about.seed, text_or_null(result.failure)});
  for (std::size_t i = 0; i < about.hidden.size(); ++i) {
    const HiddenLawRecord& law = about.hidden[i];
    writer.insert("hidden_law", {count(i), law.law, law.answer.effect, law.answer.place, flag(law.library_form)});
    for (const NamedValue& one : law.parameters)
      writer.insert("hidden_value", {count(i), one.name, optional(one.value)});
  }
}

/// What has no sign is told by its size.
IntervalRecord folded(const IntervalRecord& one, const std::string& effect) {
  const bool even = std::any_of(all_laws().begin(), all_laws().end(), [&](const LawKind& kind) {
    return kind.effect == effect && is_even(kind, one.parameter);
  });
  return even && one.value < 0.0 ? IntervalRecord{one.parameter, -one.value, -one.upper, -one.lower} : one;
}

void write_intervals(Writer& writer, const CaseRecord& about, int round, const RankedEffectRecord& effect) {
  for (const IntervalRecord& told : effect.parameters) {
    const IntervalRecord one = folded(told, effect.what.effect);
    writer.insert("interval",
                  {std::int64_t{round}, effect.what.effect, effect.what.place, one.parameter, optional(one.value),
                   optional(one.lower), optional(one.upper), optional(true_value(about, effect.what, one.parameter))});
  }
}

void write_ranked(Writer& writer, int round, std::size_t rank, const RankedModelRecord& model) {
  writer.insert("ranked_model", {std::int64_t{round}, count(rank), optional(model.probability), optional(model.gain),
                                 optional(model.times_floor)});
  std::size_t position = 0;
  const auto name = [&](const EffectAt& what, bool look_alike) {
    writer.insert("ranked_effect",
                  {std::int64_t{round}, count(rank), count(position++), what.effect, what.place, flag(look_alike)});
  };
  for (const RankedEffectRecord& effect : model.effects) name(effect.what, false);
  for (const EffectAt& what : model.look_alikes) name(what, true);
}

void write_diagnosis(Writer& writer, const CaseRecord& about, const DiagnosisRecord& one) {
  writer.insert("diagnosis",
                {std::int64_t{one.round}, one.verdict, optional(one.probability), optional(one.p_by_chance),
                 optional(one.times_floor), optional(one.seconds), optional(one.processor_seconds), one.json});
  for (std::size_t i = 0; i < one.ranking.size(); ++i) write_ranked(writer, one.round, i + 1, one.ranking[i]);
  if (!one.ranking.empty())
    for (const RankedEffectRecord& effect : one.ranking.front().effects)
      write_intervals(writer, about, one.round, effect);
  for (const EffectAt& added : one.added)
    writer.insert("added_effect", {std::int64_t{one.round}, added.effect, added.place});
}

void write_oracle(Writer& writer, const OracleRecord& oracle) {
  for (const OracleRival& one : oracle.rivals)
    writer.insert("oracle_rival", {std::int64_t{one.law}, one.rival.effect, one.rival.place,
                                   optional(one.non_centrality), flag(one.told_apart)});
  for (const OracleWidth& one : oracle.widths) writer.insert("oracle_width", {one.parameter, optional(one.width)});
}

void write_values(Writer& writer, const CaseResult& result) {
  for (const FreeValueRecord& one : result.free_values)
    writer.insert("interval", {std::int64_t{0}, "", "", one.interval.parameter, optional(one.interval.value),
                               optional(one.interval.lower), optional(one.interval.upper), optional(one.truth)});
  for (const HeldOutRecord& one : result.held_out)
    writer.insert("held_out", {one.stage, one.channel, optional(one.rmse)});
}

void write_baseline(Writer& writer, const BaselineRecord& one) {
  writer.insert("baseline", {one.method, std::int64_t{one.chosen}, optional(one.seconds)});
  for (std::size_t i = 0; i < one.ranking.size(); ++i)
    writer.insert("baseline_rank", {one.method, count(i + 1), one.ranking[i].effect, one.ranking[i].place,
                                    i < one.scores.size() ? optional(one.scores[i]) : Cell()});
}

/// Until the two were told apart; one more than the most where they were not.
Cell tests_until_settled(const SettlingRun& run) {
  if (!run.failure.empty()) return {};
  const bool in_vain = run.remaining.effect.empty() && run.tests.size() == kMostSettlingTests;
  return count(run.tests.size() + (in_vain ? 1 : 0));
}

void write_settling(Writer& writer, const SettlingRecord& settling) {
  writer.insert("settling", {settling.answer.effect, settling.answer.place, settling.rival.effect, settling.rival.place,
                             text_or_null(settling.left_out)});
  for (const SettlingRun& run : settling.runs) {
    writer.insert("settling_run", {run.choice, tests_until_settled(run), text_or_null(run.remaining.effect),
                                   text_or_null(run.remaining.place), text_or_null(run.failure)});
    for (std::size_t i = 0; i < run.tests.size(); ++i)
      writer.insert("settling_test", {run.choice, count(i + 1), run.tests[i].line, run.tests[i].verdict,
                                      optional(run.tests[i].processor_seconds)});
  }
}

}  // namespace

void keep_version(Database& database, const std::string& version, const std::string& program) {
  database.change("INSERT OR IGNORE INTO version VALUES (?, ?, strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))",
                  {version, program});
  const std::string before = text(database.query("SELECT program FROM version WHERE version = ?", {version})[0][0]);
  if (before != program)
    throw std::invalid_argument(
        fmt::format("version {} was begun with another program ({}; this one is {}): its "
                    "results would stand beside those; name another --version",
                    version, before, program));
}

bool has_case(const Database& database, const std::string& version, const std::string& set, int number) {
  return !database
              .query("SELECT 1 FROM bench_case WHERE version = ? AND set_name = ? AND number = ?",
                     {version, set, std::int64_t{number}})
              .empty();
}

bool ended_early(const Database& database, const std::string& version, const std::string& set, int number) {
  return !database
              .query(
                  "SELECT 1 FROM bench_case WHERE version = ? AND set_name = ? AND number = ? AND failure IS NOT NULL",
                  {version, set, std::int64_t{number}})
              .empty();
}

void keep_case(Database& database, const CaseResult& result) {
  const CaseRecord& about = result.about;
  Transaction transaction(database);
  database.change("DELETE FROM bench_case WHERE version = ? AND set_name = ? AND number = ? AND failure IS NOT NULL",
                  {about.version, about.set, std::int64_t{about.number}});
  if (has_case(database, about.version, about.set, about.number)) return;
  Writer writer(database, about);
  write_case(writer, result);
  for (const DiagnosisRecord& one : result.diagnoses) write_diagnosis(writer, about, one);
  write_oracle(writer, result.oracle);
  write_values(writer, result);
  for (const BaselineRecord& one : result.baselines) write_baseline(writer, one);
  if (result.settling) write_settling(writer, *result.settling);
  write_dirty_effects(database, about, result.dirty);
  transaction.commit();
}

}  // namespace hidden_effects
