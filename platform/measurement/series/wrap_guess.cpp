#include "measurement/series/wrap_guess.h"

#include "foundation/statistics.h"
#include "measurement/series/known_readings.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr std::size_t kFewestOnASide = 3;      ///< values in either half of the range
constexpr std::size_t kFewestLevelsRead = 20;  ///< number of distinct values of a moving robot
constexpr double kSmallestModulus = 60.0;      ///< counts
constexpr std::size_t kFewestForUnusual = 3;   ///< jumps that show an unusual modulus
constexpr double kErrors = 3.5;                ///< standard errors to either side of an estimate
constexpr double kMostAveraged = 16.0;         ///< jumps: an error common to many does not average out
constexpr double kMostSpread = 0.1;            ///< of the modulus, error of a single jump's estimate
constexpr double kMostError = 0.1;             ///< of the modulus
constexpr double kMostUnlike = 0.1;            ///< of the jumps, as for glitches
constexpr double kUnlike = 6.0;                ///< standard deviations from the estimate
constexpr double kLeastChance = 1e-5;          ///< probability that crossings leave so much of the range unread
constexpr std::size_t kFewestTrials = 20;      ///< jumps elsewhere that show the accuracy of estimates
constexpr std::size_t kOtherPlaces = 12;       ///< to wrap at
constexpr double kLeastInformation = 1e-3;     ///< of a window, beyond any polynomial
constexpr double kRoundingToCounts = 0.29;     ///< counts, 1/sqrt(12)
constexpr std::size_t kMostPlaces = 4000;      ///< more add no information
constexpr double kSpreadOfStep = 0.2;          ///< of where crossings begin; for uniformly distributed ones 0.29
constexpr double kRounding = 1e-9;

/// Readings of one file and the number of restarts of the counter so far.
struct Counted {
  std::vector<double> values, wraps;
  std::vector<std::size_t> places;  ///< in the file
  std::size_t before = 0;           ///< readings of the files before
};

/// A polynomial fitted to readings on both sides of a place.
struct WindowShape {
  std::size_t half;
  Eigen::Index degree;
};
constexpr WindowShape kShapes[] = {{2, 1}, {3, 2}, {4, 3}, {8, 3}};

struct Range {
  double lowest = 0.0, highest = 0.0;
  bool whole = true;
  double width() const { return highest - lowest; }
};

Range range_of(std::span<const Counted> files) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Counted& file : files)
    for (const double value : file.values) {
      range.lowest = std::min(range.lowest, value);
      range.highest = std::max(range.highest, value);
      range.whole = range.whole && value == std::round(value);
    }
  return range;
}

bool moves_in_both_halves(std::span<const Counted> files, const Range& range) {
  std::set<double> low, high;
  for (const Counted& file : files)
    for (const double value : file.values) (value - range.lowest < 0.5 * range.width() ? low : high).insert(value);
  return std::min(low.size(), high.size()) >= kFewestOnASide && low.size() + high.size() >= kFewestLevelsRead;
}

/// A change of more than half the range is a jump.
void count_wraps(const Range& range, Counted& file) {
  file.wraps.assign(file.values.size(), 0.0);
  for (std::size_t i = 1; i < file.values.size(); ++i) {
    const double change = file.values[i] - file.values[i - 1];
    file.wraps[i] = file.wraps[i - 1];
    if (std::abs(change) > 0.5 * range.width()) file.wraps[i] -= std::copysign(1.0, change);
  }
}

/// The part of `column` that no polynomial in the positions explains.
Eigen::VectorXd beyond_polynomial(const Counted& file, std::size_t first, Eigen::Index degree,
                                  const Eigen::VectorXd& column) {
  Eigen::MatrixXd powers(column.size(), degree + 1);
  const double half = 0.5 * static_cast<double>(column.size()), middle = static_cast<double>(file.places[first]) + half;
  for (Eigen::Index j = 0; j < column.size(); ++j)
    for (Eigen::Index p = 0; p <= degree; ++p)
      powers(j, p) =
          std::pow((static_cast<double>(file.places[first + static_cast<std::size_t>(j)]) - middle) / half, p);
  return column - powers * powers.householderQr().solve(column);
}

