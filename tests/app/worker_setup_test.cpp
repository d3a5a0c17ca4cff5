#include "app/runs/worker_setup.h"

#include "support/small_experiment.h"
#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <fstream>
#include <memory>

namespace lacuna {
namespace {

TEST(WorkerBench, IsRefusedWhereAFileIsNotTheHosts) {
  const TestFolder folder;
  const std::filesystem::path file = folder.path() / "small.toml";
  const std::string text =
      small_experiment("0.2", "population = 4, keep = 2, generations = 2", "population = 4, keep = 2, generations = 2");
  std::ofstream(file) << text;
  WorkerTask task;
  task.experiment = file;
  task.text = text;
  task.files = {std::string(64, '0')};
  EXPECT_THAT([&] { open_worker_run(task); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("has changed since the run began")));
}

}  // namespace
}  // namespace lacuna
