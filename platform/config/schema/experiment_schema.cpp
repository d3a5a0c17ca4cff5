#include "config/schema/experiment_schema.h"

#include <algorithm>
#include <limits>

namespace lacuna {
namespace {

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
constexpr auto kLargest = std::numeric_limits<std::int64_t>::max();

/// A horizon in seconds is kept as text, as `FitSection` wants it.
Value<std::string> horizon() {
  const Value<std::string> words = text_of({"whole", "auto"});
  const NumberValue seconds = number("s").above(0.0);
  Value<std::string> value;
  value.shape.kind = Shape::Kind::either;
  value.shape.parts = {words.shape, seconds.shape};
  value.read = [words, seconds, shape = value.shape](const TomlNode& node, Reading& reading, std::string& result) {
    result = node.text;
    if (result == "whole" || result == "auto") return true;
    const bool is_quantity = node.is_number() || result.find_first_of("0123456789") == 0;
    double read = 0.0;
    if (is_quantity && !seconds.read(node, reading, read)) return false;
    if (!is_quantity) report_mismatch(shape, node, reading);
    result = toml_number(read);
    return is_quantity;
  };
  value.write = words.write;
  return value;
}

void check_segments(const TomlNode& node, Reading& reading, FitSection& fit) {
  if (!std::is_sorted(fit.segments.begin(), fit.segments.end()))
    reading.problem_at("segments", node.find("segments")->location, "the lengths must increase");
}

/// A value of any key, kept as TOML.
Value<std::string> swept_value() {
  Value<std::string> value;
  value.shape.kind = Shape::Kind::either;
  value.shape.parts = {boolean().shape, number("").or_infinite().shape, text().shape};
  value.read = [shape = value.shape](const TomlNode& node, Reading& reading, std::string& result) {
    switch (node.kind) {
      case TomlNode::Kind::boolean: result = node.boolean ? "true" : "false"; return true;
      case TomlNode::Kind::integer: result = std::to_string(node.integer); return true;
      case TomlNode::Kind::real: result = toml_number(node.real); return true;
      case TomlNode::Kind::text: result = toml_text(node.text); return true;
      default: report_mismatch(shape, node, reading); return false;
    }
  };
  value.write = [](const std::string& shown) { return shown; };
  return value;
}

Value<std::vector<SweptKey>> swept_keys() {
  using Values = std::vector<std::string>;
  return named<std::vector<SweptKey>, Values>(
      "KEY", list_of(swept_value(), 1), [](std::vector<SweptKey>& keys, const TomlMember& member, Values&& values) {
        keys.emplace_back(member.name, std::move(values));
      });
}

/// Contact values stand with the engine for the user's sake; they are values of the robot.
using ContactValues = std::map<std::string, double>;

Table<ContactValues> ground_values() {
  const auto keep = [](const std::string& name) {
    return [name](ContactValues& values, double&& value) { values["contact." + name] = value; };
  };
  return Table<ContactValues>()
      .key<double>("stiffness", number("N/m").above(0.0).or_infinite(), kUnset, keep("stiffness"),
                   "stiffness of the ground, instead of the robot file's; inf: rigid")
      .key<double>("damping", number("N*s/m").at_least(0.0), kUnset, keep("damping"), "damping of the ground")
      .key<double>("friction", number("1").at_least(0.0).or_infinite(), kUnset, keep("friction"),
                   "Coulomb friction coefficient");
}

struct EngineSection {
  EngineSettings settings;
  ContactValues contact;
};

Table<EngineSection> engine_section_keys() {
  return Table<EngineSection>()
      .merged(&EngineSection::settings, engine_keys())
      .key("contact", &EngineSection::contact, ground_values().value(),
           "Contact with the ground; the same as contact.* under model.set and, for a simulated target, target.set.");
}

void check_contact(const TomlNode& node, Reading& reading, Experiment&) {
  const TomlNode* engine = node.find("engine");
  const TomlNode* contact = engine ? engine->find("contact") : nullptr;
  const TomlNode* model = node.find("model");
  const TomlNode* set = model ? model->find("set") : nullptr;
  if (!contact || !set) return;
  for (const TomlMember& member : contact->members)
    if (set->find("contact." + member.name))
      reading.problem_at("engine.contact." + member.name, member.location, "is also in model.set; keep one of them");
}

}  // namespace

Table<EngineSettings> engine_keys() {
  return Table<EngineSettings>()
      .key("engine", &EngineSettings::engine, text_of({"articulated", "ode"}),
           "integrator: articulated (joints and floating bodies without contacts, second order) or ode "
           "(contacts, "
           "first order); default: articulated, or ode if bodies may touch the ground")
      .key("step", &EngineSettings::step, number("s").above(0.0),
           "duration of a step; sensors, effects and commands are updated once per step")
      .key("substeps", &EngineSettings::substeps, whole_number<int>(0, 100000),
           "integration steps per step; 0: as many as needed, found by comparing two solutions, and printed; with ode "
           "always one, because its contacts depend on the step")
      .key("control_period", &EngineSettings::control_period, number("s").at_least(0.0),
           "period of a controller; 0: every step")
      .key("joint_erp", &EngineSettings::joint_erp, number("1").between(0.0, 1.0),
           "ode: share of a joint's position error that is corrected in one integration step")
      .key("delay_rounding", &EngineSettings::delay_rounding,
           choice<DelayRounding>({{"none", DelayRounding::none}, {"step", DelayRounding::step}}),
           "delays act exactly (none) or rounded to whole integration steps (step)");
}

Table<FitSection> fit_keys() {
  return Table<FitSection>()
      .key("method", &FitSection::method, text_of({"multiple_shooting", "free_run"}), "method of the fit")
      .key("segments", &FitSection::segments, list_of<double>(number("s").above(0.0)),
           "segment lengths for multiple shooting, increasing; each stage starts from the result of the one before")
      .key("horizon", &FitSection::horizon, horizon(),
           "segment length of the last stage: the whole trial, the longest that the initial-state uncertainty allows, "
           "or seconds")
      .key("starts", &FitSection::starts, whole_number<int>(1, 10000),
           "number of starting points; the first is the model's values")
      .key("loss", &FitSection::loss, text_of({"huber", "squared"}), "loss function of the residuals")
      .key("loss_scale", &FitSection::loss_scale, number("1").above(0.0),
           "residuals beyond this many standard deviations count linearly (huber)")
      .key("max_iterations", &FitSection::max_iterations, whole_number<int>(1, 100000),
           "limit of iterations in one stage from one starting point")
      .check({"segments"}, check_segments);
}

Table<NoiseSection> noise_keys() {
  return Table<NoiseSection>()
      .key("process", &NoiseSection::process, map_of("ELEMENT", number("N*m or N").at_least(0.0)),
           "standard deviation of a random force or torque that the model does not contain, as in \"joint.hinge\" = "
           "0.004")
      .key("process_correlation_time", &NoiseSection::process_correlation_time, number("s").at_least(0.0),
           "correlation time of this force; 0: white noise, a new value each step");
}

Table<Experiment> experiment_keys() {
  const Table<Experiment> head =
      Table<Experiment>()
          .required("name", &Experiment::name, element_name(), "name of the experiment; its database is NAME.db")
          .key("seed", &Experiment::seed, whole_number<std::uint64_t>(0, kLargest), "seed of all random numbers")
          .key("passes", &Experiment::passes, whole_number<int>(1, 1000000),
               "number of passes of a run: one estimation and one exploration phase each")
          .key("replicates", &Experiment::replicates, whole_number<int>(1, 1000000),
               "number of replicates: the whole run is repeated with other random numbers");
  return Table<Experiment>()
      .section("experiment", head, "Name and seed of the experiment.", true)
      .required("target", &Experiment::target, target_keys().value(), "The system to be identified.")
      .required("model", &Experiment::model, model_keys().value(), "The model to fit.")
      .key<EngineSection>(
          "engine", engine_section_keys().value(), {},
          [](Experiment& experiment, EngineSection&& read) {
            experiment.engine = read.settings;
            ContactValues of_target = read.contact;
            experiment.target.simulated.system.set.merge(of_target);  // what the target sets itself stays
            experiment.model.set.merge(read.contact);
          },
          "Integration of the model.")
      .key("test", &Experiment::test, test_keys().value(), "Tests for a target that takes tests.")
      .key("estimation", &Experiment::estimation, estimation_keys().value(),
           "How `lacuna run` evolves models that explain all trials so far.")
      .key("exploration", &Experiment::exploration, exploration_keys().value(),
           "How `lacuna run` evolves the next test.")
      .key("fit", &Experiment::fit, fit_keys().value(), "Fit of the free values.")
      .key("noise", &Experiment::noise, noise_keys().value(), "Declared random disturbances.")
      .key("sweep", &Experiment::sweep, swept_keys(),
           "Keys of this file that `lacuna plan` varies, in all combinations, as in \"engine.step\" = [0.001, 0.002]; "
           "other commands ignore this section.")
      .check({}, check_contact);
}

}  // namespace lacuna