/// Estimate of the modulus from a few consecutive readings.
struct Estimate {
  double modulus = 0.0;
  double information = 0.0;  ///< one over the variance, for readings of variance 1
};

Estimate estimate_at(const Counted& file, std::size_t first, Eigen::Index degree, const Eigen::VectorXd& wraps,
                     const Eigen::VectorXd& values) {
  const Eigen::VectorXd own = beyond_polynomial(file, first, degree, wraps);
  const double information = own.squaredNorm();
  return {information > 0.0 ? -own.dot(values) / information : 0.0, information};
}

Eigen::VectorXd piece(const std::vector<double>& values, std::size_t first, std::size_t count) {
  return Eigen::Map<const Eigen::VectorXd>(values.data() + first, static_cast<Eigen::Index>(count)).array() -
         values[first];
}

double middle_of(std::vector<double> values) { return median_of(values); }

/// With windows of one shape that do not overlap, at jumps.
std::vector<Estimate> estimates_at_jumps(std::span<const Counted> files, const WindowShape& shape) {
  std::vector<Estimate> estimates;
  const std::size_t length = 2 * shape.half;
  for (const Counted& file : files)
    for (std::size_t i = shape.half; i + shape.half <= file.values.size() && estimates.size() < kMostPlaces; ++i) {
      if (file.wraps[i] == file.wraps[i - 1]) continue;
      const std::size_t first = i - shape.half;
      const Estimate one =
          estimate_at(file, first, shape.degree, piece(file.wraps, first, length), piece(file.values, first, length));
      if (one.information > kLeastInformation) estimates.push_back(one);
      i += shape.half - 1;
    }
  return estimates;
}

/// The readings that the same counter would give if it restarted at another value.
std::vector<Counted> wrapped_elsewhere(std::span<const Counted> files, double modulus, double from) {
  std::vector<Counted> others(files.begin(), files.end());
  for (Counted& file : others)
    for (std::size_t i = 0; i < file.values.size(); ++i) {
      const double decoded = file.values[i] + modulus * file.wraps[i];
      file.wraps[i] = std::floor((decoded - from) / modulus);
      file.values[i] = decoded - modulus * file.wraps[i];
    }
  return others;
}

/// A value that only a few readings are below: a motion passes through them.
std::vector<double> places_to_wrap_at(std::span<const Counted> files, double modulus) {
  std::vector<double> decoded;
  for (const Counted& file : files)
    for (std::size_t i = 0; i < file.values.size(); ++i) decoded.push_back(file.values[i] + modulus * file.wraps[i]);
  std::sort(decoded.begin(), decoded.end());
  std::vector<double> places;
  for (std::size_t i = 1; i <= kOtherPlaces; ++i) places.push_back(decoded[i * decoded.size() / (kOtherPlaces + 1)]);
  return places;
}

/// Error of estimates where the modulus is known, from readings that are wrapped elsewhere.
struct Accuracy {
  double bias = 0.0;
  double spread = 0.0;  ///< about that, of readings with an information of 1
};

std::optional<Accuracy> accuracy_of(std::span<const Counted> files, const WindowShape& shape, double modulus) {
  std::vector<Estimate> trials;
  for (const double place : places_to_wrap_at(files, modulus))
    for (const Estimate& one : estimates_at_jumps(wrapped_elsewhere(files, modulus, place), shape))
      trials.push_back(one);
  if (trials.size() < kFewestTrials) return std::nullopt;
  std::vector<double> errors, sizes;
  for (const Estimate& one : trials) errors.push_back(one.modulus - modulus);
  const double bias = middle_of(errors);
  for (const Estimate& one : trials)
    sizes.push_back(std::abs(one.modulus - modulus - bias) * std::sqrt(one.information));
  const auto high = sizes.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(sizes.size()));
  std::nth_element(sizes.begin(), high, sizes.end());
  const double beyond = 0.5 * *high;
  return Accuracy{bias, std::max(1.4826 * middle_of(sizes), beyond)};
}

