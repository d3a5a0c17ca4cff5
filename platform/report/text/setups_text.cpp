#include "report/text/setups_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {

std::string setups_text(const std::vector<KnownSetup>& setups) {
  std::string text;
  if (!any_is_set(setups)) return text;
  for (const KnownSetup& setup : setups)
    text += fmt::format("{}: {} · {}\n", setup.name().empty() ? "no setup" : "setup " + setup.name(),
                        settings_text(setup), fmt::join(setup.recordings, ", "));
  return text;
}

}  // namespace lacuna
