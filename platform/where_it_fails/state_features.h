#pragma once

#include "fitting/comparison.h"

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

enum class FeatureKind {
  position,
  velocity,
  speed,
  direction,       ///< −1, 0 (at rest), 1
  since_reversal,  ///< s since the motion last came to rest or turned
  load,            ///< generalised force of actuators and joint laws, from the model
  work,            ///< ∫ |load · velocity| dt since the trial's first sample, J
  command,
  contact,  ///< 1: touches the ground; −1: does not; from the model
  time      ///< s, the trial's own
};

/// A physical quantity on which an error may depend.
struct StateFeature {
  FeatureKind kind = FeatureKind::time;
  std::string name;  ///< "velocity", "direction of motion"
  std::string of;    ///< element, as in "joint.hinge"; empty where there is only one
  std::string unit;
  bool classes() const { return kind == FeatureKind::direction || kind == FeatureKind::contact; }
  /// "velocity of joint.elbow"
  std::string full_name() const { return of.empty() ? name : name + " of " + of; }
};

/// Features at chosen samples of the fit trials, in the order of trials and time.
struct FeatureTable {
  std::vector<StateFeature> features;
  std::vector<std::size_t> trial;    ///< a row: index into `Comparison::trials`
  std::vector<Eigen::Index> sample;  ///< a row
  Eigen::MatrixXd values;            ///< rows × features; always finite
};

/// The input of the features. Everything that it refers to must live during the call.
struct FeatureTask {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;  ///< those of the comparison
  const std::vector<double>& values;
  const Comparison& comparison;
  Work work = {};
};

/// Positions and velocities come from the model's free run where it follows every channel of a trial to within three
/// floors: there it is as good as the measurement and has no noise in common with the residual. Elsewhere they are
/// measured (parabolas through 50 ms), with the model's own for coordinates without a sensor. Features that do not
/// vary, or repeat another one (|correlation| > 0.999), are left out. Trials that are held out, cannot be simulated or
/// have no known floor give no rows. At most `rows` samples are taken, equally spaced.
FeatureTable state_features(const FeatureTask& task, std::size_t rows = 6000);

}  // namespace lacuna
