#include "builtin_types.h"

#include <array>
#include <utility>

namespace lacuna::rosbag2 {
namespace {

using Definition = std::pair<std::string_view, std::string_view>;

constexpr std::string_view kControllerState = "control_msgs/JointTrajectoryControllerState";

constexpr std::array kDefinitions = {
    Definition{"builtin_interfaces/Time", "int32 sec\nuint32 nanosec"},
    Definition{"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec"},
    Definition{"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id"},
    Definition{"std_msgs/Bool", "bool data"},
    Definition{"std_msgs/Int32", "int32 data"},
    Definition{"std_msgs/Int64", "int64 data"},
    Definition{"std_msgs/Float32", "float32 data"},
    Definition{"std_msgs/Float64", "float64 data"},
    Definition{"std_msgs/String", "string data"},
    Definition{"std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride"},
    Definition{"std_msgs/MultiArrayLayout", "MultiArrayDimension[] dim\nuint32 data_offset"},
    Definition{"std_msgs/Float32MultiArray", "MultiArrayLayout layout\nfloat32[] data"},
    Definition{"std_msgs/Float64MultiArray", "MultiArrayLayout layout\nfloat64[] data"},
    Definition{"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z"},
    Definition{"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z"},
    Definition{"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w"},
    Definition{"geometry_msgs/Pose", "Point position\nQuaternion orientation"},
    Definition{"geometry_msgs/Twist", "Vector3 linear\nVector3 angular"},
    Definition{"geometry_msgs/Accel", "Vector3 linear\nVector3 angular"},
    Definition{"geometry_msgs/Wrench", "Vector3 force\nVector3 torque"},
    Definition{"geometry_msgs/Transform", "Vector3 translation\nQuaternion rotation"},
    Definition{"geometry_msgs/Vector3Stamped", "std_msgs/Header header\nVector3 vector"},
    Definition{"geometry_msgs/PointStamped", "std_msgs/Header header\nPoint point"},
    Definition{"geometry_msgs/PoseStamped", "std_msgs/Header header\nPose pose"},
    Definition{"geometry_msgs/TwistStamped", "std_msgs/Header header\nTwist twist"},
    Definition{"geometry_msgs/AccelStamped", "std_msgs/Header header\nAccel accel"},
    Definition{"geometry_msgs/WrenchStamped", "std_msgs/Header header\nWrench wrench"},
    Definition{"geometry_msgs/TransformStamped", "std_msgs/Header header\nstring child_frame_id\nTransform transform"},
    Definition{"geometry_msgs/PoseWithCovariance", "Pose pose\nfloat64[36] covariance"},
    Definition{"geometry_msgs/TwistWithCovariance", "Twist twist\nfloat64[36] covariance"},
    Definition{"nav_msgs/Odometry",
               "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
               "geometry_msgs/TwistWithCovariance twist"},
    Definition{"sensor_msgs/JointState",
               "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort"},
    Definition{"sensor_msgs/Imu",
               "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
               "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
               "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance"},
    Definition{"trajectory_msgs/JointTrajectoryPoint",
               "float64[] positions\nfloat64[] velocities\nfloat64[] accelerations\nfloat64[] effort\n"
               "builtin_interfaces/Duration time_from_start"},
    Definition{"trajectory_msgs/JointTrajectory",
               "std_msgs/Header header\nstring[] joint_names\nJointTrajectoryPoint[] points"},
    Definition{"trajectory_msgs/MultiDOFJointTrajectoryPoint",
               "geometry_msgs/Transform[] transforms\ngeometry_msgs/Twist[] velocities\n"
               "geometry_msgs/Twist[] accelerations\nbuiltin_interfaces/Duration time_from_start"},
    // Its versions before 4.1, from 4.1 and from 5.0 of its package.
    Definition{kControllerState,
               "std_msgs/Header header\nstring[] joint_names\ntrajectory_msgs/JointTrajectoryPoint desired\n"
               "trajectory_msgs/JointTrajectoryPoint actual\ntrajectory_msgs/JointTrajectoryPoint error"},
    Definition{kControllerState,
               "std_msgs/Header header\nstring[] joint_names\ntrajectory_msgs/JointTrajectoryPoint reference\n"
               "trajectory_msgs/JointTrajectoryPoint feedback\ntrajectory_msgs/JointTrajectoryPoint error\n"
               "trajectory_msgs/JointTrajectoryPoint output\ntrajectory_msgs/JointTrajectoryPoint desired\n"
               "trajectory_msgs/JointTrajectoryPoint actual\nstring[] multi_dof_joint_names\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_reference\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_feedback\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_output\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_desired\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_actual"},
    Definition{kControllerState,
               "std_msgs/Header header\nstring[] joint_names\ntrajectory_msgs/JointTrajectoryPoint reference\n"
               "trajectory_msgs/JointTrajectoryPoint feedback\ntrajectory_msgs/JointTrajectoryPoint error\n"
               "trajectory_msgs/JointTrajectoryPoint output\nstring[] multi_dof_joint_names\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_reference\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_feedback\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error\n"
               "trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_output\nfloat64 speed_scaling_factor"},
};

}  // namespace

std::vector<std::string_view> builtin_definitions(const std::string& name) {
  std::vector<std::string_view> found;
  for (const auto& [type, definition] : kDefinitions)
    if (type == name) found.push_back(definition);
  return found;
}

}  // namespace lacuna::rosbag2
