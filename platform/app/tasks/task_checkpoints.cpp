#include "app/tasks/task_checkpoints.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

namespace lacuna {

TaskCheckpoints::TaskCheckpoints(const TaskFolder& folder, std::size_t number, std::filesystem::path database,
                                 std::chrono::milliseconds between)
    : keeping_([&folder, number, database = std::move(database), between](const std::stop_token& stop) {
        std::mutex unused;
        std::unique_lock lock(unused);
        std::condition_variable_any until;
        while (!until.wait_for(lock, stop, between, [&] { return stop.stop_requested(); })) try {
            folder.keep_checkpoint(number, database);
          } catch (const std::exception&) {
            // A failure to write is reported when the task hands in its results.
          }
      }) {}

}  // namespace lacuna
