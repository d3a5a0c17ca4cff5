#include "search/look.h"

#include <lacuna/error.h>

#include "diagnosis/candidates/data_scales.h"
#include "foundation/interrupt.h"
#include "foundation/parallel.h"
#include "search/slots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace lacuna {
namespace {

constexpr std::size_t kRungsForProbes = 3;
constexpr std::size_t kForSizes = 2;   ///< segments of a rung by which sizes are found
constexpr double kWorthAPair = 0.02;   ///< nats beyond the better of two effects
constexpr std::size_t kForPairs = 60;  ///< effects of which pairs are looked at
constexpr WantedChange kWantedOfProbe = {0.2, 0.6, true};
constexpr double kFarthest = 20.0;  ///< times its probe's size that an effect may be promised at

/// What is simulated of each hypothesis.
struct Stage {
  const Ground& ground;
  Contender model;                      ///< settled on the ladder
  Ladder ladder;                        ///< thinned
  std::vector<std::size_t> for_sizes;   ///< segments of it
  std::vector<Eigen::VectorXd> scales;  ///< by segment and row: what the model leaves, channel units
  HorizonFit fit;                       ///< on the thinned ladder
};

/// By segment and row, the root of what the model leaves in its rung and channel, at least the floor's.
std::vector<Eigen::VectorXd> scales_of(const Ladder& ladder, const std::vector<Trial>& trials,
                                       const HorizonErrors& errors) {
  std::vector<Eigen::VectorXd> scales;
  for (std::size_t r = 0; r < ladder.rungs.size(); ++r)
    for (const Segment& segment : ladder.rungs[r].segments) {
      Eigen::VectorXd rows(static_cast<Eigen::Index>(segment.rows.size()));
      for (std::size_t i = 0; i < segment.rows.size(); ++i) {
        const std::size_t c = channel_index(ladder, trials[segment.stretch.trial], segment.columns[i]);
        const bool counts = errors.weight[r][c] > 0.0;
        rows(static_cast<Eigen::Index>(i)) =
            counts ? std::sqrt(std::max(errors.mean_square[r][c], ladder.rungs[r].floor[c]))
                   : std::numeric_limits<double>::infinity();
      }
      scales.push_back(rows);
    }
  return scales;
}

std::vector<std::size_t> segments_for_sizes(const Ladder& ladder) {
  std::vector<std::size_t> chosen;
  std::size_t first = 0;
  for (const Rung& rung : ladder.rungs) {
    const std::size_t count = std::min(kForSizes, rung.segments.size());
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(first + (2 * i + 1) * rung.segments.size() / (2 * count));
    first += rung.segments.size();
  }
  return chosen;
}

/// A hypothesis on its desk.
class Probed {
 public:
  Probed(const Stage& stage, const Hypothesis& hypothesis, const std::vector<std::size_t>& segments)
      : stage_(stage),
        hypothesis_(hypothesis),
        segments_(segments),
        bench_(hypothesis.definition, *hypothesis.model, stage.ground.task().trials, stage.ground.timing(), 1),
        problem_(bench_.predictor(), bench_.space(), chosen(), stage.ladder.channels) {}

  std::vector<double> values(const std::vector<double>& own) const {
    std::vector<double> of_base = stage_.model.values;
    std::vector<double> all = hypothesis_.values(of_base, own);
    if (stage_.ground.timing()) all.push_back(of_base.back());
    return all;
  }
  bool residuals(const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals) {
    if (!problem_.residuals({bench_.space().to_coordinates(values(own)), states_}, residuals)) return false;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const auto rows = static_cast<Eigen::Index>(problem_.segments()[i].rows.size());
      residuals[i].conservativeResize(rows);
      for (Eigen::Index row = 0; row < rows; ++row)
        residuals[i](row) *= problem_.scales()[problem_.place(i, row).channel];
    }
    return true;
  }
  /// Why the last simulation that failed did; empty: none did.
  const std::string& failure() const { return problem_.last_reason(); }
  /// The same over what the model leaves.
  bool relative(const std::vector<double>& own, std::vector<Eigen::VectorXd>& rows) {
    if (!residuals(own, rows)) return false;
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].array() /= stage_.scales[segments_[i]].array();
    return true;
  }

 private:
  std::vector<Segment> chosen() {
    const std::vector<Segment> all = all_segments(stage_.ladder);
    std::vector<Segment> kept;
    for (const std::size_t k : segments_) {
      kept.push_back(all[k]);
      states_.push_back(stage_.fit.states[k]);
    }
    return kept;
  }

  const Stage& stage_;
  const Hypothesis& hypothesis_;
  std::vector<std::size_t> segments_;
  std::vector<Eigen::VectorXd> states_;
  ModelBench bench_;
  ShootingProblem problem_;
};

std::string name_of(const Hypothesis& hypothesis) { return hypothesis.entry.effect + " @ " + hypothesis.where(); }

/// A probe with what it adds to predictions; empty: it cannot be simulated.
struct TriedProbe {
  SizedProbe sized;
  std::vector<Eigen::VectorXd> response;
};

