#pragma once

#include "foundation/processes/guarded_call.h"

#include <lacuna/test.h>

namespace lacuna {

/// The test with a controller, if it has one, whose calls are attributed to that component: if one of them ends the
/// program, the parent process names the component.
Test with_named_controller(Test test, const ComponentOrigin& origin);

}  // namespace lacuna
