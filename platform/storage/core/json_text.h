#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

/// Lists that no query looks into, as JSON text; NaN and infinities are null and read back as NaN.
namespace lacuna {

std::string sentences_text(const std::vector<std::string>& sentences);
std::vector<std::string> sentences_from(const std::string& json);

std::string numbers_text(const std::vector<double>& numbers);
std::vector<double> numbers_from(const std::string& json);

/// A list of rows.
std::string matrix_text(const Eigen::MatrixXd& matrix);
Eigen::MatrixXd matrix_from(const std::string& json);

}  // namespace lacuna
