#include "app/terminal/time_limit.h"

#include "config/toml/quantity.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace lacuna {
namespace {

constexpr double kEvaluationLimit = 120.0;  // s; evaluations take milliseconds, seconds where recordings are long

std::string how_to_write(const std::string& option) {
  return fmt::format("write seconds, or a number with its unit: {} 300, {} '5 min'", option, option);
}

[[noreturn]] void refuse_limit(const std::string& option, const std::string& text, const std::string& why) {
  throw_problem({}, option + " " + shell_word(text) + ": " + why);
}

Quantity quantity_of(const std::string& option, const std::string& text) try {
  return parse_quantity(text);
} catch (const Error&) {
  refuse_limit(option, text, "is not a duration; " + how_to_write(option));
}

}  // namespace

double parse_duration(const std::string& option, const std::string& text) {
  const Quantity quantity = quantity_of(option, text);
  const bool is_time = quantity.parsed.same_dimension(parse_unit("s").value());
  if (!is_time && quantity.unit != "1")
    refuse_limit(option, text, quantity.unit + " is not a unit of time; " + how_to_write(option));
  if (!std::isfinite(quantity.value_in_si)) refuse_limit(option, text, "is not a duration; " + how_to_write(option));
  if (quantity.value_in_si <= 0.0) refuse_limit(option, text, "must be longer than 0");
  return quantity.value_in_si;
}

void add_time_limit_option(CLI::App& command, CommonOptions& options) {
  command
      .add_option_function<std::string>(
          "--time-limit",
          [&options](const std::string& text) {
            const double seconds = parse_duration("--time-limit", text);
            const bool has_unit = text.find_first_not_of("0123456789.+e ") != std::string::npos;
            options.time_limit = std::make_shared<TimeLimit>(seconds, has_unit ? shell_word(text) : text + " s");
            options.stop = options.stop.within(*options.time_limit);
          },
          "Stop after this time and keep the results so far (exit code 75): 300, \"5 min\"")
      ->option_text("DURATION");
}

void begin_evaluation_limit() { CallPage::limit_evaluations(kEvaluationLimit); }

void add_evaluation_limit_option(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--evaluation-limit",
          [](const std::string& text) { CallPage::limit_evaluations(parse_duration("--evaluation-limit", text)); },
          "Time limit of one simulation of a model: 30, \"2 min\" (default: 2 min); beyond it the model counts as "
          "failed")
      ->option_text("DURATION");
}

}  // namespace lacuna
