#pragma once

#include <ode/ode.h>

#include <memory>

namespace lacuna::ode {

/// An ODE world with its own threading implementation; without that, worlds stepped in separate threads abort the
/// process. Used by one thread at a time.
class World {
 public:
  World();
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  dWorldID id() const { return id_; }
  /// After an exception in a step: the threading holds jobs that will never be done, and ODE ends the process if it is
  /// freed. It stays allocated (some kB) when the world is destroyed.
  void mark_failed() { failed_ = true; }
  /// Makes ODE reserve memory for steps with this many bodies and constraint rows, so that a step with more contacts
  /// than before does not allocate.
  void reserve(std::size_t bodies, std::size_t joints, std::size_t rows);

 private:
  dThreadingImplementationID threading_;
  dWorldID id_;
  bool failed_ = false;
};

}  // namespace lacuna::ode
