#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/test_encoding.h>

#include "waveforms.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

/// Commands that do not look at the sensors: a multisine, steps, a chirp or a triangle on each actuator, within its
/// limits. The genes of an actuator, a row each, are in the units of what they name, so that a genome can be said in
/// words and typed back (experiment_design/test_line.h). Their names are a promise:
///
///     motor.shape           0 multisine, 1 steps, 2 chirp, 3 triangle
///     motor.amplitude       in the command's unit; less where the limits leave less about the centre
///     motor.centre          in the command's unit
///     motor.low_frequency   Hz; steps and triangles have this one alone
///     motor.high_frequency  Hz; the two of a band may stand in either order
///     motor.seed            of the phases of a multisine and the levels of steps
///
/// The README has the equations. Commands are held from sample to sample.
class CommandSeriesEncoding : public TestEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where there is no actuator, one has no finite range, or the frequency band is empty or too fast for
  /// the interval between commands.
  GenomeLayout layout(const TestSpace& space, std::span<const double> parameters) const override;
  /// Frequencies are drawn on a logarithmic scale, and every second centre is the resting command.
  Genome random(const GenomeLayout& layout, RandomStream& random) const override;
  Test decode(const TestSpace& space, std::span<const double> parameters,
              std::span<const double> genome) const override;
};

namespace {

enum Parameter : std::size_t { kAmplitude, kOffset, kLowest, kHighest, kDuration, kInterval };
enum GeneOfActuator : std::size_t { kShape, kSize, kCentre, kLow, kHigh, kSeed, kGenes };

constexpr double kLastShape = 3.0;
constexpr double kLastSeed = 999.0;
constexpr double kLeastCommands = 4.0;  // a period of the fastest command

/// The resting command: 0, or the middle of a range of which less than a quarter is on one side of 0.
double rest(double lower, double upper) {
  const double least = 0.25 * (upper - lower);
  return -lower >= least && upper >= least ? 0.0 : 0.5 * (lower + upper);
}

double interval_of(const TestSpace& space, std::span<const double> parameters) {
  return std::max(parameters[kInterval], space.control_period);
}

double duration_of(const TestSpace& space, std::span<const double> parameters) {
  return parameters[kDuration] > 0.0 ? std::min(parameters[kDuration], space.duration) : space.duration;
}

void check_ranges(const TestSpace& space) {
  if (space.actuators.empty()) throw Error("the robot has no actuator for commands");
  for (std::size_t a = 0; a < space.actuators.size(); ++a)
    if (!std::isfinite(space.lower[a]) || !std::isfinite(space.upper[a]) || space.lower[a] > space.upper[a])
      throw Error("no finite command range for the actuator \"" + space.actuators[a].name +
                  "\"; give it command_lower and command_upper");
}

void check_band(const TestSpace& space, std::span<const double> parameters) {
  if (parameters[kLowest] > parameters[kHighest])
    throw Error("lowest_frequency is above highest_frequency; exchange them");
  const double fastest = 1.0 / (kLeastCommands * interval_of(space, parameters));
  if (parameters[kHighest] > fastest)
    throw Error("highest_frequency = " + std::to_string(parameters[kHighest]) +
                " Hz leaves fewer than four commands per period; give it " + std::to_string(fastest) +
                " Hz at most, or shorten the control period");
}

std::vector<double> waveform(double shape, const WaveformTask& task) {
  switch (static_cast<int>(shape)) {
    case 0: return multisine(task);
    case 1: return steps(task);
    case 2: return chirp(task);
    default: return triangle(task);
  }
}

}  // namespace

std::string CommandSeriesEncoding::summary() const {
  return "Command series within the actuators' limits: a multisine, steps, a chirp or a triangle for each";
}

ParameterDeclarations CommandSeriesEncoding::parameters() const {
  return {
      {"amplitude", "1", 1.0, 0.001, 1.0, Scale::linear, "Largest amplitude, as a share of half the range of commands"},
      {"offset", "1", 0.25, 0.0, 2.0, Scale::linear,
       "Largest distance of the centre from the resting command, as a share of half the range"},
      {"lowest_frequency", "Hz", 0.1, 1e-4, 1e4, Scale::logarithmic, "Lower end of the band"},
      {"highest_frequency", "Hz", 5.0, 1e-4, 1e4, Scale::logarithmic, "Upper end of the band"},
      {"duration", "s", 0.0, 0.0, 1e5, Scale::linear,
       "Length of a test that is shorter than the others; 0: the common length"},
      {"interval", "s", 0.0, 0.0, 10.0, Scale::linear, "Time between commands, at least the control period"}};
}

