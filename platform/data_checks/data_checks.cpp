#include "data_checks/data_checks.h"

#include "data_checks/channel_checks.h"
#include "data_checks/command_checks.h"
#include "data_checks/copy_checks.h"
#include "data_checks/reading_scale.h"
#include "data_checks/trial_checks.h"
#include "data_checks/unit_checks.h"
#include "fitting/floor/noise_floor.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace lacuna {

namespace {

/// Compares the joints' motion with the commands, in trials that measure all of it.
std::vector<DataWarning> motion_doubts(const DataCheckTask& all) {
  std::vector<Trial> whole;
  std::copy_if(all.trials.begin(), all.trials.end(), std::back_inserter(whole), [&](const Trial& trial) {
    return !trial.held_out && !is_saturated(all.definition.structure.robot, trial);
  });
  if (whole.empty()) return {};
  const DataCheckTask task{all.definition, all.model, whole, all.values, false, all.stop};
  const std::vector<ChannelNoise> noise = sensor_noise(task.definition.structure.robot, task.trials);
  const AccelerationTable table = acceleration_table(task, noise);
  // A wrong unit explains the other findings.
  if (const std::optional<DataWarning> unit = unit_doubt(task, table, noise)) return {*unit};
  if (const std::optional<ReadingScale> scale = reading_scale(task))
    return {{Severity::fault, to_string(*scale) + "; check counts per turn, gears and unit of the column"}};
  const CommandLags lags = command_lags(task, table);
  std::vector<DataWarning> doubts = command_checks(task, table, lags);
  for (DataWarning& doubt : trial_checks(table, lags)) doubts.push_back(std::move(doubt));
  return doubts;
}

std::vector<std::string> sentences_of(Severity severity, const std::vector<DataWarning>& doubts) {
  std::vector<std::string> sentences;
  for (const DataWarning& doubt : doubts)
    if (doubt.severity == severity) sentences.push_back(doubt.sentence);
  return sentences;
}

}  // namespace

std::vector<DataWarning> data_checks(const DataCheckTask& task) {
  std::vector<DataWarning> doubts;
  const auto add = [&](const std::vector<DataWarning>& more) { doubts.insert(doubts.end(), more.begin(), more.end()); };
  add(channel_checks(task));
  const std::vector<DataWarning> feedback = feedback_checks(task);
  add(feedback);
  if (faults_among(feedback).empty()) add(motion_doubts(task));  // else the command columns themselves are wrong
  add(copy_checks(task.trials));
  add(amount_doubts(task));
  std::stable_partition(doubts.begin(), doubts.end(),
                        [](const DataWarning& doubt) { return doubt.severity != Severity::note; });
  return doubts;
}

std::vector<std::string> faults_among(const std::vector<DataWarning>& doubts) {
  return sentences_of(Severity::fault, doubts);
}

std::vector<std::string> limits_among(const std::vector<DataWarning>& doubts) {
  return sentences_of(Severity::too_little, doubts);
}

}  // namespace lacuna