/// Fills the responses of a hypothesis's probes on a stage; those that cannot be simulated are left out, and `failure`
/// says why the last one is.
void respond(const Stage& stage, const Hypothesis& hypothesis, std::vector<TriedProbe>& probes, std::string& failure) {
  if (probes.empty()) return;
  std::vector<std::size_t> all(stage.scales.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Probed whole(stage, hypothesis, all);
  std::vector<Eigen::VectorXd> calm, moved;
  const bool valid = whole.residuals(hypothesis.neutral, calm);
  for (TriedProbe& probe : probes) {
    probe.response.clear();
    if (!valid || !whole.residuals(probe.sized.own, moved)) continue;
    for (std::size_t k = 0; k < calm.size(); ++k) probe.response.emplace_back(calm[k] - moved[k]);
  }
  std::erase_if(probes, [](const TriedProbe& probe) { return probe.response.empty(); });
  if (!whole.failure().empty()) failure = whole.failure();
}

/// The least cost with a probe of any size beside the model.
LinearFit promise_of(const TriedProbe& probe, LinearLadder& linear, std::size_t& change) {
  const double most = probe.sized.sized ? kFarthest : 1.0;
  change = linear.add(probe.response, probe.sized.one_sided ? 0.0 : -most, most);
  return linear.best({&change, 1});
}

/// A model on a thinned ladder, settled there.
Stage stage_of(const Ground& ground, const ModelBench& bench, const Contender& model, const Ladder& ladder) {
  Stage stage{ground, model, ladder, segments_for_sizes(ladder), {}, {}};
  stage.fit = fit_to_ladder(ladder, bench.predictor(), bench.space(), model.values, Climb::whole);
  if (!stage.fit.errors.valid) throw Error("the model cannot be simulated from the starts that the data tell");
  stage.model.values = stage.fit.values;
  stage.scales = scales_of(ladder, bench.predictor().trials(), stage.fit.errors);
  return stage;
}

/// Whether one value of the effect alone is not neutral.
bool is_plain(const Hypothesis& hypothesis, const SizedProbe& sized) {
  std::size_t moved = 0;
  for (std::size_t i = 0; i < sized.own.size(); ++i) moved += sized.own[i] != hypothesis.neutral[i] ? 1U : 0U;
  return sized.sized && moved == 1;
}

/// Of a hypothesis's probes the one that promises most, and the plain one that does, where that is another.
std::vector<TriedProbe> most_promising(const Hypothesis& hypothesis, std::vector<TriedProbe>& probes,
                                       LinearLadder& linear) {
  std::optional<std::size_t> best, plain;
  std::vector<double> costs;
  std::size_t change = 0;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    costs.push_back(promise_of(probes[i], linear, change).cost);
    if (!best || costs[i] < costs[*best]) best = i;
    if (is_plain(hypothesis, probes[i].sized) && (!plain || costs[i] < costs[*plain])) plain = i;
  }
  std::vector<TriedProbe> kept;
  if (best) kept.push_back(probes[*best]);
  if (plain && plain != best) kept.push_back(probes[*plain]);
  return kept;
}

/// A probe or two a hypothesis: those that promise most over the shorter rungs. `failures`: by hypothesis, why its last
/// simulation that failed did.
std::vector<std::vector<TriedProbe>> best_probes(const Stage& stage, const ModelBench& bench,
                                                 const std::vector<Hypothesis>& hypotheses,
                                                 std::vector<std::string>& failures) {
  const Ground& ground = stage.ground;
  const std::map<std::string, double> scales = data_scales(ground.task().trials);
  LinearLadder linear = linearise(stage.ladder, bench.predictor(), bench.space(), stage.fit, ground.block());
  std::vector<std::vector<TriedProbe>> probes(hypotheses.size());
  parallel_for(probes.size(), ground.task().threads, [&](std::size_t h, int) {
    throw_if_interrupted();
    Probed few(stage, hypotheses[h], stage.for_sizes);
    const OwnResiduals simulate = [&](const std::vector<double>& own, std::vector<Eigen::VectorXd>& rows) {
      return few.relative(own, rows);
    };
    for (SizedProbe& sized : size_probes(hypotheses[h], simulate, kWantedOfProbe, scales))
      probes[h].push_back({std::move(sized), {}});
    failures[h] = few.failure();
    respond(stage, hypotheses[h], probes[h], failures[h]);
  });
  for (std::size_t h = 0; h < probes.size(); ++h) probes[h] = most_promising(hypotheses[h], probes[h], linear);
  return probes;
}

/// The effect's own values where its probe is so many times as large.
std::vector<double> own_at(const Hypothesis& hypothesis, const SizedProbe& sized, double size) {
  std::vector<double> own = sized.own;
  if (!sized.sized) return own;
  const std::size_t i = *sized.sized;
  const FreeValue& free = hypothesis.definition.free[hypothesis.own[i]];
  own[i] = std::clamp(hypothesis.neutral[i] + size * (sized.own[i] - hypothesis.neutral[i]), free.lower, free.upper);
  return own;
}

/// A hypothesis with its change in the linear ladder.
struct Single {
  std::size_t hypothesis, change;
  double cost;
  SizedProbe sized;
};

