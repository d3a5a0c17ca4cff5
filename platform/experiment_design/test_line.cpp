#include "experiment_design/test_line.h"

#include "config/toml/quantity.h"
#include "foundation/text/problem.h"
#include "measurement/names/column_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace lacuna {
namespace {

/// The genes of an actuator, in the order of the encoding.
enum GeneOfLine : std::size_t { kShape, kAmplitude, kCentre, kLow, kHigh, kSeed, kGenes };

const std::vector<std::string> kShapes = {"multisine", "steps", "chirp", "triangle"};
constexpr double kMultisine = 0.0, kChirp = 2.0;
bool has_band(double shape) { return shape == kMultisine || shape == kChirp; }
bool has_seed(double shape) { return shape == kMultisine || shape == 1.0; }

constexpr double kLastSeed = 999.0;
constexpr double kLeastCommands = 4.0;  ///< a period of the fastest command
constexpr double kMostSamples = 1e6;    ///< of a test; a longer one needs too much memory
constexpr const char* kExample = "multisine motor 0.2 N*m 0.1-5 Hz 10 s seed 3";

double three_digits(double value) { return std::stod(fmt::format("{:.3g}", value)); }

/// Rounds towards 0, so that a value within the limits stays within them.
double three_digits_at_most(double value) {
  if (!(value > 0.0)) return 0.0;
  const double nearest = three_digits(value);
  if (nearest <= value) return nearest;
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return three_digits(nearest - digit);
}

/// Away from 0.
double three_digits_at_least(double value) {
  const double nearest = three_digits(value);
  if (nearest >= value) return nearest;
  return three_digits(nearest + std::pow(10.0, std::floor(std::log10(value)) - 2.0));
}

/// Hz: the lowest frequency that the duration allows and the highest that the control period allows.
double slowest(const TestSpace& space) { return three_digits_at_least(1.0 / space.duration); }
double fastest(const TestSpace& space) { return 1.0 / (kLeastCommands * space.control_period); }

double resting(const TestSpace& space, std::size_t actuator) {
  return std::clamp(0.0, space.lower[actuator], space.upper[actuator]);
}

/// The largest amplitude about a centre.
double room(const TestSpace& space, std::size_t actuator, double centre) {
  return std::min(space.upper[actuator] - centre, centre - space.lower[actuator]);
}

/// One actuator's words, read from left to right.
class Words {
 public:
  explicit Words(const std::string& text) : stream_(text) { next(); }

  bool done() const { return word_.empty(); }
  const std::string& word() const { return word_; }
  std::string take() {
    std::string word = word_;
    next();
    return word;
  }
  bool take(const std::string& word) {
    if (word_ != word) return false;
    next();
    return true;
  }
  /// Reads a number and its unit; returns SI.
  double quantity(const std::string& what, const std::string& unit) {
    const std::string number = take(), written = take();
    const std::string known = unit_of_cell(written);
    const std::string wanted =
        fmt::format("{} must be a number with a unit such as {}, as in \"0.3 {}\"", what, unit, unit);
    if (number.empty()) throw Error(wanted + ", but the line ends here");
    if (known.empty())
      throw Error(fmt::format("{}, not \"{}{}{}\"", wanted, number, written.empty() ? "" : " ", written));
    const Quantity quantity = parse_quantity(number + " " + known);
    if (!quantity.parsed.same_dimension(*parse_unit(unit))) throw Error(wanted + fmt::format(", not in {}", written));
    if (!std::isfinite(quantity.value_in_si)) throw Error(what + " is not finite");
    return quantity.value_in_si;
  }

