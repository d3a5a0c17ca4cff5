import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  EdgesGeometry,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { colourNow } from '../kit/colours';
import { sampleAt } from '../kit/decimate';
import { ShapeKind, type Body, type Motion, type Robot, type Shape, type Three } from './spec';

const kPose = 7;

/** A robot on the stage; `touching` tells which bodies touch the ground at a time. */
export interface Actor {
  robot: Robot;
  motion: Motion;
  colour: 'predicted' | 'measured';
  opacity: number;
  touching?: (body: string, time: number) => boolean;
}

function geometryOf(shape: Shape): BufferGeometry {
  const [a, b, c] = shape.size;
  switch (shape.kind) {
    case ShapeKind.box:
      return new BoxGeometry(a, b, c);
    case ShapeKind.sphere:
      return new SphereGeometry(a, 20, 14);
    case ShapeKind.capsule:
      return new CapsuleGeometry(a, b, 6, 16).rotateX(Math.PI / 2); // along z
    default:
      return new CylinderGeometry(a, a, b, 24).rotateX(Math.PI / 2);
  }
}

/** A rod from one point to another, in the body's frame. */
function rod(from: Vector3, to: Vector3, radius: number): BufferGeometry {
  const along = to.clone().sub(from);
  const geometry = new CylinderGeometry(radius, radius, along.length(), 12);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.clone().normalize()));
  const middle = from.clone().add(to).multiplyScalar(0.5);
  return geometry.translate(middle.x, middle.y, middle.z);
}

/** A robot's typical length, m. */
export function sizeOf(robot: Robot): number {
  const points = robot.bodies
    .flatMap((body) => [body.position, body.com.map((one, i) => one + body.position[i]) as Three])
    .concat(robot.joints.map((one) => one.anchor));
  const shapes = robot.bodies.flatMap((body) => body.shapes.map((shape) => Math.max(...shape.size)));
  const spread = [0, 1, 2].map(
    (axis) => Math.max(...points.map((one) => one[axis])) - Math.min(...points.map((one) => one[axis])),
  );
  return Math.max(...spread, ...shapes, 0.05);
}

/** Shapes of a body; one without any is rods from its joints to its centre of mass. */
function geometriesOf(robot: Robot, body: Body, size: number): BufferGeometry[] {
  if (body.shapes.length > 0) {
    return body.shapes.map((shape) => {
      const [w, x, y, z] = shape.orientation;
      return geometryOf(shape)
        .applyQuaternion(new Quaternion(x, y, z, w))
        .translate(...shape.position);
    });
  }
  const [w, x, y, z] = body.orientation;
  const into = (point: Three) =>
    new Vector3(...point).sub(new Vector3(...body.position)).applyQuaternion(new Quaternion(x, y, z, w).invert());
  const com = new Vector3(...body.com);
  const anchors = robot.joints
    .filter((one) => one.child === body.name || one.parent === body.name)
    .map((one) => into(one.anchor));
  const ball = new SphereGeometry(0.09 * size, 20, 14).translate(com.x, com.y, com.z);
  return [ball, ...anchors.filter((one) => one.distanceTo(com) > 1e-6).map((one) => rod(one, com, 0.03 * size))];
}

/** A square of lines to see motion against: the ground where there is one, else a level below the robot. */
function gridOf(size: number, robot: Robot): LineSegments {
  const cell = 10 ** Math.round(Math.log10(size / 3)),
    count = 24;
  const points: Vector3[] = [];
  const at = (i: number, k: number) => new Vector3(i * cell, k * cell, 0);
  // Cell by cell: a line that passes behind the camera is not drawn by every browser.
  for (let i = -count; i <= count; ++i)
    for (let k = -count; k < count; ++k) points.push(at(i, k), at(i, k + 1), at(k, i), at(k + 1, i));
  const grid = new LineSegments(new BufferGeometry().setFromPoints(points), new LineBasicMaterial());
  if (robot.contact.ground) grid.rotation.y = robot.contact.slope;
  else grid.position.z = Math.min(...robot.bodies.map((one) => one.position[2] + Math.min(one.com[2], 0))) - size;
  return grid;
}

class ShownRobot {
  readonly group = new Group();
  private readonly bodies: { group: Group; material: MeshLambertMaterial }[];

