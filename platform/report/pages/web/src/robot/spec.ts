// A robot as table `revision` and the replays have it (storage/core/canonical_text.cpp). SI units; x forward, y left, z up.
export type Three = [number, number, number];
/** w, x, y, z */
export type Four = [number, number, number, number];

export const enum ShapeKind {
  box,
  sphere,
  capsule,
  cylinder,
}
export const enum JointKind {
  hinge,
  slider,
  fixed,
  ball,
  universal,
}
export const enum SensorKind {
  jointPosition = 0,
  touch = 3,
}

export interface Shape {
  kind: ShapeKind;
  size: Three;
  position: Three;
  orientation: Four;
}

export interface Body {
  name: string;
  com: Three;
  position: Three;
  orientation: Four;
  shapes: Shape[];
}

export interface Joint {
  name: string;
  kind: JointKind;
  parent: string;
  child: string;
  anchor: Three;
  axis: Three;
  axis2: Three;
}

export interface Sensor {
  name: string;
  kind: number;
  element: string;
  offset: number;
  scale: number;
}

export interface Robot {
  name: string;
  bodies: Body[];
  joints: Joint[];
  sensors: Sensor[];
  contact: { ground: boolean; slope: number };
}

/** How the bodies of a robot moved: 7 numbers a frame and body, x, y, z and the quaternion w, x, y, z. */
export interface Motion {
  times: Float64Array;
  bodies: string[];
  poses: Float64Array;
}
