#include "evaluation/named_controller.h"

#include "foundation/processes/process_watch.h"

#include <lacuna/error.h>

#include <string>
#include <utility>

namespace lacuna {
namespace {

class NamedController : public Controller {
 public:
  NamedController(std::shared_ptr<const Controller> controller, const char* component)
      : controller_(std::move(controller)), component_(component) {}

  int state_size() const override {
    const PluginCall call(component_, "its controller's state_size");
    const int size = controller_->state_size();
    check("its controller's state_size");
    return size;
  }
  void act(double time, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override {
    const PluginCall call(component_, "its controller's act");
    controller_->act(time, sensors, state, commands);
    check("its controller's act");
  }

 private:
  void check(const char* call) const {
    try {
      throw_if_arithmetic_changed(call);
    } catch (const ProcessChanged& change) {
      throw Error(std::string(component_) + ": " + change.what());
    }
  }

  std::shared_ptr<const Controller> controller_;  // shared with the test's creator
  const char* component_;
};

}  // namespace

Test with_named_controller(Test test, const ComponentOrigin& origin) {
  auto* const controller = std::get_if<std::shared_ptr<const Controller>>(&test.drive);
  if (controller != nullptr && *controller != nullptr)
    *controller = std::make_shared<NamedController>(std::move(*controller), on_page(origin));
  return test;
}

}  // namespace lacuna
