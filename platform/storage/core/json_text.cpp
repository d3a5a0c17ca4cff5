#include "storage/core/json_text.h"

#include "foundation/text/json_depth.h"
#include "storage/core/records.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

/// Of a database, which others may have written.
nlohmann::json parsed_list(const std::string& json) try {
  return nlohmann::json::parse(shallow_json(json));
} catch (const nlohmann::json::exception& wrong) {
  throw Error(fmt::format("a stored list cannot be read ({}); restore a backup of the database", wrong.what()));
}

double number_or_unknown(const nlohmann::json& value) { return value.is_number() ? value.get<double>() : kNotKnown; }

}  // namespace

std::string sentences_text(const std::vector<std::string>& sentences) { return nlohmann::json(sentences).dump(); }

std::vector<std::string> sentences_from(const std::string& json) {
  return parsed_list(json).get<std::vector<std::string>>();
}

std::string numbers_text(const std::vector<double>& numbers) { return nlohmann::json(numbers).dump(); }

std::vector<double> numbers_from(const std::string& json) {
  std::vector<double> numbers;
  for (const nlohmann::json& value : parsed_list(json)) numbers.push_back(number_or_unknown(value));
  return numbers;
}

std::string matrix_text(const Eigen::MatrixXd& matrix) {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& row : matrix.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows.dump();
}

Eigen::MatrixXd matrix_from(const std::string& json) {
  const nlohmann::json rows = parsed_list(json);
  const std::size_t columns = rows.empty() ? 0 : rows.at(0).size();
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = number_or_unknown(rows.at(i).at(j));
    }
  }
  return matrix;
}

}  // namespace lacuna
