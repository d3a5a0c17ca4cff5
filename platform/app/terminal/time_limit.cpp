#include "app/terminal/time_limit.h"

#include "config/quantity.h"
#include "foundation/interrupt.h"
#include "foundation/problem.h"
#include "foundation/shell_word.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace lacuna {
namespace {

constexpr const char* kHowToWrite = "write seconds, or a number with its unit: --time-limit 300, --time-limit '5 min'";

[[noreturn]] void refuse_limit(const std::string& text, const std::string& why) {
  throw_problem({}, "--time-limit " + shell_word(text) + ": " + why);
}

Quantity quantity_of(const std::string& text) try { return parse_quantity(text); } catch (const Error&) {
  refuse_limit(text, std::string("is not a duration; ") + kHowToWrite);
}

}  // namespace

double parse_time_limit(const std::string& text) {
  const Quantity quantity = quantity_of(text);
  const bool is_time = quantity.parsed.same_dimension(parse_unit("s").value());
  if (!is_time && quantity.unit != "1") refuse_limit(text, quantity.unit + " is not a unit of time; " + kHowToWrite);
  if (!std::isfinite(quantity.value_in_si)) refuse_limit(text, std::string("is not a duration; ") + kHowToWrite);
  if (quantity.value_in_si <= 0.0)
    refuse_limit(text, "a limit must be longer than 0; leave the option out to work without a limit");
  return quantity.value_in_si;
}

void add_time_limit_option(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--time-limit",
          [](const std::string& text) {
            const double seconds = parse_time_limit(text);
            const bool has_unit = text.find_first_not_of("0123456789.+e ") != std::string::npos;
            begin_time_limit(seconds, has_unit ? shell_word(text) : text + " s");
          },
          "End after so long with what is known by then (exit code 75): 300, \"5 min\"")
      ->option_text("DURATION");
}

}  // namespace lacuna
