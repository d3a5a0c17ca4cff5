#pragma once

#include "foundation/processes/stop.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace lacuna {

struct PageServerOptions {
  std::filesystem::path database;
  std::filesystem::path pages;  ///< a `PageDatabase`'s file; others may be made beside it
  std::string host = "127.0.0.1";
  int port = 0;  ///< 0: the system chooses
  /// Has the robots of that trial simulated, into `pages`, unless they are there; returns their key there. Called by
  /// one thread at a time, not that of `run`.
  std::function<std::int64_t(std::int64_t run, std::int64_t trial)> prepare_replay;
  /// Of one processor, for what all viewers together ask by themselves when the database has changed: they are told so
  /// late enough.
  double processor_share = 0.02;
  Stop stop = {};  ///< ends questions to the database early
};

/// Hands out the pages and answers their questions about a database, which it reads only. Whoever asks must have the
/// token that is part of the address, call this machine by a name of its own, and be no other site's page. What is at
/// hand (pages, whether the database has changed) is answered at once; what has to be searched for waits its turn in
/// bounded queues: what a user typed in another one than what pages show.
class PageServer {
 public:
  /// Takes the port; throws `Error` where it is taken.
  explicit PageServer(PageServerOptions options);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  int port() const;
  /// What a browser opens, token included.
  std::string address() const;
  /// Answers until `stop`, which another thread calls, before or after.
  void run();
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lacuna
