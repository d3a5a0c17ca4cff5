// A cart with a pole on MuJoCo as a target of Lacuna: lacuna-process/2 on standard input and output.

#include "cart_pole.h"

#include <nlohmann/json.hpp>

#include <exception>
#include <iostream>
#include <string>

namespace mujoco_cart_pole {
namespace {

using Json = nlohmann::json;

void say(const Json& message) { std::cout << message.dump() << std::endl; }

Json hello() {
  return {{"type", "hello"},
          {"protocol", "lacuna-process/2"},
          {"name", "MuJoCo cart-pole"},
          {"modes", {"series", "exchange"}},
          {"sensors",
           {{{"name", "position"}, {"unit", "m"}, {"noise", kPositionNoise}},
            {{"name", "angle"}, {"unit", "rad"}, {"noise", kAngleNoise}}}},
          {"actuators", {{{"name", "motor"}, {"unit", "N"}, {"lower", -kForceLimit}, {"upper", kForceLimit}}}}};
}

Json at_rest() {
  const Json joint = {{"position", 0.0}, {"velocity", 0.0}};
  return {{"rail", joint}, {"hinge", joint}};
}

Json row(const Reading& reading) { return {reading.position, reading.angle}; }

/// All commands are known before it moves.
void run_series(const Json& test, CartPole& cart_pole) {
  const double period = test["period"];
  const Json& commands = test["commands"];
  Json times = Json::array({0.0}), samples = Json::array({row(cart_pole.read())});
  std::size_t place = 0;
  for (int k = 0; k < test["periods"]; ++k) {
    while (place + 1 < commands["times"].size() && commands["times"][place + 1] <= k * period + 1e-9) ++place;
    cart_pole.advance(commands["samples"][place][0], period);
    times.push_back((k + 1) * period);
    samples.push_back(row(cart_pole.read()));
  }
  say({{"type", "samples"}, {"id", test["id"]}, {"times", times}, {"samples", samples}, {"start", at_rest()}});
}

/// A command for each period, made from the readings before it.
void run_exchange(const Json& test, CartPole& cart_pole) {
  const double period = test["period"];
  say({{"type", "readings"},
       {"id", test["id"]},
       {"time", 0.0},
       {"sensors", row(cart_pole.read())},
       {"start", at_rest()}});
  std::string line;
  for (int k = 0; k < test["periods"] && std::getline(std::cin, line); ++k) {
    cart_pole.advance(Json::parse(line)["commands"][0], period);
    say({{"type", "readings"}, {"id", test["id"]}, {"time", (k + 1) * period}, {"sensors", row(cart_pole.read())}});
  }
}

void serve() {
  CartPole cart_pole;
  for (std::string line; std::getline(std::cin, line);) {
    const Json message = Json::parse(line);
    if (message["type"] == "hello") {
      say(hello());
      continue;
    }
    cart_pole.reset(message["seed"]);
    if (message["mode"] == "series")
      run_series(message, cart_pole);
    else
      run_exchange(message, cart_pole);
  }
}

}  // namespace
}  // namespace mujoco_cart_pole

int main() {
  try {
    mujoco_cart_pole::serve();
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