  constructor(
    private readonly actor: Actor,
    size: number,
  ) {
    this.bodies = actor.motion.bodies.map((name) => {
      const body = actor.robot.bodies.find((one) => one.name === name)!;
      const group = new Group();
      const material = new MeshLambertMaterial({
        transparent: true,
        opacity: actor.opacity,
        depthWrite: actor.opacity > 0.5,
      });
      const edges = new LineBasicMaterial({ transparent: true, opacity: 0.6 });
      material.userData.edges = edges;
      for (const geometry of geometriesOf(actor.robot, body, size)) {
        group.add(new Mesh(geometry, material));
        group.add(new LineSegments(new EdgesGeometry(geometry, 30), edges));
      }
      this.group.add(group);
      return { group, material };
    });
  }

  paint(): void {
    const colour = new Color(colourNow(this.actor.colour));
    for (const { material } of this.bodies) {
      material.color.copy(colour);
      (material.userData.edges as LineBasicMaterial).color.copy(colour);
    }
  }

  /** Between two frames a pose is their mean by time. */
  show(time: number): void {
    const { times, poses } = this.actor.motion;
    const next = Math.min(Math.max(sampleAt(times, time), 1), times.length - 1),
      last = Math.max(next - 1, 0);
    const share = next === last ? 0 : Math.min(Math.max((time - times[last]) / (times[next] - times[last]), 0), 1);
    const width = this.bodies.length * kPose;
    const [a, b, p, q] = [new Vector3(), new Vector3(), new Quaternion(), new Quaternion()];
    this.bodies.forEach(({ group, material }, i) => {
      const read = (frame: number, place: Vector3, turn: Quaternion) => {
        const at = frame * width + i * kPose;
        place.set(poses[at], poses[at + 1], poses[at + 2]);
        turn.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
      };
      read(last, a, p);
      read(next, b, q);
      group.position.lerpVectors(a, b, share);
      group.quaternion.slerpQuaternions(p, q, share);
      const touches = this.actor.touching?.(this.actor.motion.bodies[i], time) ?? false;
      material.emissive.set(touches ? 0xc4500a : 0x000000);
    });
  }

  centre(): Vector3 {
    const sum = new Vector3();
    for (const { group } of this.bodies) sum.add(group.position);
    return sum.divideScalar(Math.max(this.bodies.length, 1));
  }
}

/** Robots in three dimensions, with a camera that follows the first. Throws where the browser has no WebGL. */
export class Stage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(35, 1, 0.01, 200);
  private readonly controls: OrbitControls;
  private readonly robots: ShownRobot[];
  private readonly grid: LineSegments;
  private asked = false;

  constructor(
    private readonly host: HTMLElement,
    actors: Actor[],
  ) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    host.append(this.renderer.domElement);
    const size = Math.max(...actors.map((one) => sizeOf(one.robot)));
    this.robots = actors.map((actor) => new ShownRobot(actor, size));
    this.scene.add(...this.robots.map((one) => one.group), new HemisphereLight(0xffffff, 0x889099, 2.2));
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 5);
    this.scene.add(sun);
    this.grid = gridOf(size, actors[0].robot);
    this.scene.add(this.grid);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.draw());
    this.show(actors[0].motion.times[0]);
    this.lookAt(size);
    this.paint();
  }

  private lookAt(size: number): void {
    const centre = this.robots[0].centre();
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).add(new Vector3(1.6, -3.4, 1.5).multiplyScalar(size));
    this.controls.update();
  }

  /** In the colours that the page has now. */
  paint(): void {
    for (const robot of this.robots) robot.paint();
    (this.grid.material as LineBasicMaterial).color.set(colourNow('line'));
    this.draw();
  }

  show(time: number): void {
    const before = this.robots[0].centre();
    for (const robot of this.robots) robot.show(time);
    const moved = this.robots[0].centre().sub(before);
    if (this.robots[0].group.userData.placed) {
      this.camera.position.add(moved);
      this.controls.target.add(moved);
      this.controls.update();
    }
    this.robots[0].group.userData.placed = true;
    this.draw();
  }

  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  private draw(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.renderer.render(this.scene, this.camera);
    });
  }

  dispose(): void {
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }
}
