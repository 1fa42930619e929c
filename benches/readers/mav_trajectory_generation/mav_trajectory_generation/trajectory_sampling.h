// Stands for the library's header of the same name, which needs messages of ROS; reading files needs none of it.
#pragma once
#include "mav_trajectory_generation/trajectory.h"

namespace mav_msgs {
struct EigenTrajectoryPoint {
  typedef std::vector<EigenTrajectoryPoint> Vector;
  Eigen::Vector3d position_W, velocity_W, acceleration_W, jerk_W, snap_W, angular_velocity_W, angular_acceleration_W;
  Eigen::Quaterniond orientation_W_B;
  int64_t time_from_start_ns;
  double getYaw() const { return 0; }
  double getYawRate() const { return 0; }
  double getYawAcc() const { return 0; }
};
}  // namespace mav_msgs

namespace mav_trajectory_generation {
inline bool sampleWholeTrajectory(const Trajectory&, double, mav_msgs::EigenTrajectoryPoint::Vector*) { return false; }
}  // namespace mav_trajectory_generation
