#include "figures/matrix_picture.h"

#include "foundation/files/whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

namespace hidden_effects {
namespace {

constexpr int kCell = 26;    // px
constexpr int kNames = 190;  // px, for the names at the left and above
constexpr int kTitle = 58;   // px
constexpr int kMargin = 60;  // px, at the right: names above lean over

std::vector<std::string> columns_of(const Matrix& matrix) {
  std::set<std::string> names;
  for (const auto& [row, cells] : matrix.count)
    for (const auto& [column, number] : cells) names.insert(column);
  return {names.begin(), names.end()};
}

std::string cell_svg(int x, int y, int number, double share) {
  std::string cell = fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#0072B2\" fill-opacity=\"{:.3f}\" "
      "stroke=\"#DDDDDD\"/>\n",
      x, y, kCell, kCell, share);
  if (number > 0)
    cell += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"{}\">{}</text>\n", x + kCell / 2,
                        y + kCell / 2 + 4, share > 0.5 ? "#FFFFFF" : "#3A3A3A", number);
  return cell;
}

std::string frame_svg(int x, int y) {
  return fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#D55E00\" stroke-width=\"2\"/>\n",
      x + 1, y + 1, kCell - 2, kCell - 2);
}

std::string row_svg(const std::string& name, const std::map<std::string, int>& cells,
                    const std::vector<std::string>& columns, int y) {
  int total = 0;
  for (const auto& [column, number] : cells) total += number;
  std::string row = fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{} ({})</text>\n", kNames - 6,
                                y + kCell / 2 + 4, name, total);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto found = cells.find(columns[c]);
    const int number = found == cells.end() ? 0 : found->second;
    row += cell_svg(kNames + static_cast<int>(c) * kCell, y, number, static_cast<double>(number) / total);
  }
  return row;
}

/// Over all cells, whose lines would cut them.
std::string frames_svg(const Matrix& matrix, const std::vector<std::string>& columns, int top) {
  std::string frames;
  int y = top;
  for (const auto& [name, cells] : matrix.count) {
    const auto own = std::find(columns.begin(), columns.end(), name);
    if (own != columns.end()) frames += frame_svg(kNames + static_cast<int>(own - columns.begin()) * kCell, y);
    y += kCell;
  }
  return frames;
}

}  // namespace

std::string matrix_svg(const Matrix& matrix) {
  const std::vector<std::string> columns = columns_of(matrix);
  const int top = kTitle + kNames;
  const int width = kNames + static_cast<int>(columns.size()) * kCell + kNames + kMargin;
  const int height = top + static_cast<int>(matrix.count.size()) * kCell + kMargin;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"11\" fill=\"#3A3A3A\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"#FFFFFF\"/>\n<text x=\"12\" y=\"22\" font-size=\"14\">{2}</text>\n<text x=\"12\" y=\"40\">{3}</text>\n",
      width, height, matrix.title, matrix.note);
  svg += fmt::format("<text x=\"12\" y=\"{}\">{} ↓, {} →</text>\n", kTitle, matrix.row_title, matrix.column_title);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const int x = kNames + static_cast<int>(c) * kCell + kCell / 2;
    svg +=
        fmt::format("<text x=\"{0}\" y=\"{1}\" transform=\"rotate(-55 {0} {1})\">{2}</text>\n", x, top - 6, columns[c]);
  }
  int y = top;
  for (const auto& [name, cells] : matrix.count) {
    svg += row_svg(name, cells, columns, y);
    y += kCell;
  }
  return svg + frames_svg(matrix, columns, top) + "</svg>\n";
}

void write_matrix(const Matrix& matrix, const std::filesystem::path& file) {
  lacuna::write_whole(file, matrix_svg(matrix), lacuna::Link::replaced);
}

}  // namespace hidden_effects
