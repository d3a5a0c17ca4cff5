#include "search/effect_look.h"

#include "foundation/parallel.h"
#include "prediction/whitened_columns.h"
#include "search/extreme_stretches.h"
#include "search/probed_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kForPromises = 400;  ///< samples per length
constexpr WantedChange kWantedChange = {0.2, 0.6, true};
constexpr double kFarthestSize = 20.0;  ///< times its probe's size: the largest size at which an effect is predicted

}  // namespace

/// A model on a ladder of few stretches.
struct LookStage {
  PredictionLadder ladder;
  ParameterSpace space;  ///< of the model
  LinearPrediction linear;
  std::shared_ptr<const WhitenedColumns> whitened;  ///< of it
  PredictionPoint point;
  std::vector<double> scale;  ///< by cell: the model's residual, over a reading's standard deviation, at least 1
};

namespace {

LookStage stage_for(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder) {
  const ModelContext context = data.bench_for(model.model);
  LookStage stage{ladder, context.space(), {}, nullptr, {}, std::vector<double>(ladder.layout.cells.size(), 1.0)};
  LadderPredictions predictions(stage.ladder, context.predictor(), context.space(), data.starts(),
                                changes_readings(model.model.definition));
  stage.point = predictions.at_smoothed_starts(context.space().to_coordinates(model.model.values));
  if (std::optional<LinearPrediction> linear = predictions.linearise(stage.point)) stage.linear = std::move(*linear);
  stage.whitened = std::make_shared<const WhitenedColumns>(stage.ladder, stage.linear.stretches);
  std::vector<double> squares(stage.scale.size(), 0.0), counts(stage.scale.size(), 0.0);
  for (std::size_t k = 0; k < stage.linear.stretches.size(); ++k)
    for (std::size_t i = 0; i < stage.ladder.stretches[k].channels.size(); ++i) {
      const PredictedStretch& stretch = stage.ladder.stretches[k];
      const std::size_t cell = stage.ladder.cell(stretch.length, stretch.channels[i]);
      squares[cell] += std::pow(stage.linear.stretches[k].residual(static_cast<Eigen::Index>(i)), 2);
      counts[cell] += 1.0;
    }
  for (std::size_t c = 0; c < squares.size(); ++c)
    if (counts[c] > 0.0) stage.scale[c] = std::sqrt(std::max(1.0, squares[c] / counts[c]));
  return stage;
}

/// A hypothesis beside a model's values on a ladder, simulated.
class ProbedHypothesis {
 public:
  ProbedHypothesis(const SearchData& data, const FittedModel& model, const Hypothesis& hypothesis,
                   const PredictionLadder& ladder)
      : data_(data),
        model_(model),
        hypothesis_(hypothesis),
        context_(hypothesis.definition, *hypothesis.model, data.task().trials, data.timing(),
                 Work{1, data.task().work.stop}, kCommandsMayAct),
        predictions_(ladder, context_.predictor(), context_.space(), data.starts(),
                     changes_readings(hypothesis.definition)) {}

  bool residuals(const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals) {
    return predictions_.residuals(point(model_.model.values, own), residuals);
  }

  /// The cost with these values and the derivatives by initial states of `linear`; infinite where it cannot be
  /// simulated.
  double cost(const std::vector<double>& of_model, const std::vector<double>& own, const LinearPrediction& linear) {
    std::vector<LinearStretch> stretches = linear.stretches;
    if (!predictions_.residuals_at(point(of_model, own), stretches)) return std::numeric_limits<double>::infinity();
    const BlockProducts products = whitened_products(predictions_.ladder(), stretches);
    return cost_at(predictions_.ladder().layout, products, Eigen::VectorXd::Zero(products.values())).cost;
  }
  const std::string& failure() const { return predictions_.failure(); }

 private:
  PredictionPoint point(const std::vector<double>& of_model, const std::vector<double>& own) const {
    std::vector<double> all = hypothesis_.values(of_model, own);
    if (data_.timing()) all.push_back(of_model.back());
    return predictions_.at_smoothed_starts(context_.space().to_coordinates(all));
  }

