#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/target_system.h>

namespace lacuna {

/// A target that is another program, which states the tests that it can carry out.
class Process : public TargetSystem {
 public:
  std::string summary() const override;
  bool takes_tests() const override { return true; }
  /// The trials of the host's `ExternalProgram`. Throws `Error` where there is none.
  Trial carry_out(const Test& test, const TargetServices& services) override;
};

std::string Process::summary() const { return "An outside program, such as a rig's driver or another simulator"; }

Trial Process::carry_out(const Test& test, const TargetServices& services) {
  if (services.program == nullptr)
    throw Error("there is no program to carry out the test; give a command under [target]");
  return services.program->carry_out(test);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TargetSystem, lacuna::Process>("process"))