 private:
  void next() {
    word_.clear();
    stream_ >> word_;
  }
  std::istringstream stream_;
  std::string word_;
};

/// "0.1-5" Hz: both ends, in Hz. A multisine of one frequency is a sine.
std::array<double, 2> take_band(Words& words, double shape) {
  const std::string numbers = words.take(), unit = words.take();
  if (numbers.empty()) throw Error("the frequency must be in Hz, as in \"0.1 Hz\", but the line ends here");
  std::size_t dash = numbers.find('-', 1);
  while (dash != std::string::npos && (numbers[dash - 1] == 'e' || numbers[dash - 1] == 'E'))
    dash = numbers.find('-', dash + 1);
  const bool has_two = dash != std::string::npos;
  const std::string& name = kShapes[static_cast<std::size_t>(shape)];
  if (has_two ? !has_band(shape) : shape == kChirp)
    throw Error(has_two
                    ? name + " want one frequency, as in \"0.1 Hz\", but \"" + numbers + " " + unit + "\" stands there"
                    : "a " + name + " wants two frequencies, as in \"0.1-5 Hz\", but \"" + numbers + " " + unit +
                          "\" stands there");
  Words low((has_two ? numbers.substr(0, dash) : numbers) + " " + unit);
  Words high((has_two ? numbers.substr(dash + 1) : numbers) + " " + unit);
  const std::array<double, 2> band = {low.quantity("the frequency", "Hz"), high.quantity("the frequency", "Hz")};
  if (!(band[0] > 0.0) || band[1] < band[0])
    throw Error(
        fmt::format("\"{} {}\" is not a frequency band; write the lower frequency first, above 0", numbers, unit));
  return band;
}

double take_seed(Words& words) {
  const std::string number = words.take();
  const bool digits =
      !number.empty() && number.size() <= 3 && number.find_first_not_of("0123456789") == std::string::npos;
  if (!digits) throw Error(fmt::format("a seed must be a whole number from 0 to {:g}, not \"{}\"", kLastSeed, number));
  return std::stod(number);
}

/// The genes of one actuator and its duration.
struct Part {
  std::size_t actuator = 0;
  std::array<double, kGenes> genes{};
  double duration = 0.0;
};

std::size_t take_actuator(Words& words, const TestSpace& space) {
  std::vector<std::string> names;
  for (const Channel& actuator : space.actuators) names.push_back(actuator.name);
  const std::string name = words.take();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(fmt::format("the robot has no actuator \"{}\"{}; it has {}", name, did_you_mean(name, names),
                            fmt::join(names, ", ")));
  return static_cast<std::size_t>(found - names.begin());
}

void check_limits(const TestSpace& space, const Part& part) {
  const std::size_t a = part.actuator;
  const std::string& unit = space.actuators[a].unit;
  const double amplitude = part.genes[kAmplitude], centre = part.genes[kCentre];
  if (!(amplitude > 0.0))
    throw Error("an amplitude must be above 0; to leave the actuator at rest, leave it out of the line");
  if (amplitude <= room(space, a, centre)) return;
  throw Error(fmt::format("{:.4g} {} about {:.4g} {} exceeds the limits of {}, {:.4g} to {:.4g} {}; {}", amplitude,
                          unit, centre, unit, space.actuators[a].name, space.lower[a], space.upper[a], unit,
                          room(space, a, centre) > 0.0
                              ? fmt::format("reduce the amplitude to {:.4g} {}", room(space, a, centre), unit)
                              : std::string("give a centre within the limits with \"around\"")));
}

void check_times(const TestSpace& space, const Part& part) {
  if (part.genes[kHigh] > fastest(space))
    throw Error(fmt::format(
        "{:.4g} Hz leaves fewer than four commands per period at a control period of {:.4g} s; use {:.4g} Hz or less",
        part.genes[kHigh], space.control_period, fastest(space)));
  if (part.duration * part.genes[kLow] < 1.0 - 1e-9)
    throw Error(fmt::format(
        "a duration of {:.4g} s is shorter than one period of {:.4g} Hz; use {:.4g} s or more, or a higher frequency",
        part.duration, part.genes[kLow], 1.0 / part.genes[kLow]));
  if (part.duration > kMostSamples * space.control_period)
    throw Error(fmt::format("a duration of {:.4g} s is more than a million control periods of {:.4g} s; shorten it",
                            part.duration, space.control_period));
}

Part parse_part(const TestSpace& space, const std::string& text) {
  Words words(text);
  const std::string shape = words.take();
  const auto found = std::find(kShapes.begin(), kShapes.end(), shape);
  if (found == kShapes.end())
    throw Error(fmt::format("unknown shape \"{}\"{}; shapes are {}, as in \"{}\"", shape, did_you_mean(shape, kShapes),
                            fmt::join(kShapes, ", "), kExample));
  Part part;
  part.genes[kShape] = static_cast<double>(found - kShapes.begin());
  part.actuator = take_actuator(words, space);
  const std::string& unit = space.actuators[part.actuator].unit;
  part.genes[kAmplitude] = words.quantity("the amplitude", unit);
  if (words.take("around")) part.genes[kCentre] = words.quantity("the centre", unit);
  const std::array<double, 2> band = take_band(words, part.genes[kShape]);
  part.genes[kLow] = band[0];
  part.genes[kHigh] = band[1];
  part.duration = words.quantity("the duration", "s");
  if (has_seed(part.genes[kShape]) && words.take("seed")) part.genes[kSeed] = take_seed(words);
  if (!words.done())
    throw Error(fmt::format("\"{}\" is not expected here; a test is a line such as \"{}\"", words.word(), kExample));
  check_limits(space, part);
  check_times(space, part);
  return part;
}

/// Parses all parts of the line; adds a problem for each part that cannot be read.
std::vector<Part> parse_parts(const TestSpace& space, const std::string& line) {
  ProblemList problems;
  std::vector<Part> parts;
  std::istringstream stream(line);
  for (std::string text; std::getline(stream, text, ',');) try {
      parts.push_back(parse_part(space, text));
    } catch (const Error& error) {
      problems.add({}, "test \"" + line + "\": " + error.what());
    }
  if (parts.empty() && problems.empty())
    problems.add({}, fmt::format("the test is empty; write a line such as \"{}\"", kExample));
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].duration != parts[0].duration)
      problems.add(
          {}, "test \"" + line + "\": all actuators of a test must have the same duration; give them one duration");
    for (std::size_t j = 0; j < i; ++j)
      if (parts[i].actuator == parts[j].actuator)
        problems.add({}, "test \"" + line + "\": " + space.actuators[parts[i].actuator].name +
                             " appears twice; name each actuator once");
  }
  problems.throw_if_any();
  return parts;
}

