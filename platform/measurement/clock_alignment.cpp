#include "measurement/clock_alignment.h"

#include "foundation/interrupt.h"
#include "measurement/blocked_regression.h"
#include "measurement/clock_check.h"
#include "measurement/smooth_signal.h"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kBlocks = 8;
constexpr std::size_t kReach = 4;            ///< steps, of each of two smoothings
constexpr std::int64_t kRowStride = kReach;  ///< steps from row to row: half of what smoothing reaches
constexpr double kSlow = 0.1;                ///< of the usual speed: friction turns round within it
constexpr double kCoarsest = 750.0;          ///< windows in the longer recording when first looking
constexpr double kFewestIntervals = 4;       ///< of the slower device within a window's reach
constexpr double kAround = 4.0;              ///< reaches to either side that are looked at again with a finer one
constexpr double kMostWindows = 2e4;         ///< in the longer recording: finer ones would take minutes
constexpr double kLeastOverlap = 0.5;        ///< of the shorter recording
constexpr double kLeastVariance = 0.1;       ///< of a target's: where it hardly changes, nothing explains it
constexpr double kDistinct = 3.0;            ///< standard errors between the best offset and any other
constexpr double kMostUnexplained = 0.5;     ///< of a target, unexplained
constexpr int kSkewRounds = 3;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

using Signals = std::vector<ClockedSignal>;

double begin_of(const Signals& signals) {
  double begin = std::numeric_limits<double>::infinity();
  for (const ClockedSignal& one : signals) begin = std::min(begin, one.times.front());
  return begin;
}

double end_of(const Signals& signals) {
  double end = -std::numeric_limits<double>::infinity();
  for (const ClockedSignal& one : signals) end = std::max(end, one.times.back());
  return end;
}

double slowest_interval(const Signals& signals) {
  double slowest = 0.0;
  for (const ClockedSignal& one : signals) slowest = std::max(slowest, median_interval(one.times));
  return slowest;
}

/// The signals of one device at even moments: what may explain others, and what is to be explained.
struct Sampled {
  Lattice lattice;
  Eigen::MatrixXd features, targets;
};

void standardise(Eigen::Ref<Eigen::MatrixXd> columns) {
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (const double value : columns.col(c)) {
      if (std::isnan(value)) continue;
      sum += value;
      squares += value * value;
      count += 1.0;
    }
    const double deviation = std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
    if (deviation > 0.0) columns.col(c) = (columns.col(c).array() - sum / count) / deviation;
  }
}

double size_of(const std::vector<double>& values) {
  double squares = 0.0, count = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) squares += value * value, count += 1.0;
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

using Column = std::vector<double>;

/// What a reading says of the forces on its joint: each smoothed twice, as all other signals are. What is not linear in
/// the reading is computed before the second smoothing, so that the two change places with little error.
std::vector<Column> features_of(const ClockedSignal& reading, const Lattice& lattice, std::size_t reach) {
  const Column once = smoothed(step_means(reading.times, reading.values, false, lattice), reach);
  const bool is_position = reading.unit == "rad" || reading.unit == "m";
  const Column rates = rates_of(once, lattice.step);
  std::vector<Column> features = {once, rates};
  if (is_position) features.push_back(rates_of(rates, lattice.step));
  const Column& velocity = is_position ? rates : once;
  const double usual = size_of(velocity);
  Column direction;
  for (const double value : velocity) direction.push_back(usual > 0.0 ? std::tanh(value / (kSlow * usual)) : 0.0);
  features.push_back(std::move(direction));
  for (const double shift : {0.0, 0.5 * M_PI}) {
    if (reading.unit != "rad") continue;
    Column sine;
    for (const double value : once) sine.push_back(std::sin(value + shift));
    features.push_back(std::move(sine));
  }
  for (Column& feature : features) feature = smoothed(feature, reach);
  return features;
}

Sampled sample(const Signals& signals, const Lattice& lattice) {
  Sampled sampled{lattice, {}, {}};
  std::vector<Column> features, targets;
  for (const ClockedSignal& one : signals) {
    const Column once = smoothed(step_means(one.times, one.values, one.held, lattice), kReach);
    targets.push_back(smoothed(once, kReach));
    if (!one.is_reading) continue;
    for (Column& feature : features_of(one, lattice, kReach)) features.push_back(std::move(feature));
  }
  const auto rows = static_cast<Eigen::Index>(lattice.count);
  for (auto [columns, matrix] : {std::pair(&features, &sampled.features), std::pair(&targets, &sampled.targets)}) {
    matrix->resize(rows, static_cast<Eigen::Index>(columns->size()));
    for (std::size_t c = 0; c < columns->size(); ++c)
      matrix->col(static_cast<Eigen::Index>(c)) = Eigen::Map<const Eigen::VectorXd>((*columns)[c].data(), rows);
    standardise(*matrix);
  }
  return sampled;
}