struct Measured {
  double modulus = 0.0, error = 0.0;
};

std::optional<Measured> measure_by(std::span<const Counted> files, const WindowShape& shape, bool whole) {
  const std::vector<Estimate> estimates = estimates_at_jumps(files, shape);
  if (estimates.empty()) return std::nullopt;
  std::vector<double> moduli;
  for (const Estimate& one : estimates) moduli.push_back(one.modulus);
  const double middle = middle_of(moduli);
  const std::optional<Accuracy> accuracy = middle > 0.0 ? accuracy_of(files, shape, middle) : std::nullopt;
  if (!accuracy) return std::nullopt;
  const double spread = std::max({accuracy->spread, whole ? kRoundingToCounts : 0.0, kRounding * middle});
  double weights = 0.0, weighted = 0.0, alike = 0.0;
  for (const Estimate& one : estimates) {
    const double error = spread / std::sqrt(one.information);
    if (error > kMostSpread * middle || std::abs(one.modulus - middle) > kUnlike * error) continue;
    weights += one.information;
    weighted += one.information * one.modulus;
    alike += 1.0;
  }
  const auto all = static_cast<double>(estimates.size());
  if (2.0 * alike < all || all - alike > std::max(1.0, kMostUnlike * all)) return std::nullopt;
  return Measured{weighted / weights - accuracy->bias,
                  spread / std::sqrt(weights / alike * std::min(alike, kMostAveraged))};
}

/// With windows of the shape that determines it best.
std::optional<Measured> measure(std::span<const Counted> files, bool whole) {
  std::optional<Measured> best;
  for (const WindowShape& shape : kShapes) {
    const std::optional<Measured> one = measure_by(files, shape, whole);
    if (one && (!best || one->error < best->error)) best = one;
  }
  return best;
}

/// Probability that crossings leave unread the part of a modulus beyond the range of the readings: each does so with
/// the share of its step that lies within the range. Where steps are synchronous with the readings, nothing follows.
class Crossings {
 public:
  Crossings(std::span<const Counted> files, double read) : read_(read) {
    for (const Counted& file : files)
      for (std::size_t i = 1; i < file.values.size(); ++i)
        if (file.wraps[i] != file.wraps[i - 1]) seen_.insert({file.values[i - 1], file.values[i]});
    for (const auto& [before, after] : seen_) (after < before ? top_ : bottom_).push_back(before);
  }

  double chance(double modulus) const {
    double chance = 1.0;
    for (const auto& [before, after] : seen_) {
      const double jump = std::abs(after - before), read = std::max(read_ - jump, 1.0), step = modulus - jump;
      if (step > read) chance *= read / step;
    }
    return begins_anywhere(modulus) ? chance : 1.0;
  }

 private:
  bool begins_anywhere(double modulus) const {
    std::vector<double> steps;
    for (const auto& [before, after] : seen_) steps.push_back(modulus - std::abs(after - before));
    const double spread = std::max(spread_of(top_), spread_of(bottom_));
    return spread > kSpreadOfStep * middle_of(steps);
  }
  static double spread_of(const std::vector<double>& places) {
    if (places.size() < 2) return 0.0;
    const Eigen::Map<const Eigen::ArrayXd> all(places.data(), static_cast<Eigen::Index>(places.size()));
    return std::sqrt((all - all.mean()).square().mean());
  }

  double read_;
  std::set<std::pair<double, double>> seen_;
  std::vector<double> top_, bottom_;  ///< readings before crossings
};