std::string part_text(const TestSpace& space, std::size_t actuator, const double* gene) {
  const auto& [name, unit] = space.actuators[actuator];
  std::string text =
      fmt::format("{} {} {} {}", kShapes[static_cast<std::size_t>(gene[kShape])], name, gene[kAmplitude], unit);
  if (gene[kCentre] != 0.0) text += fmt::format(" around {} {}", gene[kCentre], unit);
  text +=
      gene[kHigh] > gene[kLow] ? fmt::format(" {}-{} Hz", gene[kLow], gene[kHigh]) : fmt::format(" {} Hz", gene[kLow]);
  text += fmt::format(" {} s", space.duration);
  if (has_seed(gene[kShape])) text += fmt::format(" seed {}", gene[kSeed]);
  return text;
}

}  // namespace

Genome sayable(const TestSpace& space, const Genome& genome) {
  Genome said = genome;
  for (std::size_t a = 0; a < space.actuators.size(); ++a) {
    double* gene = said.data() + a * kGenes;
    const auto [low, high] = std::minmax(gene[kLow], gene[kHigh]);
    gene[kLow] = std::max(three_digits(std::min(low, three_digits_at_most(fastest(space)))), slowest(space));
    gene[kHigh] = std::max(three_digits(std::min(high, three_digits_at_most(fastest(space)))), gene[kLow]);
    if (!has_band(gene[kShape])) gene[kHigh] = gene[kLow];
    if (gene[kShape] == kChirp && gene[kHigh] == gene[kLow]) gene[kShape] = kMultisine;  // a sine, either way
    if (!has_seed(gene[kShape])) gene[kSeed] = 0.0;
    gene[kCentre] = std::clamp(three_digits(gene[kCentre]), space.lower[a], space.upper[a]);
    gene[kAmplitude] = three_digits_at_most(std::min(gene[kAmplitude], room(space, a, gene[kCentre])));
    if (gene[kAmplitude] > 0.0) continue;
    std::fill_n(gene, kGenes, 0.0);
    gene[kCentre] = resting(space, a);
  }
  return said;
}

std::string test_line(const TestSpace& space, const Genome& genome) {
  std::vector<std::string> parts;
  for (std::size_t a = 0; a < space.actuators.size(); ++a)
    if (genome[a * kGenes + kAmplitude] > 0.0) parts.push_back(part_text(space, a, genome.data() + a * kGenes));
  return fmt::format("{}", fmt::join(parts, ", "));
}

TestLine parse_test_line(const TestSpace& space, const std::string& line) {
  const std::vector<Part> parts = parse_parts(space, line);
  TestLine test{Genome(space.actuators.size() * kGenes, 0.0), parts.front().duration};
  for (std::size_t a = 0; a < space.actuators.size(); ++a) test.genome[a * kGenes + kCentre] = resting(space, a);
  for (const Part& part : parts)
    std::copy(part.genes.begin(), part.genes.end(),
              test.genome.begin() + static_cast<std::ptrdiff_t>(part.actuator * kGenes));
  return test;
}

}  // namespace lacuna
