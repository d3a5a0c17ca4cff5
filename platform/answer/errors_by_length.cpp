#include "answer/errors_by_length.h"

#include "prediction/settled_errors.h"

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Eigen::VectorXd mean_squares(const SearchData& data, const FittedModel& set, const PredictionLadder& ladder) {
  if (ladder.stretches.empty()) return {};
  const ModelContext context = data.bench_for(set.model);
  LadderPredictions predictions(ladder, context.predictor(), context.space(), data.starts(),
                                changes_readings(set.model.definition));
  return settled_errors(predictions, set.fit.point.values).value_or(Eigen::VectorXd());
}

}  // namespace

ErrorsByLength::ErrorsByLength(const SearchData& data, const FittedModel& set)
    : ladder_(data.ladder()),
      fitted_(mean_squares(data, set, data.ladder())),
      held_out_(mean_squares(data, set, data.held_out())) {}

bool ErrorsByLength::is_read(std::size_t length, std::size_t channel) const {
  return ladder_.layout.cells[ladder_.cell(length, channel)].weight > 0.0;
}

double ErrorsByLength::error(const Eigen::VectorXd& mean_squares, std::size_t length, std::size_t channel) const {
  const auto cell = static_cast<Eigen::Index>(ladder_.cell(length, channel));
  if (cell >= mean_squares.size() || !(mean_squares(cell) > 0.0)) return kUnknown;
  return ladder_.noise[channel].deviation * std::sqrt(mean_squares(cell));
}

double ErrorsByLength::times_floor() const {
  double sum = 0.0;
  for (std::size_t c = 0; c < ladder_.layout.cells.size(); ++c)
    if (const double weight = ladder_.layout.cells[c].weight; weight > 0.0) {
      if (static_cast<Eigen::Index>(c) >= fitted_.size()) return kUnknown;
      sum += weight * fitted_(static_cast<Eigen::Index>(c));
    }
  return std::sqrt(sum);
}

double ErrorsByLength::longest_length() const {
  double longest = 0.0;
  for (std::size_t length = 0; length < ladder_.lengths.size(); ++length)
    for (std::size_t channel = 0; channel < ladder_.noise.size(); ++channel)
      if (is_read(length, channel)) longest = ladder_.lengths[length];
  return longest;
}

std::vector<ChannelError> ErrorsByLength::longest() const {
  std::vector<ChannelError> errors;
  for (std::size_t channel = 0; channel < ladder_.noise.size(); ++channel)
    for (std::size_t length = ladder_.lengths.size(); length-- > 0;) {
      if (!is_read(length, channel)) continue;
      const ChannelNoise& noise = ladder_.noise[channel];
      errors.push_back(
          {noise.channel, noise.unit, noise.deviation, fitted(length, channel), held_out(length, channel)});
      break;
    }
  return errors;
}

std::vector<HorizonError> errors_by_horizon(const SearchData& data, const ErrorsByLength& base,
                                            const ErrorsByLength& answer) {
  const PredictionLadder& ladder = data.ladder();
  std::vector<HorizonError> all;
  for (std::size_t length = 0; length < ladder.lengths.size(); ++length)
    for (std::size_t channel = 0; channel < ladder.noise.size(); ++channel) {
      if (!base.is_read(length, channel)) continue;
      const ChannelNoise& noise = ladder.noise[channel];
      all.push_back({ladder.lengths[length], noise.channel, noise.unit, noise.deviation, base.fitted(length, channel),
                     answer.fitted(length, channel), base.held_out(length, channel), answer.held_out(length, channel)});
    }
  return all;
}

}  // namespace lacuna
