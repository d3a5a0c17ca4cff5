#include "search/decisions.h"

#include <cmath>

namespace lacuna {
namespace {

constexpr double kNearFloor = 6.0;
constexpr double kAboveFloor = 1.5;  ///< what an answer can lower
constexpr double kLowered = 0.95;
constexpr double kNearlyAll = 0.75;
constexpr double kToNoise = 2.0;  ///< times its noise, on readings that it was not fitted to

}  // namespace

bool is_near_floor(double most_times_floor) { return most_times_floor <= kNearFloor; }

Helped where_answer_helps(const std::vector<HorizonError>& horizons) {
  Helped helped;
  for (const HorizonError& one : horizons) {
    if (!(one.base > kAboveFloor * one.floor)) continue;
    ++helped.of;
    const bool is_held_out = std::isfinite(one.base_held_out) && std::isfinite(one.answer_held_out);
    const bool helps = one.answer < kLowered * one.base;
    if (helps && (!is_held_out || one.answer_held_out < kLowered * one.base_held_out)) ++helped.at;
  }
  return helped;
}

bool helps_everywhere(const Helped& helped) { return helped.share() >= kNearlyAll; }

bool explains_to_noise(const Diagnosis& by_likelihood) {
  return !by_likelihood.ranking.empty() && by_likelihood.ranking.front().times_floor <= kToNoise;
}

}  // namespace lacuna