GenomeLayout CommandSeriesEncoding::layout(const TestSpace& space, std::span<const double> parameters) const {
  check_ranges(space);
  check_band(space, parameters);
  GenomeLayout layout;
  layout.row = kGenes;
  for (std::size_t a = 0; a < space.actuators.size(); ++a) {
    const auto& [name, unit] = space.actuators[a];
    const double lower = space.lower[a], upper = space.upper[a], half = 0.5 * (upper - lower);
    const double middle = rest(lower, upper), off = parameters[kOffset] * half;
    layout.genes.push_back({name + ".shape", "1", GeneKind::integer, 0.0, kLastShape});
    layout.genes.push_back({name + ".amplitude", unit, GeneKind::real, 0.0, parameters[kAmplitude] * half});
    layout.genes.push_back(
        {name + ".centre", unit, GeneKind::real, std::max(lower, middle - off), std::min(upper, middle + off)});
    for (const char* end : {".low_frequency", ".high_frequency"})
      layout.genes.push_back({name + end, "Hz", GeneKind::real, parameters[kLowest], parameters[kHighest]});
    layout.genes.push_back({name + ".seed", "1", GeneKind::integer, 0.0, kLastSeed});
  }
  return layout;
}

Genome CommandSeriesEncoding::random(const GenomeLayout& layout, RandomStream& random) const {
  Genome genome = uniform_genome(layout, random);
  for (std::size_t first = 0; first < genome.size(); first += kGenes) {
    const Gene& centre = layout.genes[first + kCentre];
    const bool at_rest = random.chance(0.5);
    if (at_rest) genome[first + kCentre] = rest(centre.lower, centre.upper);
    for (const std::size_t end : {kLow, kHigh}) {
      const Gene& frequency = layout.genes[first + end];
      const double drawn = std::exp(random.uniform(std::log(frequency.lower), std::log(frequency.upper)));
      genome[first + end] = std::clamp(drawn, frequency.lower, frequency.upper);
    }
  }
  return genome;
}

Test CommandSeriesEncoding::decode(const TestSpace& space, std::span<const double> parameters,
                                   std::span<const double> genome) const {
  if (genome.size() != kGenes * space.actuators.size())
    throw Error("a genome of " + std::to_string(genome.size()) + " genes does not fit " +
                std::to_string(space.actuators.size()) + " actuators of " + std::to_string(kGenes) + " each");
  WaveformTask task;
  task.duration = duration_of(space, parameters);
  task.interval = interval_of(space, parameters);
  task.samples = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(task.duration / task.interval - 1e-9)));
  CommandSeries commands;
  commands.series.channels = space.actuators;
  const auto samples = static_cast<Eigen::Index>(task.samples);
  commands.series.times.resize(samples);
  for (Eigen::Index k = 0; k < samples; ++k) commands.series.times(k) = static_cast<double>(k) * task.interval;
  commands.series.samples.resize(samples, static_cast<Eigen::Index>(space.actuators.size()));
  for (std::size_t a = 0; a < space.actuators.size(); ++a) {
    const double* gene = genome.data() + a * kGenes;
    const double lower = space.lower[a], upper = space.upper[a];
    const double centre = std::clamp(gene[kCentre], lower, upper);
    const double amplitude = std::min({gene[kSize], upper - centre, centre - lower});
    task.low = std::min(gene[kLow], gene[kHigh]);
    task.high = std::max(gene[kLow], gene[kHigh]);
    task.seed = static_cast<unsigned>(gene[kSeed]);
    const std::vector<double> wave = waveform(gene[kShape], task);
    for (Eigen::Index k = 0; k < samples; ++k)
      commands.series.samples(k, static_cast<Eigen::Index>(a)) =
          std::clamp(centre + amplitude * wave[static_cast<std::size_t>(k)], lower, upper);
  }
  Test test;
  test.drive = std::move(commands);
  test.duration = task.duration;
  return test;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestEncoding, lacuna::CommandSeriesEncoding>("command_series"))
