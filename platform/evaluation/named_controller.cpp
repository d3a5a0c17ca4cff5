#include "evaluation/named_controller.h"

#include <utility>

namespace lacuna {
namespace {

class NamedController : public Controller {
 public:
  NamedController(std::shared_ptr<const Controller> controller, const char* component)
      : controller_(std::move(controller)), component_(component) {}

  int state_size() const override {
    const PluginCall call(component_, "its controller's state_size");
    return controller_->state_size();
  }
  void act(double time, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override {
    const PluginCall call(component_, "its controller's act");
    controller_->act(time, sensors, state, commands);
  }

 private:
  std::shared_ptr<const Controller> controller_;  // shared with whoever made the test
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
