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
  load,            ///< generalised force of actuators and joint laws, as the model has it
  work,            ///< ∫ |load · velocity| dt since the trial's first sample, J
  command,
  contact,  ///< 1: touches the ground; −1: does not; as the model has it
  time      ///< s, the trial's own
};

/// A physical quantity that an error may depend on.
struct StateFeature {
  FeatureKind kind = FeatureKind::time;
  std::string name;  ///< "velocity", "direction of motion"
  std::string of;    ///< element, as in "joint.hinge"; empty where there is nothing to tell apart
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

/// What features are computed from. Everything referred to must live during the call.
struct FeatureTask {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;  ///< those of the comparison
  const std::vector<double>& values;
  const Comparison& comparison;
  int threads = 1;
};

/// Positions and velocities are those of the model's free run where it follows every channel of a trial to within three
/// floors: it is then as good as what was measured, and shares no noise with the residual. Else they are what
/// was measured (parabolas through 50 ms of it), and the model's own for coordinates that nothing measures, as of a
/// robot with few sensors. Features that do not vary, or repeat another one (|correlation| > 0.999), are left out.
/// Trials that are held out, cannot be simulated or have no known floor give no rows. At most `rows` samples are taken,
/// equally spaced.
FeatureTable state_features(const FeatureTask& task, std::size_t rows = 6000);

}  // namespace lacuna
