#include "app/runs/run_summary.h"

#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/unit.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

std::string fact_line(const std::string& head, const std::string& text) {
  return fmt::format("{:<10}{}\n", head, plain_text(text));
}

std::string target_line(const OpenEeaRun& opened) {
  const ModelDefinition& target = *opened.target();
  return fact_line("target",
                   fmt::format("simulated {}, {}, {}, hidden values {}", target.structure.robot.name,
                               counted(target.free.size(), "hidden value"), counted(target.effects.size(), "effect"),
                               opened.opened().experiment.target.simulated.redraw == Redraw::never
                                   ? "the same in every replicate"
                                   : "drawn again for each replicate"));
}

}  // namespace

std::string run_summary(const OpenEeaRun& opened) {
  const EeaDefinition& definition = opened.definition();
  const Experiment& experiment = opened.opened().experiment;
  std::string text;
  if (opened.target()) text += target_line(opened);
  if (const std::optional<Hello> hello = ask_target(opened)) text += fact_line("target", target_summary(*hello));
  if (opened.takes_tests())
    text += fact_line("test", fmt::format("{}, {}, {}", definition.test_encoding.origin.name,
                                          counted(definition.exploration.layout().size(), "gene"),
                                          format_quantity(experiment.test.duration, "s")));
  text += fact_line("estimate",
                    fmt::format("{}, {}, {}", definition.estimation.strategy.origin.name,
                                counted(definition.estimation.layout().size(), "gene"), definition.metric.origin.name));
  if (!opened.takes_tests()) return text;
  text +=
      fact_line("explore", fmt::format("{}, {}", definition.exploration.strategy.origin.name, definition.value.name()));
  return text + fact_line("run", fmt::format("{}, {}", counted(static_cast<std::size_t>(definition.passes), "pass"),
                                             counted(static_cast<std::size_t>(experiment.replicates), "replicate")));
}

}  // namespace lacuna
