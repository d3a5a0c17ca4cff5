#include "simulation/ode/world.h"

#include "simulation/ode/session.h"

#include <mutex>
#include <vector>

namespace lacuna::ode {
namespace {

/// Threading implementations that can never be freed, kept where leak checkers find them.
void keep_for_ever(dThreadingImplementationID threading) {
  static std::mutex mutex;
  static auto* kept = new std::vector<dThreadingImplementationID>;
  const std::lock_guard lock(mutex);
  kept->push_back(threading);
}

}  // namespace

World::World() {
  join_session();
  threading_ = dThreadingAllocateSelfThreadedImplementation();
  id_ = dWorldCreate();
  dWorldSetStepThreadingImplementation(id_, dThreadingImplementationGetFunctions(threading_), threading_);
  dWorldSetAutoDisableFlag(id_, 0);
}

World::~World() {
  dWorldDestroy(id_);
  if (failed_)
    keep_for_ever(threading_);
  else
    dThreadingFreeImplementation(threading_);
}

void World::reserve(std::size_t bodies, std::size_t joints, std::size_t rows) {
  // A step needs a few matrices of rows × rows and rows × 16, and some hundred bytes per body and joint.
  const std::size_t padded = rows + 8;
  const std::size_t bytes = 65536 + sizeof(dReal) * (3 * padded * padded + 96 * padded) + 1024 * (bodies + joints);
  dWorldStepReserveInfo info{};
  info.struct_size = sizeof(info);
  info.reserve_factor = 1.2F;
  info.reserve_minimum = static_cast<unsigned>(bytes);
  dWorldSetStepMemoryReservationPolicy(id_, &info);
}

}  // namespace lacuna::ode
