#include "measurement/clocks/clock_alignment.h"

#include "measurement/clocks/alignment_samples.h"
#include "measurement/series/blocked_regression.h"
#include "measurement/clocks/clock_check.h"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kBlocks = 16;
constexpr std::size_t kReach = kAlignmentReach;
constexpr std::int64_t kRowStride = kReach;  ///< steps from row to row: half the reach of the smoothing
constexpr double kCoarsest = 750.0;          ///< windows in the longer recording in the first search
constexpr double kFewestWindows = 90.0;      ///< in the longer recording, of the longest windows that are tried
constexpr double kBetterLook = 0.7;          ///< of the unexplained share, by which a longer window is preferred
constexpr double kNearlyBest = 1.3;          ///< errors
constexpr double kAgree = 2.0;               ///< standard errors between offsets with different windows
constexpr double kLeastError = 0.005;        ///< of the slower device's interval: smallest error that is stated
constexpr double kFewestIntervals = 8;  ///< of the slower device within a window's reach, half of them in each half
constexpr double kAround = 2.0;         ///< reaches to either side that are searched again with a finer window
constexpr double kMostWindows = 2e4;    ///< in the longer recording: finer ones would take minutes
constexpr double kLeastOverlap = 0.5;   ///< of the shorter recording
constexpr double kLeastVariance = 0.1;  ///< of a target's variance: where a target hardly changes, nothing explains it
constexpr double kDistinct = 3.0;       ///< standard errors between the best offset and any other
constexpr double kMostUnexplained = 0.5;  ///< of a target, unexplained
constexpr double kApart = 8.0;            ///< parts of a step between the final offsets
constexpr int kSkewRounds = 3;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

using Signals = std::vector<ClockedSignal>;

double slowest_interval(const Signals& signals) {
  double slowest = 0.0;
  for (const ClockedSignal& one : signals) slowest = std::max(slowest, median_interval(one.times));
  return slowest;
}

/// Which side's readings explain the other side's signals.
enum class By { second, first };

/// Features and targets of one row; false where a value is missing.
bool join(const Eigen::MatrixXd& features, Eigen::Index feature, const Eigen::MatrixXd& targets, Eigen::Index target,
          Eigen::VectorXd& row) {
  double* to = row.data();
  *to++ = 1.0;
  for (Eigen::Index c = 0; c < features.cols(); ++c) *to++ = features.data()[c * features.rows() + feature];
  for (Eigen::Index c = 0; c < targets.cols(); ++c) *to++ = targets.data()[c * targets.rows() + target];
  return std::all_of(row.data(), to, [](double value) { return std::isfinite(value); });
}

/// Treatment of noise of the readings: it stays, which never explains too much, or it is removed (BlockedRegression).
enum class ReadingNoise { stays, taken_out };

/// Row i of the first belongs to row i − shift of the second.
BlockedRegression regress(const SampledPair& pair, By by, std::int64_t shift, ReadingNoise noise) {
  const Sampled& explaining = by == By::second ? pair.second : pair.first;
  const Eigen::MatrixXd& targets = by == By::second ? pair.first.targets : pair.second.targets;
  BlockedRegression regression(explaining.features.cols() + 1, targets.cols(), kBlocks);
  Eigen::VectorXd row(explaining.features.cols() + 1 + targets.cols()), again = row;
  const auto rows = static_cast<std::int64_t>(pair.first.lattice.count);
  const std::int64_t begin = std::max<std::int64_t>(0, shift);
  const auto end = std::min(rows, static_cast<std::int64_t>(pair.second.lattice.count) + shift);
  for (std::int64_t i = (begin + kRowStride - 1) / kRowStride * kRowStride; i < end; i += kRowStride) {
    const std::int64_t of_features = by == By::second ? i - shift : i, of_targets = by == By::second ? i : i - shift;
    if (!join(explaining.features, of_features, targets, of_targets, row) ||
        !join(explaining.again, of_features, targets, of_targets, again))
      continue;
    if (noise == ReadingNoise::stays) again = row = 0.5 * (row + again);
    regression.add(static_cast<std::size_t>(i) * kBlocks / static_cast<std::size_t>(rows), row, again);
  }
  return regression;
}

/// The unexplained share of a target; NaN where the target hardly varies in this overlap.
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

/// The shift at which some target is explained best, and all other local optima.
struct Found {
  Best best;
  std::vector<std::int64_t> others;
};