  const SearchData& data_;
  const FittedModel& model_;
  const Hypothesis& hypothesis_;
  ModelContext context_;
  LadderPredictions predictions_;
};

std::vector<SizedProbe> sized(const SearchData& data, const FittedModel& model, const Hypothesis& hypothesis,
                              const LookStage& few, std::string& failure) {
  ProbedHypothesis probed(data, model, hypothesis, few.ladder);
  const OwnResiduals simulate = [&](const std::vector<double>& own, std::vector<Eigen::VectorXd>& rows) {
    if (!probed.residuals(own, rows)) {
      failure = probed.failure();
      return false;
    }
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (Eigen::Index i = 0; i < rows[k].size(); ++i) {
        const PredictedStretch& stretch = few.ladder.stretches[k];
        rows[k](i) /= few.scale[few.ladder.cell(stretch.length, stretch.channels[static_cast<std::size_t>(i)])];
      }
    return true;
  };
  return size_probes(hypothesis, simulate, kWantedChange, data.scales());
}

/// The change of the model's predictions by each of the effect's probes.
std::vector<ProbeResponse> responses_of(const SearchData& data, const FittedModel& model, const Hypothesis& hypothesis,
                                        const LookStage& few, const LookStage& stage, std::string& failure) {
  std::vector<ProbeResponse> responses;
  ProbedHypothesis probed(data, model, hypothesis, stage.ladder);
  std::vector<Eigen::VectorXd> moved;
  for (const SizedProbe& probe : sized(data, model, hypothesis, few, failure)) {
    data.task().work.stop.throw_if_due();
    if (!probed.residuals(probe.own, moved)) {
      failure = probed.failure();
      continue;
    }
    for (std::size_t k = 0; k < moved.size(); ++k) moved[k] = stage.linear.stretches[k].residual - moved[k];
    responses.push_back({probe, std::move(moved)});
  }
  return responses;
}

StepBounds bounds_of(const LookStage& stage) {
  return {stage.space.lower() - stage.point.values, stage.space.upper() - stage.point.values};
}

/// The model of the stage together with some responses.
class StageWithLaw {
 public:
  StageWithLaw(const LookStage& stage, const std::vector<const ProbeResponse*>& law)
      : stage_(stage), bounds_(bounds_of(stage)) {
    const Eigen::Index own = stage.point.values.size(), added = static_cast<Eigen::Index>(law.size());
    bounds_.lower.conservativeResize(own + added);
    bounds_.upper.conservativeResize(own + added);
    std::vector<const PredictedChange*> changes;
    for (Eigen::Index j = 0; j < added; ++j) {
      const ProbeResponse& response = *law[static_cast<std::size_t>(j)];
      changes.push_back(&response.change);
      bounds_.upper(own + j) = response.probe.sized ? kFarthestSize : 1.0;
      bounds_.lower(own + j) = response.probe.one_sided ? 0.0 : -bounds_.upper(own + j);
    }
    products_ = stage.whitened->with(changes);
    least_ = least_cost(stage.ladder.layout, products_, bounds_);
  }

  const LinearCost& least() const { return least_; }
  Eigen::VectorXd cross_fitted() const {
    return cross_fit(stage_.ladder.layout, products_, bounds_, least_, true).by_block();
  }

