// Any bytes are either read or refused with located problems: no crash, no hang, no other exception.
// The first byte chooses the reader; the rest is the file.

#include "config/edits/effects_editor.h"
#include "config/experiment_reader.h"
#include "config/robots/robot_reader.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

const std::string kFile = LACUNA_SOURCE_DIRECTORY "/tests/config/good/fuzzed.toml";  // names are resolved beside it

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

void require_located(const lacuna::BadInput& bad) {
  require(!bad.problems().empty(), "bad input has a problem");
  for (const lacuna::Problem& problem : bad.problems()) {
    require(!problem.location.file.empty(), "a problem has a file");
    require(!problem.message.empty(), "a problem has a message");
  }
}

void read_experiment(const std::string& text) {
  try {
    const lacuna::Experiment experiment = lacuna::read_experiment_text(text, kFile);
    require(experiment.engine.step > 0.0, "an experiment that is read keeps its bounds");
    for (const lacuna::FreeRange& range : experiment.model.free)
      require(range.lower < range.upper, "ranges that are read are in order");
  } catch (const lacuna::BadInput& bad) {
    require_located(bad);
  }
}

void read_override(const std::string& text) {
  static const std::string kExperiment =
      "[experiment]\nname = \"x\"\n[target]\nfiles = [\"sine.csv\"]\n"
      "[model]\nrobot = \"r\"\neffects = [{ effect = \"e\" }]\n";
  try {
    lacuna::read_experiment_text(kExperiment, kFile, {text});
  } catch (const lacuna::BadInput& bad) {
    require_located(bad);
  }
}

void read_robot(const std::string& text) {
  try {
    const lacuna::RobotSpec robot = lacuna::read_robot_text(text, kFile);
    require(!robot.bodies.empty(), "a robot that is read has bodies");
    for (const lacuna::BodySpec& body : robot.bodies) require(body.mass > 0.0, "bodies that are read have mass");
  } catch (const lacuna::BadInput& bad) {
    require_located(bad);
  }
}

void edit_effects(const std::string& text) {
  try {
    const std::string inserted = lacuna::insert_effect(text, {"fuzzed_id", "effect", {"joint.a"}, {{"p", 0.5}}, {}});
    lacuna::remove_effect(inserted, "fuzzed_id");
  } catch (const lacuna::Error&) {
    // refused: the text, or its layout
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0: read_experiment(text); break;
    case 1: read_robot(text); break;
    case 2: edit_effects(text); break;
    default: read_override(text); break;
  }
  return 0;
}