Found scan_offsets(const SampledPair& pair, const Shifts& shifts, const Stop& stop) {
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
      stop.throw_if_due();
      const BlockedRegression regression = regress(pair, by, shift, ReadingNoise::stays);
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

/// Whether the errors of the blocks grow from the best offset to another by more than they scatter.
bool is_distinct(const SampledPair& pair, const Best& best, std::int64_t other) {
  const std::vector<double> here = regress(pair, best.by, best.shift, ReadingNoise::stays).errors(best.target);
  const std::vector<double> there = regress(pair, best.by, other, ReadingNoise::stays).errors(best.target);
  std::vector<double> costs;
  for (std::size_t b = 0; b < std::min(here.size(), there.size()); ++b)
    if (const double both = std::abs(here[b]) + std::abs(there[b]); both > 0.0)
      costs.push_back((there[b] - here[b]) / both);
  if (costs.size() < 3) return false;
  const auto count = static_cast<double>(costs.size());
  const Eigen::Map<const Eigen::ArrayXd> c(costs.data(), static_cast<Eigen::Index>(costs.size()));
  const double error = std::sqrt((c - c.mean()).square().sum() / (count * (count - 1.0)));
  return c.mean() > kDistinct * error;
}

/// The minimum of a parabola through the smallest of evenly spaced values and its neighbours, in steps; none at an end.
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

/// Offsets near one with windows of one reach, and those of each block alone.
struct Fine {
  double offset = 0.0, error = 0.0;
  std::vector<double> middles, offsets;  ///< by block: s since the second's begin, s
};

/// The minimum from three close values, relative to the middle one; NaN where they are not convex.
double lowest_near(double before, double middle, double after, double apart) {
  const double bend = before + after - 2.0 * middle;
  return bend > 0.0 ? 0.5 * apart * (before - after) / bend : kUnknown;
}

/// The offset near one that is known to a step, and its error by a jackknife over blocks. The steps are too large for a
/// parabola, because the error is not symmetric around the offset.
Fine refine_between(const Signals& first, const Signals& second, const Best& best, double near, double step) {
  const double apart = step / kApart;
  std::vector<BlockedRegression> sides;
  for (const double way : {-1.0, 0.0, 1.0}) {
    const double at = near + way * apart;
    const SampledPair pair = sample_pair(first, second, step, at);
    sides.push_back(regress(pair, best.by, std::llround((at - pair.base) / step), ReadingNoise::taken_out));
  }
  const auto lowest_of = [&](const auto& share) {
    return near + lowest_near(share(sides[0]), share(sides[1]), share(sides[2]), apart);
  };
  Fine fine{lowest_of([&](const BlockedRegression& one) { return one.unexplained(best.target); }), kUnknown, {}, {}};
  std::vector<double> left_out;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    if (sides[1].rows(b) == 0.0) continue;
    const double one =
        lowest_of([&](const BlockedRegression& side) { return side.unexplained_without(b, best.target); });
    if (std::isfinite(one)) left_out.push_back(one);
  }
  if (left_out.size() < 3 || !std::isfinite(fine.offset)) return fine;
  const auto n = static_cast<double>(left_out.size());
  const Eigen::Map<const Eigen::ArrayXd> values(left_out.data(), static_cast<Eigen::Index>(left_out.size()));
  fine.error = std::sqrt((n - 1.0) / n * (values - values.mean()).square().sum());
  return fine;
}

/// `around`: s to either side of `near`, the search range.
std::optional<Fine> refine(const Signals& first, const Signals& second, const Best& best, double near, double around,
                           double reach, const Stop& stop) {
  const double step = reach / static_cast<double>(2 * kReach);
  const SampledPair pair = sample_pair(first, second, step);
  const auto middle = static_cast<std::int64_t>(std::llround((near - pair.base) / step));
  const auto wide = static_cast<std::int64_t>(std::ceil(std::min(around, kAround * reach) / step)) + 1;
  std::vector<double> whole;
  std::vector<std::vector<double>> alone(kBlocks);
  for (std::int64_t shift = middle - wide; shift <= middle + wide; ++shift) {
    stop.throw_if_due();
    const BlockedRegression regression = regress(pair, best.by, shift, ReadingNoise::taken_out);
    whole.push_back(unexplained(regression, best.target));
    for (std::size_t b = 0; b < kBlocks; ++b) alone[b].push_back(regression.unexplained_in(b, best.target));
  }
  const auto offset = [&](double at) { return pair.offset(middle - wide) + at * step; };
  const std::optional<double> found = lowest(whole);
  if (!found) return std::nullopt;
  Fine fine = refine_between(first, second, best, offset(*found), step);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    const auto share = (static_cast<double>(b) + 0.5) / static_cast<double>(kBlocks);
    const auto one = lowest(alone[b]);
    if (!one) continue;
    const double time = pair.first.lattice.start + share * static_cast<double>(pair.first.lattice.count) * step;
    fine.middles.push_back(time - fine.offset - begin_of(second));
    fine.offsets.push_back(offset(*one));
  }
  return std::isfinite(fine.error) ? std::optional(fine) : std::nullopt;
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

/// The offset with windows of one reach.
struct Look {
  double reach = 0.0;
  SampledPair pair;
  Found found;
};