 private:
  const LookStage& stage_;
  StepBounds bounds_;
  BlockProducts products_;
  LinearCost least_;
};

/// The responses of the laws of one hypothesis beside the model of a stage.
struct LookedLaws {
  std::optional<EffectPromise> best;           ///< nothing where no law could be simulated
  std::vector<const ProbeResponse*> law = {};  ///< of the best
  std::vector<Eigen::VectorXd> costs;          ///< by block of time, cross-fitted
};

LookedLaws look_at(std::size_t h, const Hypothesis& hypothesis, const std::vector<ProbeResponse>& responses,
                   const LookStage& stage) {
  LookedLaws looked;
  for (const std::vector<std::size_t>& law : laws_of(hypothesis, responses)) {
    std::vector<const ProbeResponse*> added;
    for (const std::size_t r : law) added.push_back(&responses[r]);
    const StageWithLaw with(stage, added);
    looked.costs.push_back(with.cross_fitted());
    if (looked.best && with.least().cost >= looked.best->cost) continue;
    looked.best = EffectPromise{h, with.least().cost, {}, with.least().step, looked.costs.back()};
    for (const ProbeResponse* one : added) looked.best->probes.push_back(one->probe);
    looked.law = std::move(added);
  }
  return looked;
}

/// The probe of an effect on one joint as one of the effect on every joint.
SizedProbe placed_probe(const SizedProbe& probe, const Hypothesis& every, std::size_t place) {
  SizedProbe placed{every.neutral, probe.sized, probe.one_sided};
  const std::size_t first = place * every.parameters();
  std::copy(probe.own.begin(), probe.own.end(), placed.own.begin() + static_cast<std::ptrdiff_t>(first));
  if (placed.sized) *placed.sized += first;
  return placed;
}

/// An effect with a value for each joint: the best law of each of its places, all at once.
LookedLaws look_at_places(std::size_t h, const EffectLook& look, const std::vector<LookedLaws>& by_place) {
  const Hypothesis& every = look.hypotheses[h];
  LookedLaws looked;
  std::vector<SizedProbe> probes;
  for (std::size_t place = 0; place < every.placed.size(); ++place)
    for (std::size_t one = 0; one < by_place.size(); ++one) {
      if (member_name(look.hypotheses[one].entry) != member_name(every.placed[place])) continue;
      for (const ProbeResponse* response : by_place[one].law) {
        looked.law.push_back(response);
        probes.push_back(placed_probe(response->probe, every, place));
      }
    }
  if (looked.law.empty()) return looked;
  const StageWithLaw with(*look.stage, looked.law);
  looked.costs = {with.cross_fitted()};
  looked.best = EffectPromise{h, with.least().cost, std::move(probes), with.least().step, looked.costs.front()};
  return looked;
}

void promise(const SearchData& data, EffectLook& look) {
  const StageWithLaw plain(*look.stage, {});
  look.cost = plain.least().cost;
  const Eigen::VectorXd before = plain.cross_fitted();
  std::vector<LookedLaws> looked(look.hypotheses.size());
  parallel_for(looked.size(), data.task().work.threads, [&](std::size_t h, int) {
    looked[h] = look_at(h, look.hypotheses[h], look.responses->at(h), *look.stage);
  });
  for (std::size_t h = 0; h < looked.size(); ++h)
    if (look.hypotheses[h].placed.size() > 1) looked[h] = look_at_places(h, look, looked);
  for (LookedLaws& one : looked) {
    if (one.best) {
      one.best->gains = before - one.best->gains;
      look.promises.push_back(std::move(*one.best));
    }
    for (const Eigen::VectorXd& cost : one.costs) look.gains.push_back(before - cost);
  }
  std::stable_sort(look.promises.begin(), look.promises.end(),
                   [](const EffectPromise& a, const EffectPromise& b) { return a.cost < b.cost; });
}

}  // namespace

bool of_one_kind(const Hypothesis& one, const Hypothesis& other) {
  const auto names = [](const Hypothesis& a, const Hypothesis& b) {
    return std::find(a.alike.begin(), a.alike.end(), b.entry.effect) != a.alike.end();
  };
  return one.where() == other.where() &&
         (one.entry.effect == other.entry.effect || names(one, other) || names(other, one));
}

