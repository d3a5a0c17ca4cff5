#include "config/file_references.h"

#include "config/schema/experiment_schema.h"
#include "config/schema/reference.h"
#include "config/schema/robot_file.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

constexpr const char* kNumbers =
    "Write a number in the SI unit of its row, or a text with any unit of the same dimension: `0.12`, `\"120 mm\"`, "
    "`\"3 deg\"`,\n`\"35.15065 N/V\"`. Units are written with `*`, `/` and `^`; `m`, `kg`, `s`, `A`, `N`, `V`, `W`, "
    "`J`, "
    "`Pa`, `Hz`, `Ohm`, `rad`, `deg`, `rev`,\n`rpm`, `min`, `h`, `%`, `in`, `ft`, `lb`, `oz`, `lbf`, `ozf`, `kip`, "
    "`kgf`, `psi` and SI prefixes are known. \"N*m or N\": N*m on a hinge, N on a slider.\n";

const ReferenceHead& experiment_head() {
  static const ReferenceHead kHead{
      "Experiment files",
      "An experiment file is TOML. `lacuna check FILE` reports all problems at once, each with its line; an "
      "unknown "
      "key is one.\n`--set key=value` overrides a value of the file: `--set engine.step=0.0005`, "
      "`--set 'model.effects[0].start.torque=1'`.\nPaths are relative to the file that contains them; "
      "`${NAME}` in a path stands for an environment variable.\nEditors can use "
      "[experiment.schema.json](experiment.schema.json).\n\n" +
          std::string(kNumbers),
      "lacuna check --print-reference experiment.md"};
  return kHead;
}

const ReferenceHead& robot_head() {
  static const ReferenceHead kHead{
      "Robot files",
      "A robot file is TOML; `[model] file = \"robot.toml\"` in an experiment names it. A value's address is where it "
      "stands: `mass` in\n`[body.arm]` is `body.arm.mass`. The world's z points up, x forward, y left. Poses are those "
      "of "
      "the zero configuration, in which every\njoint position is zero. "
      "Editors can use [robot.schema.json](robot.schema.json).\n\n" +
          std::string(kNumbers) +
          "\nMass, centre of mass and inertia follow from the shapes where a body does not give them: either each "
          "shape has a "
          "mass or density,\nor the body has a mass, which is then spread evenly over their volume.\n",
      "lacuna check --print-reference robot.md"};
  return kHead;
}

}  // namespace

std::vector<std::string> file_reference_names() {
  return {"experiment.md", "experiment.schema.json", "robot.md", "robot.schema.json"};
}

std::string file_reference(const std::string& name) {
  if (name == "experiment.md") return markdown_reference(experiment_keys().value().shape, experiment_head());
  if (name == "experiment.schema.json") return json_schema(experiment_keys().value().shape, "Lacuna experiment file");
  if (name == "robot.md") return markdown_reference(robot_keys().value().shape, robot_head());
  if (name == "robot.schema.json") return json_schema(robot_keys().value().shape, "Lacuna robot file");
  throw Error("there is no reference called " + name);
}

}  // namespace lacuna
