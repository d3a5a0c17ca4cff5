#include "oracle/oracle.h"

#include "oracle/stand.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hidden_effects {
namespace {

using Index = Eigen::Index;

/// The truth in words of the library: laws of another form replaced one by one by what fits best of the same name.
Explanation representative(const TrueData& data) {
  Explanation at = data.truth();
  for (std::size_t l = 0; l < at.model.laws.size();) {
    if (at.model.laws[l].kind->library_form) {
      ++l;
      continue;
    }
    const PlacedLaw form = library_form(at.model.laws[l]);
    auto best = Stand(data, at, l).best(form);
    if (!best) throw std::runtime_error("the oracle cannot fit " + form.kind->name);
    at = std::move(*best);
  }
  return at;
}

/// Of the base alone, refitted with the timing of commands.
double base_non_centrality(const MadeCase& made, const TrueData& data) {
  Explanation base = data.truth();
  const FreeValue timing = base.model.free.back();
  base.model = made.base;
  base.model.free.push_back(timing);
  base.values.resize(made.base_values.size() + 1);
  base.values << made.base_values, 0.0;
  const auto fitted = data.refitted(base, kToldApart, 0.0);
  return fitted ? fitted->deviance : std::numeric_limits<double>::infinity();
}

std::vector<std::string> names_of(const PlantModel& model) {
  std::vector<std::string> names;
  for (const FreeValue& value : model.free) names.push_back(value.address);
  for (const PlacedLaw& law : model.laws)
    for (const std::string& parameter : law.kind->parameters) names.push_back(law.kind->effect + "." + parameter);
  return names;
}

/// Parameters of which the data say nothing have no bounds, and do not count for the others.
std::vector<Width> widths_of(const Explanation& at, const Eigen::MatrixXd& information) {
  constexpr double kQuantile = 1.959964, kNoInformation = 1e-20;
  const std::vector<std::string> names = names_of(at.model);
  std::vector<Index> told;
  for (Index i = 0; i < information.rows(); ++i)
    if (information(i, i) > kNoInformation) told.push_back(i);
  const Eigen::MatrixXd of_told = information(told, told);
  const Eigen::VectorXd scale = of_told.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd covariance = (scale.asDiagonal() * of_told * scale.asDiagonal())
                                         .ldlt()
                                         .solve(Eigen::MatrixXd::Identity(of_told.rows(), of_told.cols()));
  std::vector<Width> widths;
  for (std::size_t i = 0; i < names.size(); ++i)
    widths.push_back({names[i], at.values[static_cast<Index>(i)], std::numeric_limits<double>::infinity()});
  for (std::size_t k = 0; k < told.size(); ++k) {
    const auto row = static_cast<Index>(k);
    if (covariance(row, row) > 0.0)
      widths[static_cast<std::size_t>(told[k])].width = 2.0 * kQuantile * scale[row] * std::sqrt(covariance(row, row));
  }
  std::erase_if(widths, [](const Width& one) { return one.parameter == kTiming; });
  return widths;
}

bool wanted(const PlacedLaw& law, const std::vector<std::string>& among) {
  return among.empty() || std::find(among.begin(), among.end(), law.kind->effect) != among.end();
}

/// The library's law of bristles has a lubricating film, too, which the plant's leaves out (Canudas de Wit et al.
/// 1995): it explains whatever viscous friction of the same joint explains.
void give_bristles_a_film(std::vector<Rival>& rivals, const std::vector<Rival>& viscous) {
  for (Rival& rival : rivals) {
    if (rival.law.kind->effect != "lugre_friction") continue;
    for (const Rival& film : viscous)
      if (film.law.element == rival.law.element && film.non_centrality < rival.non_centrality)
        rival = {rival.law, film.non_centrality, film.refined, film.told_apart};
  }
}

/// Viscous friction among the rivals, and in the place of the hidden law.
std::vector<Rival> viscous_among(const std::vector<Rival>& rivals, const Explanation& at, std::size_t hidden) {
  std::vector<Rival> viscous;
  const auto is_viscous = [](const PlacedLaw& law) { return law.kind->effect == "viscous_friction"; };
  for (const Rival& rival : rivals)
    if (is_viscous(rival.law)) viscous.push_back(rival);
  if (is_viscous(at.model.laws[hidden])) viscous.push_back({at.model.laws[hidden], at.deviance, true, false});
  return viscous;
}

/// All laws of the library in the place of that which was taken out; those that the model has already stay out.
std::vector<Rival> rivals_at(const Stand& stand, const TrueData& data, const Explanation& at, std::size_t hidden) {
  std::vector<Rival> rivals;
  for (const PlacedLaw& rival : library_laws(at.model.spec)) {
    const auto& laws = at.model.laws;
    if (!wanted(rival, data.options().among)) continue;
    if (std::any_of(laws.begin(), laws.end(), [&](const PlacedLaw& one) { return one == rival; })) continue;
    rivals.push_back(stand.judge(rival, at.deviance));
  }
  give_bristles_a_film(rivals, viscous_among(rivals, at, hidden));
  std::stable_sort(rivals.begin(), rivals.end(),
                   [](const Rival& a, const Rival& b) { return a.non_centrality < b.non_centrality; });
  return rivals;
}

/// Which of the representative's laws is the hidden one; those that took the place of another form stand last.
std::size_t place_of(const PlacedLaw& hidden, const std::vector<PlacedLaw>& laws) {
  const auto found = std::find_if(laws.begin(), laws.end(),
                                  [&](const PlacedLaw& one) { return one == hidden || one == library_form(hidden); });
  return static_cast<std::size_t>(found - laws.begin());
}

Absence absence_at(const Stand& stand, const TrueData& data, const Explanation& at) {
  const double told = at.deviance + kToldApart;
  const auto patiently = stand.without() ? data.refitted(*stand.without(), told, 0.0) : std::nullopt;
  const double left = patiently ? patiently->deviance : std::numeric_limits<double>::infinity();
  return {left, left >= told};
}

}  // namespace

std::vector<PlacedLaw> OracleAnswer::alike(std::size_t hidden) const {
  std::vector<PlacedLaw> members;
  for (const Rival& rival : rivals[hidden])
    if (!rival.told_apart) members.push_back(rival.law);
  return members;
}

OracleAnswer ask_oracle(const MadeCase& made, const OracleOptions& options) {
  const TrueData data(made, options);
  OracleAnswer answer;
  const Explanation at = representative(data);
  answer.representative = at.model.laws;
  answer.non_centrality = at.deviance;
  answer.widths = widths_of(at, Nuisances(data.question(at)).information());
  if (made.truth.laws.empty()) return answer;
  answer.base_non_centrality = base_non_centrality(made, data);
  answer.detectable = answer.base_non_centrality >= kToldApart;
  for (const PlacedLaw& hidden : made.truth.laws) {
    const std::size_t place = place_of(hidden, at.model.laws);
    const Stand stand(data, at, place);
    answer.absences.push_back(at.model.laws.size() == 1 ? Absence{answer.base_non_centrality, answer.detectable}
                                                        : absence_at(stand, data, at));
    answer.rivals.push_back(rivals_at(stand, data, at, place));
  }
  return answer;
}

}  // namespace hidden_effects