EffectLook look_at_library(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder) {
  EffectLook look;
  look.hypotheses = list_hypotheses(model.model.experiment, data.task().catalog, model.model.definition,
                                    data.task().among, look.untestable);
  data.bound(look.hypotheses);
  const RobotSpec& robot = model.model.definition.structure.robot;
  std::map<std::string, LookStage> few;  // by joint
  for (const Hypothesis& hypothesis : look.hypotheses)
    if (const std::string joint = joint_at(robot, hypothesis.where()); !few.contains(joint))
      few.emplace(joint, stage_for(data, model, for_sizes(ladder, robot, data.task().trials, joint)));
  look.stage = std::make_shared<const LookStage>(stage_for(data, model, thinned(ladder, kForPromises)));
  if (look.stage->linear.stretches.empty()) return look;
  std::vector<std::vector<ProbeResponse>> responses(look.hypotheses.size());
  std::vector<std::string> failures(look.hypotheses.size());
  parallel_for(responses.size(), data.task().work.threads, [&](std::size_t h, int) {
    if (look.hypotheses[h].placed.size() > 1) return;
    const LookStage& own = few.at(joint_at(robot, look.hypotheses[h].where()));
    if (!own.linear.stretches.empty())
      responses[h] = responses_of(data, model, look.hypotheses[h], own, *look.stage, failures[h]);
  });
  for (std::size_t h = 0; h < responses.size(); ++h)
    if (responses[h].empty() && look.hypotheses[h].placed.size() == 1)
      look.untestable.push_back(without_probes(look.hypotheses[h], failures[h]));
  look.responses = std::make_shared<const std::vector<std::vector<ProbeResponse>>>(std::move(responses));
  promise(data, look);
  return look;
}

EffectLook look_beside(const SearchData& data, const FittedModel& model, const EffectLook& look) {
  EffectLook beside;
  beside.hypotheses = list_hypotheses(model.model.experiment, data.task().catalog, model.model.definition,
                                      data.task().among, beside.untestable);
  data.bound(beside.hypotheses);
  beside.stage = std::make_shared<const LookStage>(stage_for(data, model, look.stage->ladder));
  if (beside.stage->linear.stretches.empty() || !look.responses) return beside;
  std::map<std::string, std::size_t> known;
  for (std::size_t h = 0; h < look.hypotheses.size(); ++h) known[member_name(look.hypotheses[h].entry)] = h;
  std::vector<std::vector<ProbeResponse>> responses;
  for (const Hypothesis& hypothesis : beside.hypotheses) {
    const auto found = known.find(member_name(hypothesis.entry));
    responses.push_back(found == known.end() ? std::vector<ProbeResponse>{} : look.responses->at(found->second));
  }
  beside.responses = std::make_shared<const std::vector<std::vector<ProbeResponse>>>(std::move(responses));
  promise(data, beside);
  return beside;
}

NamedValues start_of_fit(const SearchData& data, const FittedModel& model, const EffectLook& look,
                         const EffectPromise& promise) {
  const LookStage& stage = *look.stage;
  const Hypothesis& hypothesis = look.hypotheses[promise.hypothesis];
  ProbedHypothesis probed(data, model, hypothesis, stage.ladder);
  const Eigen::Index own = stage.point.values.size();
  const std::vector<double> as_is = model.model.values;
  const std::vector<double> moved =
      stage.space.to_values(stage.space.clamp(stage.point.values + promise.step.head(own)));
  double least = std::numeric_limits<double>::infinity();
  NamedValues start = model.values;
  const Eigen::VectorXd sizes = promise.step.tail(promise.step.size() - own);
  for (const std::vector<double>& of_model : {as_is, moved})
    for (const std::vector<double>& of_effect : starting_values(hypothesis, promise.probes, sizes)) {
      const double cost = probed.cost(of_model, of_effect, stage.linear);
      if (!(cost < least)) continue;
      least = cost;
      const std::vector<std::string> names = hypothesis.own_names();
      for (std::size_t i = 0; i < names.size(); ++i) start[names[i]] = of_effect[i];
      for (const auto& [name, value] : named_values(model.model, of_model)) start[name] = value;
    }
  return start;
}

}  // namespace lacuna
