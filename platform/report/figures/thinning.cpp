#include "report/figures/thinning.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

void keep_extremes(const std::vector<double>& y, std::size_t begin, std::size_t end, std::vector<std::size_t>& kept) {
  std::vector<std::size_t> chosen = {begin, end - 1};
  std::size_t smallest = begin, largest = begin;
  for (std::size_t i = begin; i < end; ++i) {
    if (std::isnan(y[i])) {
      if (i == begin || !std::isnan(y[i - 1])) chosen.push_back(i);
      continue;
    }
    if (std::isnan(y[smallest]) || y[i] < y[smallest]) smallest = i;
    if (std::isnan(y[largest]) || y[i] > y[largest]) largest = i;
  }
  chosen.push_back(smallest);
  chosen.push_back(largest);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  kept.insert(kept.end(), chosen.begin(), chosen.end());
}

}  // namespace

std::vector<std::size_t> thinned(const std::vector<double>& y, std::size_t columns) {
  std::vector<std::size_t> kept;
  if (y.size() <= 4 * columns) {
    kept.resize(y.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return kept;
  }
  for (std::size_t column = 0; column < columns; ++column)
    keep_extremes(y, y.size() * column / columns, y.size() * (column + 1) / columns, kept);
  return kept;
}

}  // namespace lacuna