/// Both devices on lattices of one step.
struct SampledPair {
  Sampled first, second;
  double base = 0.0;  ///< s, the offset at a shift of no step
  double offset(std::int64_t shift) const { return base + static_cast<double>(shift) * first.lattice.step; }
};

SampledPair sample_pair(const Signals& first, const Signals& second, double step) {
  const auto lattice = [step](const Signals& signals) {
    const double begin = begin_of(signals);
    return Lattice{begin, step, static_cast<std::size_t>((end_of(signals) - begin) / step) + 1};
  };
  const Lattice a = lattice(first), b = lattice(second);
  return {sample(first, a), sample(second, b), a.start - b.start};
}

/// Which side's readings explain the other's signals.
enum class By { second, first };

/// One, a row of features and one of targets; false where a value is missing.
bool join(const Eigen::MatrixXd& features, Eigen::Index feature, const Eigen::MatrixXd& targets, Eigen::Index target,
          Eigen::VectorXd& row) {
  double* to = row.data();
  *to++ = 1.0;
  for (Eigen::Index c = 0; c < features.cols(); ++c) *to++ = features.data()[c * features.rows() + feature];
  for (Eigen::Index c = 0; c < targets.cols(); ++c) *to++ = targets.data()[c * targets.rows() + target];
  return std::all_of(row.data(), to, [](double value) { return std::isfinite(value); });
}

/// Row i of the first goes with row i − shift of the second.
BlockedRegression regress(const SampledPair& pair, By by, std::int64_t shift) {
  throw_if_interrupted();
  const Eigen::MatrixXd& features = by == By::second ? pair.second.features : pair.first.features;
  const Eigen::MatrixXd& targets = by == By::second ? pair.first.targets : pair.second.targets;
  BlockedRegression regression(features.cols() + 1, targets.cols(), kBlocks);
  Eigen::VectorXd row(features.cols() + 1 + targets.cols());
  const auto rows = static_cast<std::int64_t>(pair.first.lattice.count);
  const std::int64_t begin = std::max<std::int64_t>(0, shift);
  const auto end = std::min(rows, static_cast<std::int64_t>(pair.second.lattice.count) + shift);
  for (std::int64_t i = (begin + kRowStride - 1) / kRowStride * kRowStride; i < end; i += kRowStride) {
    const std::int64_t of_features = by == By::second ? i - shift : i, of_targets = by == By::second ? i : i - shift;
    if (join(features, of_features, targets, of_targets, row))
      regression.add(static_cast<std::size_t>(i) * kBlocks / static_cast<std::size_t>(rows), row);
  }
  return regression;
}

/// The share of a target that the readings do not explain; NaN where it hardly varies in this overlap.
double unexplained(const BlockedRegression& regression, Eigen::Index target) {
  return regression.rows() > 0.0 && regression.variance(target) > kLeastVariance ? regression.unexplained(target)
                                                                                 : kUnknown;
}

struct Best {
  By by = By::second;
  Eigen::Index target = 0;
  std::int64_t shift = 0;
  double unexplained = std::numeric_limits<double>::infinity();
};

struct Shifts {
  std::int64_t from = 0, to = 0;
};

Shifts shifts_within(const SampledPair& pair, const std::pair<double, double>& between) {
  const auto a = static_cast<double>(pair.first.lattice.count), b = static_cast<double>(pair.second.lattice.count);
  const double least = kLeastOverlap * std::min(a, b), step = pair.first.lattice.step;
  const double from = std::max(least - b, (between.first - pair.base) / step);
  const double to = std::min(a - least, (between.second - pair.base) / step);
  return {static_cast<std::int64_t>(std::ceil(from)), static_cast<std::int64_t>(std::floor(to))};
}

/// The shift at which some target is explained best, and all others at which it is explained better than beside them.
struct Found {
  Best best;
  std::vector<std::int64_t> others;
};

