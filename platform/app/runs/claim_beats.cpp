#include "app/runs/claim_beats.h"

#include "storage/core/run_claim.h"

#include <chrono>
#include <condition_variable>
#include <exception>

namespace lacuna {
namespace {

void beat(Database& database, std::mutex& writing) {
  const std::lock_guard lock(writing);
  try {
    beat_claims(database);
  } catch (const std::exception&) {
    // The next commit reports that the file cannot be written.
  }
}

}  // namespace

ClaimBeats::ClaimBeats(Database& database, std::mutex& writing)
    : beating_([&database, &writing](const std::stop_token& stop) {
        std::mutex unused;
        std::unique_lock lock(unused);
        const std::chrono::duration<double> pause(kBetweenBeats);
        for (std::condition_variable_any until;
             !until.wait_for(lock, stop, pause, [&] { return stop.stop_requested(); });)
          beat(database, writing);
      }) {}

}  // namespace lacuna
