#pragma once

#include "dirty/dirty_case.h"
#include "dirty/owner_error.h"

#include <vector>

namespace hidden_effects::dirty {

/// What a case's effects are sized on: a rig with trials that are short enough to be carried out many times.
class SizingBench {
 public:
  /// `truth`: the rig's true values and no laws. Throws `std::runtime_error` where the rig runs away without any
  /// effect. `worst`: errors are those of the worst length of prediction instead of the mean over lengths.
  SizingBench(const DirtyRig& rig, const PlantSpec& truth, std::uint64_t seed, bool worst);

  /// Sets what errors are measured against, by sensor.
  void set_noise(std::vector<double> noise) { noise_ = std::move(noise); }

  /// Range of each sensor's readings, and RMS of their rate of change, of the rig without effects.
  const std::vector<double>& range() const { return range_; }
  const std::vector<double>& speed() const { return speed_; }

  /// How large things are where a law stands.
  Scales scales(const PlacedKind& placed) const;

  /// A law at a size; of its parameters nothing else follows.
  DirtyEffect sized(const PlacedKind& placed, const Shape& shape, double size) const;

  /// What the owner's refitted base leaves where these are the only effects, over the noise; 1e6 where the rig runs
  /// away.
  double error(const std::vector<DirtyEffect>& effects) const;

  /// The rig with the effects' values and laws.
  Truth truth_with(const std::vector<DirtyEffect>& effects) const;

 private:
  std::vector<TrueTrial> carry_out_all(const Truth& truth) const;
  bool trial_is_force(std::size_t sensor) const;

  DirtyRig rig_;  ///< with short trials
  PlantSpec true_spec_;
  std::uint64_t seed_;
  bool worst_;
  std::vector<double> noise_, range_, speed_;
  std::vector<TrueTrial> plain_;
};

/// A size at which the law alone leaves `wanted` times the noise, to a fifth, or what is nearest to it within what is
/// plausible; its error is put into `reached`. Gives up early where `enough` is far out of reach.
DirtyEffect sized_for(const SizingBench& bench, const PlacedKind& placed, const Shape& shape, double wanted,
                      double enough, double& reached);

}  // namespace hidden_effects::dirty
