#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/metric_inputs.h"

#include <lacuna/error.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

class MetricExercise : public Exercise {
 public:
  explicit MetricExercise(const FitnessMetric& metric) : metric_(metric) {}

  ParameterDeclarations declared() const override { return metric_.parameters(); }

  void go(const Setting& setting, Transcript& transcript) const override {
    const std::unique_ptr<ScoreAccumulator> sums = accumulator(setting);
    transcript.add("bound", sums->bound());
    for (const ComparedSample& sample : samples_) {
      sums->add(sample.predicted, sample.measured);
      transcript.add("bound", sums->bound());
    }
    transcript.add("score", sums->score());
  }

  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    const Setting setting = settings().front();
    const auto expect = [&](bool kept, const char* sentence) {
      if (!kept) broken.emplace_back(sentence);
    };
    const std::unique_ptr<ScoreAccumulator> sums = accumulator(setting);
    expect(bounds_hold(*sums),
           "bound() decreases, or is above the final score; return the smallest score that is still possible");
    const double score = sums->score();
    sums->reset();
    expect(score_of(*sums, samples_) == score, "after reset() the same samples give another score; reset everything");
    expect(score_of(*accumulator(setting), sines_off_where_not_measured()) == score,
           "predictions at samples without a measurement change the score; skip values whose `measured` is NaN");
    expect(score_of(*accumulator(setting), worse_sines()) > score,
           "a prediction with an error of 5 more scores no worse; return a larger score for a larger error");
    expect(
        score_of(*accumulator(setting), broken_sines(kNotMeasured)) == std::numeric_limits<double>::infinity(),
        "a prediction that is not a number does not score infinity; return infinity, or a model that diverges may win");
    return broken;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    const std::unique_ptr<ScoreAccumulator> sums = accumulator(settings().front());
    std::size_t next = 0;
    return {repeated_call(
        "add", false, static_cast<int>(kComparedSamples),
        [&] {
          const ComparedSample& sample = samples_[next++ % kComparedSamples];
          sums->add(sample.predicted, sample.measured);
        },
        [&] { sums->reset(); })};
  }

 private:
  std::unique_ptr<ScoreAccumulator> accumulator(const Setting& setting) const {
    std::unique_ptr<ScoreAccumulator> made = metric_.accumulator({2, kComparedSamples, kComparedChannels}, setting);
    if (made == nullptr) throw Error("accumulator returned nothing; return a new accumulator");
    return made;
  }
  static double score_of(ScoreAccumulator& sums, const std::vector<ComparedSample>& samples) {
    for (const ComparedSample& sample : samples) sums.add(sample.predicted, sample.measured);
    return sums.score();
  }
  bool bounds_hold(ScoreAccumulator& sums) const {
    bool rise = true;
    double last = sums.bound();
    for (const ComparedSample& sample : samples_) {
      sums.add(sample.predicted, sample.measured);
      rise = rise && sums.bound() >= last;
      last = sums.bound();
    }
    return rise && last <= sums.score() * (1.0 + kScoreRounding);
  }

  const FitnessMetric& metric_;
  const std::vector<ComparedSample> samples_ = compared_sines();
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const FitnessMetric& metric, const ExerciseInputs&) {
  return std::make_unique<MetricExercise>(metric);
}

}  // namespace lacuna
