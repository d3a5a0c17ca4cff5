#include "measurement/clocks/clock_wraps.h"

#include "foundation/statistics.h"
#include "measurement/clocks/clock_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kLongestTick = 20.0;  ///< median intervals: a clock that restarts continues within this time
constexpr double kDay = 86400.0;       ///< s
constexpr double kHour = 3600.0;

/// A restart of a clock: from `end` to `start`.
struct Wrap {
  double start = 0.0, end = 0.0;
  double modulus() const { return end - start; }
};

/// In the stamps' unit. Counters of milliseconds and microseconds may be written in other units.
std::vector<Wrap> known_wraps(const CsvTable& table, double seconds_per_unit) {
  if (table.period > 0.0) {
    std::vector<Wrap> wraps = {{0.0, table.period}};
    if (table.period == kDay) wraps.push_back({kHour, kHour + 0.5 * kDay});  // of twelve hours, 1 to 12
    return wraps;
  }
  std::vector<Wrap> wraps;
  const auto add = [&](int bits, double unit) {
    const double modulus = std::ldexp(unit, bits);
    wraps.push_back({0.0, modulus});
    wraps.push_back({-0.5 * modulus, 0.5 * modulus});
  };
  const bool whole =
      std::all_of(table.times.begin(), table.times.end(), [](double time) { return time == std::round(time); });
  for (const int bits : {16, 24, 31, 32})
    if (whole) add(bits, 1.0);
  for (const double tick : {1e-6, 1e-3}) add(32, tick / seconds_per_unit);
  wraps.push_back({0.0, kDay / seconds_per_unit});
  return wraps;
}

double median_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] > times[i - 1]) steps.push_back(times[i] - times[i - 1]);
  if (steps.empty()) return 0.0;
  return median_of(steps);
}

/// Whether all stamps lie between the ends of a wrap, and each step back goes from near one end to near the other.
bool explains(const Wrap& wrap, const CsvTable& table, double near) {
  const double rounding = 1e-9 * wrap.modulus();
  bool any = false;
  for (std::size_t i = 0; i < table.times.size(); ++i) {
    const double stamp = table.time_origin + table.times[i];
    if (stamp < wrap.start - rounding || stamp > wrap.end + rounding) return false;
    if (i == 0 || table.times[i] >= table.times[i - 1]) continue;
    if (stamp > wrap.start + near || table.time_origin + table.times[i - 1] < wrap.end - near) return false;
    any = true;
  }
  return any;
}

std::optional<Wrap> wrap_of_clock(const CsvTable& table, double seconds_per_unit) {
  const double near = kLongestTick * median_step(table.times);
  for (const Wrap& wrap : known_wraps(table, seconds_per_unit))
    if (explains(wrap, table, near)) return wrap;
  return std::nullopt;
}

/// A clock never goes back: each step back is one more turn, however long the gap.
void unwrap_clock(double modulus, std::vector<double>& times) {
  double turns = 0.0, before = times.empty() ? 0.0 : times.front();
  for (double& time : times) {
    if (time < before) turns += 1.0;
    before = time;
    time += turns * modulus;
  }
}

void note_wrap(const Wrap& wrap, const std::string& name, ReadTable& read) {
  const std::vector<double>& times = read.table.times;
  const auto back = std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return b < a; });
  const int line = read.table.lines[static_cast<std::size_t>(back - times.begin()) + 1];
  if (read.table.period > 0.0) {
    read.report.note("clock", line, [&] {
      return fmt::format("the clock, column `{}`, restarts after {:.0f} h here; its time is continued", name,
                         wrap.modulus() / kHour);
    });
    return;
  }
  read.report.doubt("clock", line, [&] {
    return fmt::format(
        "the clock, column `{}`, restarts at {:.10g}{}; its time is continued. State this in target.time: encoding = "
        "\"{}\"; if it is wrong, encoding = \"plain\"",
        name, wrap.end, wrap.start < 0.0 ? fmt::format(" from {:.10g} on", wrap.start) : "",
        to_string(Encoding{EncodingKind::wraps, wrap.modulus()}));
  });
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c; });
  return text;
}

struct FractionWord {
  std::string_view word;
  double unit;  ///< s
};
constexpr std::array<FractionWord, 14> kFractionWords = {{{"nanoseconds", 1e-9},
                                                          {"nanosecs", 1e-9},
                                                          {"nanosec", 1e-9},
                                                          {"nsecs", 1e-9},
                                                          {"nsec", 1e-9},
                                                          {"ns", 1e-9},
                                                          {"microseconds", 1e-6},
                                                          {"microsec", 1e-6},
                                                          {"usecs", 1e-6},
                                                          {"usec", 1e-6},
                                                          {"us", 1e-6},
                                                          {"milliseconds", 1e-3},
                                                          {"msec", 1e-3},
                                                          {"ms", 1e-3}}};

}  // namespace

void decode_clock(const ClockColumn& column, ReadTable& read) {
  CsvTable& table = read.table;
  double modulus = column.encoding.kind == EncodingKind::wraps ? column.encoding.modulus : 0.0;
  const bool may_wrap = table.trial_names.empty() && (!table.dated || table.period > 0.0);  // dates do not
  if (column.encoding.kind == EncodingKind::automatic && may_wrap) {
    const std::optional<Wrap> wrap = wrap_of_clock(table, column.seconds_per_unit);
    if (!wrap) return;
    note_wrap(*wrap, column.name, read);
    modulus = wrap->modulus();
  }
  if (modulus > 0.0) unwrap_clock(modulus, table.times);
}

std::optional<FractionColumn> fraction_beside(const std::string& seconds, const std::vector<std::string>& names) {
  const std::string name = lower(seconds);
  for (const std::string_view word : {"seconds", "secs", "sec", "s"}) {
    if (!name.ends_with(word)) continue;
    const std::string stem = name.substr(0, name.size() - word.size());
    if (word == "s" && !stem.empty() && std::string_view("._ /").find(stem.back()) == std::string_view::npos) continue;
    for (const std::string& other : names)
      for (const FractionWord& fraction : kFractionWords)
        if (lower(other) == stem + std::string(fraction.word)) return FractionColumn{other, fraction.unit};
    return std::nullopt;
  }
  return std::nullopt;
}

double period_of_step_back(double before, double after, double usual) {
  const double near = kLongestTick * usual;
  for (const double period : {1.0, 60.0, kHour, 0.5 * kDay, kDay})
    if (after >= 0.0 && after < near && before <= period && before > period - near) return period;
  return 0.0;
}

}  // namespace lacuna
