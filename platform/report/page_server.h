#pragma once

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
  int port = 0;         ///< 0: the system chooses
  std::string token{};  ///< that every question must carry; empty: none, for this machine alone
  /// Has the robots of that trial simulated, into `pages`, unless they are there; returns their key there. Called by
  /// several threads.
  std::function<std::int64_t(std::int64_t run, std::int64_t trial)> prepare_replay;
  /// Of one processor, for what all viewers together ask by themselves when the database has changed: they are told so
  /// late enough.
  double processor_share = 0.02;
};

/// Hands out the pages and answers their questions about a database, which it reads only. Without a token it answers
/// only to names of this machine, so that no other site's page can ask it by a name of its own.
class PageServer {
 public:
  /// Takes the port; throws `Error` where it is taken.
  explicit PageServer(PageServerOptions options);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  int port() const { return port_; }
  std::string address() const;
  /// Answers until `stop`, which another thread calls.
  void run();
  void stop();

 private:
  struct Impl;
  PageServerOptions options_;
  std::unique_ptr<Impl> impl_;
  int port_ = 0;
};

}  // namespace lacuna
