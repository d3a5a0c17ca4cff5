#pragma once

#include <ode/ode.h>

#include <memory>

namespace lacuna::ode {

/// An ODE world with a threading implementation of its own; without that, worlds stepped in
/// separate threads abort the process. Used by one thread at a time.
class World {
 public:
  World();
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  dWorldID id() const { return id_; }
  /// After an exception out of a step: the threading holds jobs that will never be done, and ODE
  /// ends the process if it is freed. It stays allocated (some kB) when the world goes.
  void mark_failed() { failed_ = true; }
  /// Asks ODE to keep memory for steps with this many bodies and constraint rows, so that a step
  /// that meets more contacts than those before it does not allocate.
  void reserve(std::size_t bodies, std::size_t joints, std::size_t rows);

 private:
  dThreadingImplementationID threading_;
  dWorldID id_;
  bool failed_ = false;
};

}  // namespace lacuna::ode
