#pragma once

#include "candidates/probe_sizes.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace lacuna {

/// What an effect at its probe changes of a model's predictions, by stretch, over a reading's standard deviation.
struct ProbeResponse {
  SizedProbe probe;
  std::vector<Eigen::VectorXd> change;
};

/// The effect's own values where its probes, which act together, are so many times as large.
std::vector<double> values_at_sizes(const Hypothesis& hypothesis, const std::vector<SizedProbe>& probes,
                                    const Eigen::VectorXd& sizes);

/// Values from which a fit of the effect may begin where it is promised at these sizes. What a factor promises to first
/// order is too much where it is far from 1: smaller parts are tried of it, too.
std::vector<std::vector<double>> starting_values(const Hypothesis& hypothesis, const std::vector<SizedProbe>& probes,
                                                 const Eigen::VectorXd& sizes);

/// By law the responses that act together: those of one form of the effect, each sized by another value of it. Equal
/// probes count once.
std::vector<std::vector<std::size_t>> laws_of(const Hypothesis& hypothesis,
                                              const std::vector<ProbeResponse>& responses);

}  // namespace lacuna