/// Pairs by what they promise beyond the better of the two, at most one with the same two names of effects.
std::vector<PairPromise> promised_pairs(const Stage& stage, const std::vector<Hypothesis>& hypotheses,
                                        const std::vector<Single>& singles, const LinearLadder& linear,
                                        std::size_t most) {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t i = 0; i < singles.size(); ++i)
    for (std::size_t j = i + 1; j < singles.size(); ++j)
      if (singles[i].hypothesis != singles[j].hypothesis) all.emplace_back(i, j);
  std::vector<LinearFit> fits(all.size());
  parallel_for(all.size(), stage.ground.task().threads, [&](std::size_t p, int) {
    const std::array<std::size_t, 2> changes{singles[all[p].first].change, singles[all[p].second].change};
    fits[p] = linear.best(changes);
  });
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return fits[a].cost < fits[b].cost; });
  std::vector<PairPromise> pairs;
  std::set<std::size_t> used;
  for (const std::size_t p : order) {
    if (pairs.size() == most) break;
    const Single &one = singles[all[p].first], &other = singles[all[p].second];
    const double better = std::min(one.cost, other.cost);
    if (better - fits[p].cost < kWorthAPair) continue;
    // What one effect promises with anything is no pair: it stands in one pair only.
    const std::size_t leader = one.cost < other.cost ? one.hypothesis : other.hypothesis;
    if (!used.insert(leader).second) continue;
    const Eigen::Index own = fits[p].sizes.size() - 2;
    PairPromise promise{one.hypothesis, other.hypothesis, fits[p].cost, stage.model.values, {}, {}};
    promise.of_one = own_at(hypotheses[one.hypothesis], one.sized, fits[p].sizes(own));
    promise.of_other = own_at(hypotheses[other.hypothesis], other.sized, fits[p].sizes(own + 1));
    pairs.push_back(std::move(promise));
  }
  return pairs;
}

}  // namespace

Look look_beside(const Ground& ground, const Contender& model, const HorizonFit& fit, const KnownProbes* known,
                 std::size_t pairs) {
  Look look;
  const MissingTask& task = ground.task();
  look.hypotheses = list_hypotheses(model.experiment, task.catalog, model.definition, task.among, look.untestable);
  const ModelBench bench = ground.bench_for(model);
  Contender here = model;
  here.values = fit.values;
  const Ladder ladder = quick(ground.ladder_for(bench));
  const Stage stage = stage_of(ground, bench, here, ladder);
  LinearLadder linear = linearise(ladder, bench.predictor(), bench.space(), stage.fit, ground.block());
  look.cost = linear.best({}).cost;
  std::vector<std::vector<TriedProbe>> probes(look.hypotheses.size());
  std::vector<std::string> failures(look.hypotheses.size());
  if (known) {
    for (std::size_t h = 0; h < probes.size(); ++h)
      if (const auto found = known->find(name_of(look.hypotheses[h])); found != known->end())
        for (const SizedProbe& sized : found->second) probes[h].push_back({sized, {}});
  } else {
    const Ladder shorter = first_rungs(ladder, std::min(kRungsForProbes, ladder.rungs.size()));
    probes = best_probes(stage_of(ground, bench, stage.model, shorter), bench, look.hypotheses, failures);
  }
  parallel_for(probes.size(), task.threads, [&](std::size_t h, int) {
    throw_if_interrupted();
    respond(stage, look.hypotheses[h], probes[h], failures[h]);
  });
  std::vector<Single> singles;
  for (std::size_t h = 0; h < probes.size(); ++h) {
    std::optional<Promise> best;
    for (const TriedProbe& probe : probes[h]) {
      std::size_t change = 0;
      const LinearFit found = promise_of(probe, linear, change);
      const Probed probed(stage, look.hypotheses[h], {});
      const double size = found.sizes(found.sizes.size() - 1);
      const std::vector<double> values = probed.values(own_at(look.hypotheses[h], probe.sized, size));
      look.probes[name_of(look.hypotheses[h])].push_back(probe.sized);
      singles.push_back({h, change, found.cost, probe.sized});
      const bool leads = !best || found.cost < best->cost;
      std::optional<std::vector<double>> plainly = best ? best->plainly : std::nullopt;
      if (is_plain(look.hypotheses[h], probe.sized)) plainly = values;
      if (leads)
        best = Promise{h, found.cost, values, plainly};
      else
        best->plainly = plainly;
    }
    if (!best) {
      look.untestable.push_back(without_probes(look.hypotheses[h], failures[h]));
      continue;
    }
    look.promises.push_back(*best);
  }
  std::stable_sort(look.promises.begin(), look.promises.end(),
                   [](const Promise& a, const Promise& b) { return a.cost < b.cost; });
  if (pairs > 0) {
    const std::vector<std::size_t> of = not_redundant(look, kForPairs);
    const std::set<std::size_t> kept(of.begin(), of.end());
    std::erase_if(singles, [&](const Single& single) { return !kept.contains(single.hypothesis); });
    look.pairs = promised_pairs(stage, look.hypotheses, singles, linear, pairs);
  }
  return look;
}

}  // namespace lacuna
