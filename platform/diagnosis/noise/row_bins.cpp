#include "diagnosis/noise/row_bins.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace lacuna {
namespace {

constexpr double kShortest = 0.0125;  // s
constexpr double kMostRows = 600.0;   // a segment
constexpr double kBlock = 0.5;        // s

bool earlier(const RowBins::Bin& one, const RowBins::Bin& other) { return one.time < other.time; }

}  // namespace

RowBins::RowBins(const ShootingProblem& problem, const std::vector<double>& least_widths) {
  for (std::size_t k = 0; k < problem.segments().size(); ++k) {
    const Eigen::Index measured = problem.robust_rows(k);
    std::set<std::size_t> channels;
    for (Eigen::Index row = 0; row < measured; ++row) channels.insert(problem.place(k, row).channel);
    const double begin = problem.place(k, 0).time, end = problem.place(k, measured - 1).time;
    const double shortest = (end - begin) * static_cast<double>(channels.size()) / kMostRows;
    const auto width_of = [&](std::size_t channel) {
      return std::max(least_widths.empty() ? kShortest : least_widths[channel], shortest);
    };
    Segment segment;
    std::map<std::pair<std::size_t, long>, Eigen::Index> known;
    for (Eigen::Index row = 0; row < measured; ++row) {
      const ResidualPlace place = problem.place(k, row);
      const double width = width_of(place.channel);
      const auto key = std::pair(place.channel, static_cast<long>((place.time - begin) / width + 1e-6));
      const auto [at, is_new] = known.try_emplace(key, static_cast<Eigen::Index>(segment.bins.size()));
      if (is_new) segment.bins.push_back({place.channel, 0.0, 0.0});
      Bin& bin = segment.bins[static_cast<std::size_t>(at->second)];
      bin.time += place.time;
      bin.count += 1.0;
      segment.bin_of.push_back(at->second);
    }
    for (Bin& bin : segment.bins) bin.time /= bin.count;
    segments_.push_back(std::move(segment));
  }
}

RowBins::RowBins(std::vector<std::vector<Bin>> segments) {
  for (std::vector<Bin>& bins : segments) {
    std::vector<Eigen::Index> own(bins.size());
    std::iota(own.begin(), own.end(), Eigen::Index{0});
    segments_.push_back({std::move(bins), std::move(own)});
  }
}

Eigen::Index RowBins::rows() const {
  Eigen::Index all = 0;
  for (const Segment& segment : segments_) all += static_cast<Eigen::Index>(segment.bins.size());
  return all;
}

std::vector<std::size_t> RowBins::blocks(std::size_t k) const {
  const std::vector<Bin>& all = bins(k);
  const auto [first, last] = std::minmax_element(all.begin(), all.end(), earlier);
  const double begin = first->time, duration = last->time - begin;
  const double pieces = std::max(1.0, std::round(duration / kBlock));
  std::vector<double> piece;
  for (const Bin& bin : all)
    piece.push_back(duration > 0.0 ? std::floor(std::min(pieces - 1.0, (bin.time - begin) / duration * pieces)) : 0.0);
  std::map<double, std::size_t> numbers;  // of the pieces that hold bins
  for (const double one : piece) numbers[one] = 0;
  std::size_t count = 0;
  for (auto& [unused, number] : numbers) number = count++;
  std::vector<std::size_t> block;
  for (const double one : piece) block.push_back(numbers[one]);
  return block;
}

Eigen::MatrixXd RowBins::means(std::size_t k, const Eigen::Ref<const Eigen::MatrixXd>& rows) const {
  const Segment& segment = segments_[k];
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(segment.bins.size()), rows.cols());
  for (std::size_t row = 0; row < segment.bin_of.size(); ++row)
    result.row(segment.bin_of[row]) += rows.row(static_cast<Eigen::Index>(row));
  for (std::size_t bin = 0; bin < segment.bins.size(); ++bin)
    result.row(static_cast<Eigen::Index>(bin)) /= segment.bins[bin].count;
  return result;
}

}  // namespace lacuna
