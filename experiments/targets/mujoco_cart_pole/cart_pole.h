#pragma once

#include <memory>
#include <random>

struct mjModel_;
struct mjData_;

namespace mujoco_cart_pole {

/// What its sensors say.
struct Reading {
  double position = 0.0;  ///< of the cart, m
  double angle = 0.0;     ///< of the pole, rad; 0 hangs
};

inline constexpr double kForceLimit = 6.0;      ///< N, of the motor
inline constexpr double kPositionNoise = 1e-3;  ///< m, standard deviation
inline constexpr double kAngleNoise = 2e-3;     ///< rad

/// A cart with a hanging pole, integrated by MuJoCo. What a model of it without friction lacks is the dry friction of
/// the cart on its rail.
class CartPole {
 public:
  CartPole();
  ~CartPole();
  CartPole(const CartPole&) = delete;
  CartPole& operator=(const CartPole&) = delete;

  /// At rest at 0; `seed` is of the sensors' noise.
  void reset(unsigned long long seed);
  /// With a constant force on the cart, N.
  void advance(double force, double seconds);
  Reading read();

 private:
  mjModel_* model_ = nullptr;
  mjData_* data_ = nullptr;
  std::mt19937_64 noise_;
};

}  // namespace mujoco_cart_pole