Found scan_offsets(const SampledPair& pair, const Shifts& shifts) {
  struct Profile {
    By by;
    std::vector<std::vector<double>> unexplained;  ///< by target, then shift
  };
  std::vector<Profile> profiles;
  for (const By by : {By::second, By::first}) {
    const Sampled& explaining = by == By::second ? pair.second : pair.first;
    const Sampled& explained = by == By::second ? pair.first : pair.second;
    if (explaining.features.cols() == 0) continue;
    Profile profile{by, std::vector<std::vector<double>>(static_cast<std::size_t>(explained.targets.cols()))};
    for (std::int64_t shift = shifts.from; shift <= shifts.to; shift += kRowStride) {
      const BlockedRegression regression = regress(pair, by, shift);
      for (std::size_t t = 0; t < profile.unexplained.size(); ++t)
        profile.unexplained[t].push_back(unexplained(regression, static_cast<Eigen::Index>(t)));
    }
    profiles.push_back(std::move(profile));
  }
  Found found;
  const std::vector<double>* of_best = nullptr;
  for (const Profile& profile : profiles)
    for (std::size_t t = 0; t < profile.unexplained.size(); ++t)
      for (std::size_t k = 0; k < profile.unexplained[t].size(); ++k) {
        if (!(profile.unexplained[t][k] < found.best.unexplained)) continue;
        found.best = {profile.by, static_cast<Eigen::Index>(t), shifts.from + kRowStride * static_cast<std::int64_t>(k),
                      profile.unexplained[t][k]};
        of_best = &profile.unexplained[t];
      }
  for (std::size_t k = 1; of_best && k + 1 < of_best->size(); ++k) {
    const std::vector<double>& profile = *of_best;
    if (profile[k] <= profile[k - 1] && profile[k] <= profile[k + 1])
      found.others.push_back(shifts.from + kRowStride * static_cast<std::int64_t>(k));
  }
  return found;
}

/// Whether the errors of stretches grow from the best offset to another, by more than they scatter.
bool is_distinct(const SampledPair& pair, const Best& best, std::int64_t other) {
  const std::vector<double> here = regress(pair, best.by, best.shift).errors(best.target);
  const std::vector<double> there = regress(pair, best.by, other).errors(best.target);
  std::vector<double> costs;
  for (std::size_t b = 0; b < kBlocks; ++b)
    if (here[b] > 0.0 && there[b] > 0.0) costs.push_back(std::log(there[b] / here[b]));
  if (costs.size() < 3) return false;
  const auto count = static_cast<double>(costs.size());
  const Eigen::Map<const Eigen::ArrayXd> c(costs.data(), static_cast<Eigen::Index>(costs.size()));
  const double error = std::sqrt((c - c.mean()).square().sum() / (count * (count - 1.0)));
  return c.mean() > kDistinct * error;
}

/// The lowest point of a parabola through the least of evenly spaced values and its neighbours, in steps; none at an
/// end.
std::optional<double> lowest(const std::vector<double>& values) {
  std::size_t least = values.size();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]) && (least == values.size() || values[i] < values[least])) least = i;
  if (least == 0 || least + 1 >= values.size()) return std::nullopt;
  const double before = values[least - 1], after = values[least + 1];
  const double bend = before + after - 2.0 * values[least];
  if (!(bend > 0.0)) return std::nullopt;
  return static_cast<double>(least) + 0.5 * (before - after) / bend;
}

struct StraightLine {
  double at_zero = 0.0, slope = 0.0, at_zero_error = 0.0, slope_error = 0.0;
};

StraightLine line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::ArrayXd> xs(x.data(), n), ys(y.data(), n);
  const double mean = xs.mean(), spread = (xs - mean).square().sum();
  StraightLine line;
  line.slope = ((xs - mean) * ys).sum() / spread;
  line.at_zero = ys.mean() - line.slope * mean;
  const double variance = (ys - line.at_zero - line.slope * xs).square().sum() / static_cast<double>(n - 2);
  line.slope_error = std::sqrt(variance / spread);
  line.at_zero_error = std::sqrt(variance * (1.0 / static_cast<double>(n) + mean * mean / spread));
  return line;
}

/// Offsets near one by windows of one reach, with what each stretch alone would say.
struct Fine {
  double offset = 0.0, error = 0.0;
  std::vector<double> middles, offsets;  ///< by stretch: s since the second's begin, s
};

