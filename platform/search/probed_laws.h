#pragma once

#include "candidates/probe_sizes.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace lacuna {

/// The change of a model's predictions by an effect at its probe, by stretch, over a reading's standard deviation.
struct ProbeResponse {
  SizedProbe probe;
  std::vector<Eigen::VectorXd> change;
};

/// The effect's values where its probes, which add up, are scaled by these factors.
std::vector<double> values_at_sizes(const Hypothesis& hypothesis, const std::vector<SizedProbe>& probes,
                                    const Eigen::VectorXd& sizes);

/// Start values for a fit of the effect, given these first-order factors. For a factor far from 1 the first order
/// predicts too much, so smaller steps are tried, too.
std::vector<std::vector<double>> starting_values(const Hypothesis& hypothesis, const std::vector<SizedProbe>& probes,
                                                 const Eigen::VectorXd& sizes);

/// By law the responses that can be added: those of one form of the effect, each sized by another parameter. Equal
/// probes count once.
std::vector<std::vector<std::size_t>> laws_of(const Hypothesis& hypothesis,
                                              const std::vector<ProbeResponse>& responses);

}  // namespace lacuna
