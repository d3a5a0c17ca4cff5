#include "documents/unfinished_search_json.h"

#include "documents/search_state_json.h"
#include "foundation/json_depth.h"

#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

constexpr int kFitsFormat = 1;  ///< to be counted up when the fits, or the search that follows from them, change

ordered_json fit_json(const KeptFit& fit) {
  ordered_json states = ordered_json::array();
  for (const Eigen::VectorXd& state : fit.states) states.push_back(std::vector<double>(state.begin(), state.end()));
  return {{"rough", fit.rough}, {"values", fit.values}, {"states", states}};
}

KeptFit read_fit(const ordered_json& json) {
  KeptFit fit{json.at("rough"), json.at("values"), {}};
  for (const ordered_json& one : json.at("states")) {
    const auto state = one.get<std::vector<double>>();
    fit.states.push_back(Eigen::Map<const Eigen::VectorXd>(state.data(), static_cast<Eigen::Index>(state.size())));
  }
  return fit;
}

}  // namespace

std::string unfinished_search_json(const UnfinishedSearch& search) {
  ordered_json fits = ordered_json::object();
  for (const auto& [name, fit] : search.fits) fits[name] = fit_json(fit);
  const ordered_json whole = {
      {"format", kFitsFormat},
      {"fits", fits},
      {"likelihoods",
       search.likelihoods ? ordered_json::parse(search_state_json(*search.likelihoods)) : ordered_json()}};
  return whole.dump();
}

std::optional<UnfinishedSearch> read_unfinished_search(const std::string& document) {
  if (nests_too_deep(document)) return std::nullopt;
  try {
    const ordered_json whole = ordered_json::parse(document);
    if (whole.value("format", 0) != kFitsFormat || !whole.contains("fits")) return std::nullopt;
    UnfinishedSearch search;
    for (const auto& [name, fit] : whole.at("fits").items()) search.fits[name] = read_fit(fit);
    if (!whole.at("likelihoods").is_null()) search.likelihoods = read_search_state(whole.at("likelihoods").dump());
    return search;
  } catch (const nlohmann::json::exception&) {  // a figure that JSON does not have, such as NaN: begin anew
  }
  return std::nullopt;
}

}  // namespace lacuna