/// The window must be short compared with the motion and long compared with the noise of readings, so several are
/// tried.
std::optional<Look> look_for_offset(const Signals& first, const Signals& second,
                                    const std::pair<double, double>& between, double shortest, double longest,
                                    const Stop& stop) {
  std::optional<Look> best;
  for (double reach = shortest; reach <= longest; reach *= 2.0) {
    Look look{reach, sample_pair(first, second, reach / static_cast<double>(2 * kReach)), {}};
    const Shifts shifts = shifts_within(look.pair, between);
    if (shifts.from > shifts.to) continue;
    look.found = scan_offsets(look.pair, shifts, stop);
    if (!best || look.found.best.unexplained < kBetterLook * best->found.best.unexplained) best = std::move(look);
  }
  return best;
}

/// Blocks that are long compared with the windows give separate offsets.
void take_stretches(const std::vector<Fine>& offsets, Fine& chosen) {
  for (const Fine& one : offsets) {
    if (one.offsets.size() <= chosen.offsets.size()) continue;
    chosen.middles = one.middles;
    chosen.offsets = one.offsets;
  }
}

/// Of offsets with shorter and shorter windows the first that is nearly as good as the best, because noise of readings
/// matters less in longer ones. Differences from the others beyond their errors count as its error.
std::optional<Fine> choose(const std::vector<Fine>& offsets) {
  double least = std::numeric_limits<double>::infinity();
  for (const Fine& one : offsets) least = std::min(least, one.error);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (offsets[i].error > kNearlyBest * least) continue;
    Fine chosen = offsets[i];
    for (std::size_t other = i > 0 ? i - 1 : 0; other <= i + 1 && other < offsets.size(); ++other) {
      const double apart = std::abs(offsets[other].offset - chosen.offset);
      if (apart > kAgree * std::hypot(offsets[other].error, offsets[i].error))
        chosen.error = std::max(chosen.error, std::min(0.5 * apart, offsets[other].error));
    }
    take_stretches(offsets, chosen);
    return chosen;
  }
  return std::nullopt;
}

/// With clocks of equal rate; writes the result of each block to `fine`.
Answer align(const Signals& first, const Signals& second, const std::pair<double, double>& between, const Stop& stop,
             Fine& fine) {
  const double longer = std::max(end_of(first) - begin_of(first), end_of(second) - begin_of(second));
  const double interval = std::max(slowest_interval(first), slowest_interval(second));
  const double coarse = std::max(kFewestIntervals * interval, longer / kCoarsest);
  double longest = coarse;
  while (2.0 * longest * kFewestWindows <= longer) longest *= 2.0;
  const std::optional<Look> look = look_for_offset(first, second, between, coarse, longest, stop);
  if (!look) return std::string("no offset within `between` makes the files overlap by half of the shorter one");
  const SampledPair& pair = look->pair;
  const Found& found = look->found;
  if (!(found.best.unexplained < kMostUnexplained))
    return std::string("at no offset do the readings of one file explain half of a signal of the other");
  for (const std::int64_t other : found.others) {
    stop.throw_if_due();
    if (std::abs(other - found.best.shift) > 4 * kRowStride && !is_distinct(pair, found.best, other))
      return fmt::format(
          "offsets of {:.4g} s and {:.4g} s explain `{}` equally well, so this motion does not determine the offset",
          pair.offset(found.best.shift), pair.offset(other), name_of(first, second, found.best));
  }
  std::vector<Fine> offsets;
  double near = pair.offset(found.best.shift), error_of_near = kInfinite;
  for (double reach = longest; reach >= kFewestIntervals * interval && longer < kMostWindows * reach; reach *= 0.5) {
    const std::optional<Fine> one = refine(first, second, found.best, near, kAround * look->reach, reach, stop);
    if (!one || one->offset < between.first || one->offset > between.second) continue;
    offsets.push_back(*one);
    if (one->error > error_of_near) continue;
    near = one->offset;
    error_of_near = one->error;
  }
  const std::optional<Fine> best = choose(offsets);
  if (!best) return std::string("the best offset lies at the end of the search range");
  fine = *best;
  fine.error = std::max(fine.error, kLeastError * interval);
  return ClockAlignment{fine.offset, fine.error, 0.0, 0.0, name_of(first, second, found.best)};
}

}  // namespace

Answer align_clocks(const Signals& first, const Signals& second, const AlignmentTask& task) {
  if (first.empty() || second.empty()) return std::string("each file must have a signal of the experiment");
  double skew = task.skew;
  for (int round = 0;; ++round) {
    Fine fine;
    Answer answer = align(first, skewed(second, skew), task.between, task.stop, fine);
    ClockAlignment* alignment = std::get_if<ClockAlignment>(&answer);
    if (!alignment && round > 0)
      return std::string("these files do not determine the skew: leave skew out, or write its number");
    if (!alignment) return answer;
    alignment->skew = skew;
    if (!task.finds_skew) return answer;
    if (fine.offsets.size() < 4)
      return std::string(
          "too few parts of the recording determine an offset, so the skew is unknown: leave skew out, or write its "
          "number");
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