std::optional<Fine> refine(const Signals& first, const Signals& second, const Best& best, double near, double reach) {
  const double step = reach / static_cast<double>(2 * kReach);
  const SampledPair pair = sample_pair(first, second, step);
  const auto middle = static_cast<std::int64_t>(std::llround((near - pair.base) / step));
  const auto wide = static_cast<std::int64_t>(std::ceil(kAround * reach / step));
  std::vector<double> whole;
  std::vector<std::vector<double>> without(kBlocks), alone(kBlocks);
  for (std::int64_t shift = middle - wide; shift <= middle + wide; ++shift) {
    const BlockedRegression regression = regress(pair, best.by, shift);
    whole.push_back(unexplained(regression, best.target));
    for (std::size_t b = 0; b < kBlocks; ++b) {
      without[b].push_back(regression.unexplained_without(b, best.target));
      alone[b].push_back(regression.unexplained_in(b, best.target));
    }
  }
  const auto offset = [&](double at) { return pair.offset(middle - wide) + at * step; };
  const std::optional<double> found = lowest(whole);
  if (!found) return std::nullopt;
  Fine fine{offset(*found), 0.0, {}, {}};
  std::vector<double> left_out;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    const auto share = (static_cast<double>(b) + 0.5) / static_cast<double>(kBlocks);
    if (const auto one = lowest(without[b])) left_out.push_back(offset(*one));
    const auto one = lowest(alone[b]);
    if (!one) continue;
    const double time = pair.first.lattice.start + share * static_cast<double>(pair.first.lattice.count) * step;
    fine.middles.push_back(time - fine.offset - begin_of(second));
    fine.offsets.push_back(offset(*one));
  }
  if (left_out.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(left_out.size());
  const Eigen::Map<const Eigen::ArrayXd> values(left_out.data(), static_cast<Eigen::Index>(left_out.size()));
  fine.error = std::sqrt((n - 1.0) / n * (values - values.mean()).square().sum());
  return fine;
}

Signals skewed(Signals signals, double skew) {
  const double begin = begin_of(signals);
  for (ClockedSignal& one : signals)
    for (double& time : one.times) time += skew * (time - begin);
  return signals;
}

std::string name_of(const Signals& first, const Signals& second, const Best& best) {
  const Signals& explained = best.by == By::second ? first : second;
  return explained[static_cast<std::size_t>(best.target)].name;
}

using Answer = std::variant<ClockAlignment, std::string>;

/// By clocks of one speed; puts down in `fine` what each stretch says.
Answer align(const Signals& first, const Signals& second, const std::pair<double, double>& between, Fine& fine) {
  const double longer = std::max(end_of(first) - begin_of(first), end_of(second) - begin_of(second));
  const double interval = std::max(slowest_interval(first), slowest_interval(second));
  const double coarse = std::max(kFewestIntervals * interval, longer / kCoarsest);
  const SampledPair pair = sample_pair(first, second, coarse / static_cast<double>(2 * kReach));
  const Shifts shifts = shifts_within(pair, between);
  if (shifts.from > shifts.to) return "no offset within `between` lets half of the shorter file overlap";
  const Found found = scan_offsets(pair, shifts);
  if (!(found.best.unexplained < kMostUnexplained))
    return std::string(
        "whatever the offset, the readings of one file explain less than half of each signal of the other");
  for (const std::int64_t other : found.others)
    if (std::abs(other - found.best.shift) > 4 * kRowStride && !is_distinct(pair, found.best, other))
      return fmt::format("offsets of {:.4g} s and {:.4g} s explain `{}` equally well, as with a periodic motion",
                         pair.offset(found.best.shift), pair.offset(other), name_of(first, second, found.best));
  std::optional<Fine> best;
  double near = pair.offset(found.best.shift);
  for (double reach = coarse; reach >= kFewestIntervals * interval && longer < kMostWindows * reach; reach *= 0.5) {
    const std::optional<Fine> one = refine(first, second, found.best, near, reach);
    if (!one) continue;
    near = one->offset;
    if (!best || one->error < best->error) best = one;
  }
  if (!best) return std::string("the best offset lies at the end of the range in which it was looked for");
  fine = *best;
  return ClockAlignment{fine.offset, fine.error, 0.0, 0.0, name_of(first, second, found.best)};
}

}  // namespace

Answer align_clocks(const Signals& first, const Signals& second, const AlignmentTask& task) {
  if (first.empty() || second.empty()) return std::string("each file must have a signal of the experiment");
  double skew = task.skew;
  for (int round = 0;; ++round) {
    Fine fine;
    Answer answer = align(first, skewed(second, skew), task.between, fine);
    ClockAlignment* alignment = std::get_if<ClockAlignment>(&answer);
    if (!alignment) return answer;
    alignment->skew = skew;
    if (!task.finds_skew) return answer;
    if (fine.offsets.size() < 4) return std::string("too few stretches of time show an offset, so no skew is found");
    const StraightLine line = line_through(fine.middles, fine.offsets);
    skew += line.slope;
    alignment->offset = line.at_zero;
    alignment->offset_error = line.at_zero_error;
    alignment->skew = skew;
    alignment->skew_error = line.slope_error;
    if (round + 1 == kSkewRounds || std::abs(line.slope) < line.slope_error) return answer;
  }
}

}  // namespace lacuna
