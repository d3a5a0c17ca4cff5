#include "config/experiment_reader.h"

namespace lacuna {

Experiment read_experiment(const std::filesystem::path& file, const std::vector<std::string>&) {
  throw Error(file.string() + ": reading experiments is not built yet");
}

}  // namespace lacuna
