#include "documents/kept_fits_json.h"

#include "foundation/text/json_depth.h"

#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using nlohmann::json;

constexpr int kFormat = 2;  ///< to be counted up when the fits, or the search that follows from them, change

KeptFit fit_of(const json& document) {
  KeptFit fit{document.at("values").get<NamedValues>(), {}};
  for (const json& one : document.at("starts")) {
    const auto start = one.get<std::vector<double>>();
    fit.starts.push_back(Eigen::Map<const Eigen::VectorXd>(start.data(), static_cast<Eigen::Index>(start.size())));
  }
  return fit;
}

}  // namespace

std::string kept_fits_json(const KeptFits& fits) {
  json all = json::object();
  for (const auto& [name, fit] : fits) {
    json starts = json::array();
    for (const Eigen::VectorXd& start : fit.starts) starts.push_back(std::vector<double>(start.begin(), start.end()));
    all[name] = {{"values", fit.values}, {"starts", starts}};
  }
  return json{{"format", kFormat}, {"fits", all}}.dump();
}

std::optional<KeptFits> read_kept_fits(const std::string& document) {
  if (nests_too_deep(document)) return std::nullopt;
  try {
    const json whole = json::parse(document);
    if (whole.value("format", 0) != kFormat || !whole.contains("fits")) return std::nullopt;
    KeptFits fits;
    for (const auto& [name, fit] : whole.at("fits").items()) fits[name] = fit_of(fit);
    return fits;
  } catch (const json::exception&) {  // a figure that JSON does not have, such as NaN: begin anew
  }
  return std::nullopt;
}

}  // namespace lacuna
