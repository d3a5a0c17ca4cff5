#pragma once

#include "diagnosis/noise/force_responses.h"
#include "diagnosis/noise/linear_segments.h"
#include "kernels/dense.h"

#include <functional>
#include <vector>

namespace lacuna {

/// One independent source of noise.
struct NoiseComponent {
  enum class Kind { sensor, slow_sensor, force, slow_force, doubt };
  Kind kind = Kind::sensor;
  std::size_t index = 0;  ///< channel of the noise list, or joint of the force responses
  /// Sensors: multiples of the problem's scale; forces: N·m or N, mean over a pulse; doubt: multiples of what was
  /// found.
  double deviation = 0.0;
};

inline constexpr double kSlowSensor = 0.05;  ///< s, correlation time of slow sensor noise
inline constexpr double kSlowForce = 0.25;   ///< s, correlation time of a slow random force

/// Residuals of a right model as a sum of independent Gaussian noises: sensor noise, white and slow, of each channel,
/// and random force, white and slow, on each joint, passed through the model; where a prediction is known to be
/// doubtful (contact_doubt.h), the doubts themselves, each of a random size, and slow noise that is as large where they
/// are; both at least as large as was found. Segments are independent.
class NoiseModel {
 public:
  /// `doubts`: by segment, bins × any number, in units of the problem's scales; empty: none.
  NoiseModel(const RowBins& bins, const ForceResponses& forces, const std::vector<Eigen::MatrixXd>& doubts = {});

  const std::vector<NoiseComponent>& components() const { return components_; }
  std::vector<double> deviations() const;
  void set_deviations(const std::vector<double>& deviations);
  /// The deviation at which a component disturbs the readings as much as white sensor noise of scale 1 does.
  const std::vector<double>& sizes() const { return sizes_; }

  /// Least deviations, of what is declared to be there: 0, but for random forces that an experiment file states.
  const std::vector<double>& least() const { return least_; }
  void require_force(std::size_t joint, double deviation);

  /// Bins × bins.
  Eigen::MatrixXd covariance(std::size_t k) const;
  /// Its lower half, for a factor, into `sum`; what stands above the diagonal is left as it is.
  void lower_covariance(std::size_t k, Eigen::MatrixXd& sum) const;
  std::size_t segments() const { return segments_.size(); }
  /// Derivatives of tr(weights · covariance) by the logarithms of the deviations; `weights`: bins × bins, symmetric, of
  /// which the lower half is read.
  Eigen::VectorXd slopes(std::size_t k, const Eigen::MatrixXd& weights) const;

 private:
  using Component = std::size_t;  ///< place in `components_`
  /// A covariance at deviation 1, column by column of one component: channels do not disturb each other, so that the
  /// slow noises of all sensors are one matrix.
  struct Shape {
    Eigen::MatrixXd covariance;
    std::vector<Component> of;  ///< each column
  };
  struct Segment {
    Eigen::VectorXd white;             ///< variances of white sensor noise
    std::vector<Component> sensor_of;  ///< each bin
    std::vector<Shape> shapes;
  };

  double variance(Component component) const;
  Segment segment(const std::vector<RowBins::Bin>& bins) const;
  /// By component, at deviation 1, summed up over the bins of all segments.
  std::vector<double> power() const;

  std::vector<NoiseComponent> components_;
  std::vector<double> sizes_;
  std::vector<double> least_;
  std::vector<Segment> segments_;
};

/// Writes the lower half of a covariance.
using LowerCovariance = std::function<void(Eigen::MatrixXd& sum)>;

/// The lower Cholesky factor of a covariance; where one noise is so much larger than the others that these are its
/// rounding, of the covariance with a little white noise more. Not every matrix has one: see `exists()`. `storage`: a
/// matrix that is no longer needed, of any size.
dense::Cholesky factor_of(const LowerCovariance& covariance, Eigen::MatrixXd storage = {});

/// Sets the deviations of `noise` to those, from the least on, that maximise the marginal likelihood: what the start
/// states, the model's values and `columns` explain is left to them, so that a structured error that a candidate would
/// explain does not pass for noise. This is the restricted likelihood (REML), but that each direction explained is, a
/// priori, no larger than the whole residual: a flat prior would allow any noise that many columns can explain away
/// where few segments were measured. `columns`: by segment, bins × any number.
///
/// Literature: H. D. Patterson and R. Thompson, Biometrika 58 (1971) 545-554; D. A. Harville, JASA 72 (1977) 320-338.
void estimate_noise(NoiseModel& noise, const std::vector<LinearSegment>& segments,
                    const std::vector<Eigen::MatrixXd>& columns, int threads);

}  // namespace lacuna
