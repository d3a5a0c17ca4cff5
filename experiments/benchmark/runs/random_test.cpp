#include "runs/random_test.h"

#include "cases/write_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <stdexcept>
#include <string_view>

namespace hidden_effects {
namespace {

constexpr std::array kShapes = {"multisine", "steps", "chirp", "triangle"};
constexpr double kFastestTest = 5.0;  ///< Hz
constexpr double kOffCentre = 0.25;   ///< of half the range
constexpr std::size_t kSeeds = 1000;

bool has_band(std::string_view shape) { return shape == "multisine" || shape == "chirp"; }
bool has_seed(std::string_view shape) { return shape == "multisine" || shape == "steps"; }

/// To three digits, by the way of `rounding`.
template <class Rounding>
double to_three_digits(double value, const Rounding& rounding) {
  if (value == 0.0) return 0.0;
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
  return std::stod(fmt::format("{:.3g}", rounding(value / digit) * digit));
}

double rounded_down(double value) {
  return to_three_digits(value, [](double digits) { return std::floor(digits); });
}
double rounded_up(double value) {
  return to_three_digits(value, [](double digits) { return std::ceil(digits); });
}

/// What the program takes for the resting command: 0, unless there is little room on one side of it.
double resting_command(const CommandRange& range) {
  const double least = 0.25 * (range.upper - range.lower);
  return -range.lower >= least && range.upper >= least ? 0.0 : 0.5 * (range.lower + range.upper);
}

double draw_centre(const CommandRange& range, Draw& draw) {
  const double rest = resting_command(range), off = kOffCentre * 0.5 * (range.upper - range.lower);
  const double drawn = draw.between(std::max(range.lower, rest - off), std::min(range.upper, rest + off));
  const double centre = draw.uniform() < 0.5 ? rest : drawn;
  return std::clamp(rounded_down(centre), range.lower, range.upper);
}

/// Above 0.
double draw_amplitude(const CommandRange& range, double centre, Draw& draw) {
  const double room = std::min(range.upper - centre, centre - range.lower);
  for (;;) {
    const double amplitude = rounded_down(std::min(0.5 * (range.upper - range.lower) * draw.uniform(), room));
    if (amplitude > 0.0) return amplitude;
    if (!(room > 0.0)) throw std::runtime_error("the commands of " + range.drive + " leave no room for a test");
  }
}

std::string draw_band(std::string_view shape, double slowest, Draw& draw) {
  std::array<double, 2> ends{};
  for (double& end : ends) {
    const double drawn = slowest * std::pow(kFastestTest / slowest, draw.uniform());
    end = std::clamp(rounded_down(drawn), slowest, kFastestTest);
  }
  const auto [low, high] = std::minmax(ends[0], ends[1]);
  return has_band(shape) ? fmt::format("{:g}-{:g} Hz", low, high) : fmt::format("{:g} Hz", low);
}

std::string draw_part(const CommandRange& range, double duration, Draw& draw) {
  const std::string_view shape = kShapes[draw.below(kShapes.size())];
  const double centre = draw_centre(range, draw), amplitude = draw_amplitude(range, centre, draw);
  std::string text = fmt::format("{} {} {} {}", shape, range.drive, amplitude, range.unit);
  if (centre != 0.0) text += fmt::format(" around {} {}", centre, range.unit);
  text += fmt::format(" {} {:g} s", draw_band(shape, rounded_up(1.0 / duration), draw), duration);
  if (has_seed(shape)) text += fmt::format(" seed {}", draw.below(kSeeds));
  return text;
}

}  // namespace

std::vector<CommandRange> command_ranges(const MadeCase& made) {
  std::vector<CommandRange> ranges;
  const PlantSpec& spec = made.base.spec;
  for (std::size_t d = 0; d < spec.drives.size(); ++d) {
    CommandRange range{spec.drives[d].name, unit_of_command(spec, spec.drives[d]), 0.0, 0.0};
    for (const MadeTrial& trial : made.trials) {
      if (trial.held_out) continue;
      const auto [least, most] =
          std::minmax_element(trial.recorded_commands[d].begin(), trial.recorded_commands[d].end());
      range.lower = std::min(range.lower, *least);
      range.upper = std::max(range.upper, *most);
    }
    ranges.push_back(range);
  }
  return ranges;
}

std::string random_test(const std::vector<CommandRange>& ranges, double duration, Draw& draw) {
  std::vector<std::string> parts;
  for (const CommandRange& range : ranges) parts.push_back(draw_part(range, duration, draw));
  return fmt::format("{}", fmt::join(parts, ", "));
}

double duration_of_test(const std::string& line) {
  static const std::regex kDuration(" ([0-9.e+-]+) s( |,|$)");
  std::smatch found;
  if (!std::regex_search(line, found, kDuration))
    throw std::runtime_error("the test \"" + line + "\" says no duration");
  return std::stod(found[1]);
}

std::string reseeded_test(const std::string& line, Draw& draw) {
  static const std::regex kSeed(" seed [0-9]+");
  std::string text;
  auto from = line.begin();
  for (std::sregex_iterator one(line.begin(), line.end(), kSeed), end; one != end; ++one) {
    text.append(from, (*one)[0].first);
    text += fmt::format(" seed {}", draw.below(kSeeds));
    from = (*one)[0].second;
  }
  return text.append(from, line.end());
}

}  // namespace hidden_effects
