#pragma once

#include "foundation/processes/guarded_call.h"

#include <lacuna/test.h>

namespace lacuna {

/// The test with a controller, if it has one, whose calls are known to be of that component: a parent process names it
/// where one of them ends the program.
Test with_named_controller(Test test, const ComponentOrigin& origin);

}  // namespace lacuna
