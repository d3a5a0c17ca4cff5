import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Trace } from '../data/trace';
import { JointKind, SensorKind, type Four, type Joint, type Motion, type Robot, type Three } from './spec';

const kPose = 7;
const kFrames = 1500; // more than a screen shows apart

/** Poses as they were simulated: channels `body.x` ... `body.qz`. */
export function motionOf(trace: Trace): Motion {
  const count = trace.channels.length / kPose;
  const bodies = Array.from({ length: count }, (_, b) => trace.channels[b * kPose].name.replace(/\.x$/, ''));
  const poses = new Float64Array(trace.times.length * trace.channels.length);
  trace.values.forEach((column, c) =>
    column.forEach((value, row) => {
      poses[row * trace.values.length + c] = value;
    }),
  );
  return { times: trace.times, bodies, poses };
}

const vector = (of: Three) => new Vector3(...of);
const quaternion = ([w, x, y, z]: Four) => new Quaternion(x, y, z, w);
const pose = (position: Three, orientation: Four) =>
  new Matrix4().compose(vector(position), quaternion(orientation), new Vector3(1, 1, 1));

/** What a joint does to its child, in the world of the zero configuration. */
function jointMotion(joint: Joint, q: number[]): Matrix4 {
  const axis = vector(joint.axis);
  if (joint.kind === JointKind.slider) return new Matrix4().makeTranslation(axis.multiplyScalar(q[0]));
  const turn = new Matrix4();
  if (joint.kind === JointKind.hinge) turn.makeRotationAxis(axis, q[0]);
  if (joint.kind === JointKind.universal)
    turn.makeRotationAxis(axis, q[0]).multiply(new Matrix4().makeRotationAxis(vector(joint.axis2), q[1]));
  if (joint.kind === JointKind.ball) {
    const by = new Vector3(q[0], q[1], q[2]);
    const angle = by.length();
    if (angle > 0) turn.makeRotationAxis(by.normalize(), angle);
  }
  const anchor = vector(joint.anchor);
  return new Matrix4().makeTranslation(anchor).multiply(turn).multiply(new Matrix4().makeTranslation(anchor.negate()));
}

const kCoordinates: Record<number, number> = {
  [JointKind.hinge]: 1,
  [JointKind.slider]: 1,
  [JointKind.fixed]: 0,
  [JointKind.ball]: 3,
  [JointKind.universal]: 2,
};

/** Columns of a trace that read the coordinates of a joint; null where it has no sensor. */
function columnsOf(
  robot: Robot,
  joint: Joint,
  trace: Trace,
): { values: Float64Array; scale: number; offset: number }[] | null {
  const wanted = kCoordinates[joint.kind];
  if (wanted === 0) return [];
  const sensor = robot.sensors.find(
    (one) =>
      one.kind === SensorKind.jointPosition &&
      one.element === joint.name &&
      trace.channels.some((channel) => channel.name === one.name || channel.name.startsWith(`${one.name}.`)),
  );
  if (!sensor) return null;
  const columns = trace.channels
    .map((channel, i) => ({ channel, i }))
    .filter(({ channel }) => channel.name === sensor.name || channel.name.startsWith(`${sensor.name}.`))
    .map(({ i }) => ({ values: trace.values[i], scale: sensor.scale || 1, offset: sensor.offset }));
  return columns.length === wanted ? columns : null;
}

/** The poses that readings of joint positions stand for. Null: some joint is not read, or a body floats. */
export function motionFromReadings(robot: Robot, trace: Trace): Motion | null {
  const columns = new Map<string, NonNullable<ReturnType<typeof columnsOf>>>();
  for (const joint of robot.joints) {
    const own = columnsOf(robot, joint, trace);
    if (!own) return null;
    columns.set(joint.child, own);
  }
  if (robot.bodies.some((body) => !columns.has(body.name))) return null;
  const rest = new Map(robot.bodies.map((body) => [body.name, pose(body.position, body.orientation)]));
  const held = new Map(robot.joints.map((joint) => [joint.child, joint]));
  const stride = Math.max(1, Math.floor(trace.times.length / kFrames));
  const frames = Math.ceil(trace.times.length / stride);
  const motion: Motion = {
    times: new Float64Array(frames),
    bodies: robot.bodies.map((one) => one.name),
    poses: new Float64Array(frames * robot.bodies.length * kPose),
  };
  // A body is where its joint chain carries its rest pose: each joint turns what hangs on it about its rest axis.
  const carried = (name: string, row: number): Matrix4 => {
    const joint = held.get(name)!;
    const q = columns.get(name)!.map((one) => (one.values[row] - one.offset) / one.scale);
    const own = jointMotion(
      joint,
      q.map((one) => (Number.isFinite(one) ? one : 0)),
    );
    return held.has(joint.parent) ? carried(joint.parent, row).multiply(own) : own;
  };
  const [place, turn, size] = [new Vector3(), new Quaternion(), new Vector3()];
  for (let frame = 0; frame < frames; ++frame) {
    motion.times[frame] = trace.times[frame * stride];
    robot.bodies.forEach((body, b) => {
      carried(body.name, frame * stride)
        .multiply(rest.get(body.name)!)
        .decompose(place, turn, size);
      motion.poses.set(
        [place.x, place.y, place.z, turn.w, turn.x, turn.y, turn.z],
        (frame * robot.bodies.length + b) * kPose,
      );
    });
  }
  return motion;
}
