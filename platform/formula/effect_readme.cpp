#include "formula/effect_source.h"

#include "foundation/placement_unit.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

constexpr const char* kReadme = R"(# @NAME@

A force on a joint that depends on its position q and velocity v@COMMAND@, written from a formula:

    tau = @EQUATION@
    @FORMULA@

Terms with a slope are integrated implicitly where they damp or hold, terms with `sgn(v)` are dry friction.

| parameter | unit | default | lower | upper | meaning |
| --- | --- | --- | --- | --- | --- |
@TABLE@
- Place it on @PLACES@; several in one `where` share one set of values.
- It shows in motion like that in which the formula was found.
- At @NEUTRAL@ it changes nothing.

```toml
[model]
file = "robots/servo-pendulum.toml"
effects = [
  { id = "@NAME@", effect = "@NAME@", where = "@WHERE@" },
]
```

Say here where the formula comes from: the recordings, the diagnosis, the literature.
)";

}  // namespace

std::string effect_readme(const std::string& name, const ForceLaw& law) {
  std::string table;
  std::vector<std::string> neutral;
  for (const LawParameter& p : law.parameters) {
    table += fmt::format("| `{}` | {} | {:g} | {:g} | {:g} | {} |\n", p.name, unit_in_words(p.unit), p.default_value,
                         p.lower, p.upper, p.description);
    if (p.neutral == 0.0) neutral.push_back("`" + p.name + " = 0`");
  }
  return filled(kReadme, {{"COMMAND", law.uses_command ? ", and on its actuator's command u" : ""},
                          {"EQUATION", law.equation()},
                          {"FORMULA", law.text},
                          {"NAME", name},
                          {"NEUTRAL", fmt::format("{}", fmt::join(neutral, " and "))},
                          {"PLACES", law.uses_command ? "actuators" : "hinges and sliders"},
                          {"TABLE", table},
                          {"WHERE", law.uses_command ? "actuator.motor" : "joint.hinge"}});
}

}  // namespace lacuna
