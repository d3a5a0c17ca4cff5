#pragma once

#include <lacuna/error.h>

#include "storage/core/canonical_text.h"
#include "storage/results/result_store.h"
#include "support/test_folder.h"

#include <cmath>
#include <filesystem>
#include <string>

namespace lacuna::test {

inline const std::string kSomeDigest(64, 'a');
inline const std::string kOtherDigest(64, 'b');

/// A swinging arm with one encoder; effects are friction of its joint.
inline RevisionRecord revision_with(const EffectList& effects) {
  RobotSpec robot;
  robot.name = "rig";
  robot.bodies.emplace_back().name = "arm";
  JointSpec& hinge = robot.joints.emplace_back();
  hinge.name = "hinge";
  hinge.child = "arm";
  return {.robot = "declared",
          .robot_text = canonical_text(robot),
          .free = {{"body.arm.mass", "kg", 0.1, 2.0, 0.5}},
          .effects = effects,
          .engine = {},
          .fit_data_digest = kSomeDigest};
}

/// A run that stores experiments with a text of `size` bytes each.
inline void add_experiments(Database& database, int first, int count, std::size_t size = 5000) {
  ResultStore store(database);
  store.begin_run({.command = "test", .seed = 1, .threads = 1}, {});
  for (int i = first; i < first + count; ++i)
    store.record_experiment({"experiment " + std::to_string(i), "rig.toml", std::string(size, 'x'), {}});
}

inline EffectEntry friction(const std::string& name) {
  return {.id = name, .effect = name, .where = {"joint.hinge"}, .start = {}, .fixed = {}};
}

inline TimeSeries sine(int samples, double amplitude = 0.3) {
  TimeSeries series;
  series.channels = {{"angle", "rad"}};
  series.times = Eigen::VectorXd::LinSpaced(samples, 0.0, 0.001 * (samples - 1));
  series.samples = (amplitude * (6.28 * series.times.array()).sin()).matrix();
  return series;
}

struct SmallDatabase {
  ExperimentId experiment;
  TrialId fit_trial;
  TrialId held_out_trial;
  RevisionId rigid;
  RevisionId with_friction;
  ComparisonId first_comparison;
};

/// Scores of both trials; `scale` multiplies the errors.
inline ComparisonRecord comparison_of(const SmallDatabase& small, FitId fit, int look, double scale) {
  const auto score = [&](TrialId trial, double rmse) {
    return ScoreRecord{.trial = trial,
                       .channel = "angle",
                       .unit = "rad",
                       .horizon = 0.0,
                       .samples = 1000,
                       .rmse = rmse,
                       .normalised_rmse = rmse / 0.2,
                       .theil_u = rmse / 0.4,
                       .bias = 0.1 * rmse,
                       .bias_share = 0.01,
                       .magnitude_share = 0.2,
                       .phase_share = 0.79,
                       .max_error = 3.0 * rmse,
                       .max_error_time = 3.42,
                       .floor = 0.001,
                       .numerical_error = 2e-5,
                       .as_written_rmse = 0.041};
  };
  return {.kind = ComparisonKind::refitted,
          .fit = fit,
          .look = look,
          .step = 0.001,
          .scores = {score(small.fit_trial, 0.009 * scale), score(small.held_out_trial, 0.012 * scale)},
          .floors = {{small.fit_trial, "angle", "rad", 0.001, 0.0008, kNotKnown, 0.0006, "encoder step 2.9/√12"}},
          .findings = {"61 % of squared error after reversals"},
          .seconds = 1.2};
}

/// What a diagnosis of the first revision finds: the effect that the second one has.
inline DiagnosisRecord found_friction() {
  CandidateRecord friction_candidate;
  friction_candidate.effects = {"coulomb_friction @ joint.hinge"};
  friction_candidate.look_alikes = {"stribeck_friction @ joint.hinge"};
  friction_candidate.gain = 2140.0;
  friction_candidate.gain_lower = 1980.0;
  friction_candidate.gain_upper = 2300.0;
  friction_candidate.times_floor = 1.1;
  friction_candidate.probability = 0.97;
  friction_candidate.values = {{"coulomb_friction", "joint.hinge", "torque", "N*m", 0.131, 0.126, 0.136}};
  return {.settings = "all effects",
          .verdict = "effect_found",
          .method = "likelihood",
          .probability = 0.97,
          .chance = 0.0005,
          .hypotheses = 43,
          .base_times_floor = 10.8,
          .document = R"({"verdict": "effect_found"})",
          .candidates = {friction_candidate}};
}

/// Two revisions, each fitted and compared: the content that the documentation's examples show.
inline SmallDatabase fill_small_database(ResultStore& store) {
  store.begin_run({.command = "lacuna compare rig.toml", .seed = 1, .threads = 2}, provenance_of_this_program());
  store.record_plugins({{"effects/coulomb_friction.so", kSomeDigest, "0.1.0"}});
  SmallDatabase small;
  small.experiment = store.record_experiment(
      {.name = "rig", .file = "rig.toml", .text = "[experiment]\nname = \"rig\"\n", .overrides = {}});
  small.fit_trial = store.find_or_add_trial(small.experiment, {"sine", "sine.csv", kSomeDigest, false, 10.0, 1000});
  small.held_out_trial =
      store.find_or_add_trial(small.experiment, {"chirp", "chirp.csv", kOtherDigest, true, 10.0, 1000});
  store.record_trace(small.fit_trial, TraceKind::measured, sine(1000), TracePrecision::float64);
  double scale = 1.0;
  for (const EffectList& effects : {EffectList{}, EffectList{friction("coulomb_friction")}}) {
    const StoredRevision revision = store.find_or_add_revision(small.experiment, revision_with(effects));
    FitRecord fit;
    fit.settings = "free_run";
    fit.method = "free_run";
    fit.loss = "huber";
    fit.converged = true;
    fit.values = {{"body.arm.mass", "kg", 0.5, 0.56, 0.004, 0.552, 0.568, AtBound::neither, true}};
    fit.stages = {{"free run", 0.0, 1, 4, 3, 12, true, 1.1, {0.56}}};
    fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1.6e-5);
    fit.notes = {"mass and gain appear only as a product"};
    fit.seconds = 1.0;
    const FitId fitted = store.record_fit(revision.id, fit);
    const int look = store.count_holdout_look(revision.id, "lacuna compare rig.toml");
    const ComparisonId comparison = store.record_comparison(revision.id, comparison_of(small, fitted, look, scale));
    store.record_trace(small.fit_trial, TraceKind::predicted, sine(1000, 0.29), TracePrecision::float32, comparison);
    if (effects.empty()) small.first_comparison = comparison;
    if (effects.empty()) store.record_diagnosis(revision.id, found_friction());
    (effects.empty() ? small.rigid : small.with_friction) = revision.id;
    scale = 0.1;
  }
  store.end_run(RunEnding::done);
  return small;
}

}  // namespace lacuna::test
