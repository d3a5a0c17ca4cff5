#include "cases/make_case.h"
#include "cases/write_case.h"
#include "foundation/parallel.h"
#include "runs/case_truth.h"
#include "runs/user_session.h"
#include "support/test_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <thread>

/// Every third of the forty fixed cases of the benchmark: a method that gets worse fails here. The least count is one
/// less than the method reaches, since processors differ in last digits; raise it with the method. All forty:
/// `lacuna-benchmark hidden-effects run --set fixed`.
namespace hidden_effects {
namespace {

constexpr std::size_t kEvery = 3;       ///< case is asked
constexpr int kLeastRight = 9;          ///< of those with a hidden effect that the base does not absorb
constexpr int kMostFalsePositives = 1;  ///< of those without
constexpr double kMostTimesUsual = 16;  ///< processor time of one diagnosis over the median; machines differ by three
constexpr double kHangs = 900.0;        ///< s, beside other tests that take all processors

struct Outcome {
  CaseRecord about;
  DiagnosisRecord answer;

  bool hides() const { return !about.hidden.empty() && !about.absorbed; }
  bool positive() const { return answer.verdict == "effect_found" || answer.verdict == "not_in_library"; }

  /// The hidden effect is named in the answer: in its first model or among what the data do not tell from it.
  bool right() const {
    if (answer.verdict != "effect_found" || answer.ranking.empty()) return false;
    std::vector<EffectAt> named = answer.ranking.front().look_alikes;
    for (const RankedEffectRecord& effect : answer.ranking.front().effects) named.push_back(effect.what);
    return std::find(named.begin(), named.end(), about.hidden.front().answer) != named.end();
  }

  std::string text() const {
    std::string line = fmt::format("{}-{:04} {} {} strength {:.1f}:", about.set, about.number, about.rig,
                                   about.hidden.empty() ? "nothing" : about.hidden.front().law, about.strength);
    line += " " + answer.verdict;
    if (positive() && !answer.ranking.empty())
      for (const RankedEffectRecord& effect : answer.ranking.front().effects) line += " " + effect.what.effect;
    return line + fmt::format(", P {:.2f}, {:.1f} s\n", answer.probability, answer.processor_seconds);
  }
};

Outcome diagnose_case(const CasePlan& plan) {
  const lacuna::TestFolder folder;
  const MadeCase made = make_case(plan);
  write_case(made, folder.path());
  UserSession session({LACUNA_BINARY_DIRECTORY "/bin/lacuna", kHangs}, folder.path(), {});
  return {about_case(made, "test"), session.diagnose()};
}

std::vector<Outcome> outcomes() {
  std::vector<CasePlan> plans;
  for (const CasePlan& plan : plan_cases("fixed"))
    if (static_cast<std::size_t>(plan.number) % kEvery == 0) plans.push_back(plan);
  std::vector<Outcome> results(plans.size());
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  lacuna::parallel_for(plans.size(), threads,
                       [&](std::size_t i, int /*worker*/) { results[i] = diagnose_case(plans[i]); });
  return results;
}

double usual_seconds(const std::vector<Outcome>& all) {
  std::vector<double> seconds;
  for (const Outcome& one : all) seconds.push_back(one.answer.processor_seconds);
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

/// One test, since each of ctest's is a process of its own.
TEST(FixedCases, AreAnsweredAsWellAsBefore) {
  const std::vector<Outcome> all = outcomes();
  for (const Outcome& one : all) std::cout << one.text();
  const auto right =
      std::count_if(all.begin(), all.end(), [](const Outcome& one) { return one.hides() && one.right(); });
  const auto false_positives =
      std::count_if(all.begin(), all.end(), [](const Outcome& one) { return !one.hides() && one.positive(); });
  std::cout << right << " hidden effects found, " << false_positives << " found where nothing is hidden\n";
  const double most_seconds = kMostTimesUsual * usual_seconds(all);
  for (const Outcome& one : all) EXPECT_LE(one.answer.processor_seconds, most_seconds) << one.text();
  EXPECT_GE(right, kLeastRight);
  EXPECT_LE(false_positives, kMostFalsePositives);
}

}  // namespace
}  // namespace hidden_effects
