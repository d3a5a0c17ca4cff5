#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace hidden_effects {

/// Counts by the names of row and column.
struct Matrix {
  std::string title, row_title, column_title;
  std::map<std::string, std::map<std::string, int>> count;
  std::string note = {};  ///< below the title
};

/// The matrix as SVG text: the number in each cell, shaded by its share of the row; the diagonal is framed.
std::string matrix_svg(const Matrix& matrix);

/// Throws `lacuna::Error` where the file cannot be written.
void write_matrix(const Matrix& matrix, const std::filesystem::path& file);

}  // namespace hidden_effects