bool is_usual(double count) {
  double rest = count;
  for (const auto& [factor, most] : {std::pair(2.0, 64), std::pair(3.0, 2), std::pair(5.0, 20)})
    for (int n = 0; n < most && std::fmod(rest, factor) == 0.0; ++n) rest /= factor;
  return rest == 1.0;
}

std::vector<double> usual_counts(double from, double to) {
  std::vector<double> counts;
  if (to - from > 1e6) return counts;
  for (double count = std::max(std::ceil(from), kSmallestModulus); count <= to; count += 1.0)
    if (is_usual(count)) counts.push_back(count);
  return counts;
}

/// Turns and a few of their multiples and parts, the turn itself first; whole where readings are.
std::vector<double> of_turns(std::span<const double> turns, bool whole) {
  std::vector<double> moduli;
  for (const double factor : {1.0, 2.0, 4.0, 0.5, 0.25, 8.0, 16.0, 3.0, 5.0, 10.0})
    for (const double turn : turns) {
      if (!whole && (factor > 2.0 || factor < 0.5)) continue;
      double modulus = factor * turn;
      const double nearest = std::round(modulus);
      if (whole && std::abs(modulus - nearest) > 1e-5 * modulus + 0.01) continue;
      if (whole) modulus = nearest;
      moduli.push_back(modulus);
    }
  return moduli;
}

}  // namespace

std::optional<FoundWrap> find_wrap(std::span<const std::vector<double>> all, std::span<const double> turns) {
  std::vector<Counted> files;
  std::size_t before = 0;
  for (const std::vector<double>& column : all) {
    KnownReadings known(column);
    files.push_back({std::move(known.values), {}, std::move(known.places), before});
    before += column.size();
  }
  const Range range = range_of(files);
  if (!(range.width() > 0.0)) return std::nullopt;
  FoundWrap found;
  for (Counted& file : files) {
    count_wraps(range, file);
    for (std::size_t i = 1; i < file.values.size(); ++i)
      if (file.wraps[i] != file.wraps[i - 1] && found.jumps++ == 0) found.first = file.before + file.places[i];
  }
  if (found.jumps == 0 || !moves_in_both_halves(files, range)) return std::nullopt;
  const std::optional<Measured> measured = measure(files, range.whole);
  const double read = range.whole ? range.width() + 1.0 : range.width() * (1.0 - kRounding);
  if (!measured || measured->error * kErrors > kMostError * measured->modulus) return std::nullopt;
  const double reach = kErrors * measured->error + (range.whole ? 1.0 : 0.0);
  const double from = std::max(read, measured->modulus - reach), to = measured->modulus + reach;
  if (from > to) return std::nullopt;
  found.estimate = measured->modulus;
  found.error = measured->error;
  const Crossings crossings(files, read);
  const auto take = [&](double modulus) {
    const bool is_new = std::find(found.moduli.begin(), found.moduli.end(), modulus) == found.moduli.end();
    if (is_new && modulus >= from && modulus <= to && crossings.chance(modulus) > kLeastChance)
      found.moduli.push_back(modulus);
  };
  for (const double modulus : of_turns(turns, range.whole)) take(modulus);
  found.is_certain = !found.moduli.empty() && std::any_of(turns.begin(), turns.end(), [&](double turn) {
    return std::abs(turn - found.moduli.front()) <= 1e-5 * turn + 0.01;
  });
  if (range.whole)
    for (const double count : usual_counts(from, to)) take(count);
  const double nearest = std::round(measured->modulus);
  if (range.whole && found.moduli.empty() && found.jumps >= kFewestForUnusual && reach < 2.0 && nearest >= read)
    found.moduli.push_back(nearest);
  if (found.moduli.empty() && (!range.whole || found.jumps < kFewestForUnusual)) return std::nullopt;
  found.is_certain = found.is_certain || found.moduli.size() == 1;
  return found;
}

}  // namespace lacuna
