#include "effects/held_delay.h"
#include "effects/joint_compliance.h"
#include "effects/load_friction.h"
#include "effects/lugre.h"
#include "effects/payload.h"

#include <lacuna/plugin.h>

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::HeldDelay>("test_held_delay"),
              lacuna::component<lacuna::PhysicalEffect, lacuna::LuGre>("test_lugre"),
              lacuna::component<lacuna::PhysicalEffect, lacuna::JointCompliance>("test_joint_compliance"),
              lacuna::component<lacuna::PhysicalEffect, lacuna::LoadFriction>("test_load_friction"),
              lacuna::component<lacuna::PhysicalEffect, lacuna::Payload>("test_payload"))
