#include "figures/left_out.h"

#include "calibration/calibrate.h"

namespace hidden_effects {

void add_left_out(const Database& database, FigureValues& all) {
  const lacuna::ShippedCalibration& shipped = lacuna::shipped_calibration();
  for (const JudgedVerdict& one : judged_verdicts(database, all.versions, all.set)) {
    const auto rig = shipped.without.find(one.rig);
    const lacuna::Calibration& calibration = rig == shipped.without.end() ? shipped.all : rig->second;
    const auto verdict = calibration.find(one.verdict);
    if (verdict == calibration.end()) continue;
    const double probability = verdict->second.probability(one.evidence);
    const auto add = [&](const char* figure, double value) {
      all.values.push_back({figure, value, probability, one.noise, one.strength, one.rig, one.effect, one.form});
    };
    add("brier_left_out", (probability - one.is_right) * (probability - one.is_right));
    add("calibration_left_out", one.is_right);
    add("calibration_by_chance", one.is_right);
  }
}

}  // namespace hidden_effects
