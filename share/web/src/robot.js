// The robot from the links of its URDF; the head turns by two rotations about axes that the run tells.
import * as THREE from 'three';
import { CAMERA } from './look.js';

const SIDES = 24;

function geometryOf({ kind, size }) {
  if (kind === 'box') return new THREE.BoxGeometry(size[0], size[1], size[2]);
  if (kind === 'sphere') return new THREE.SphereGeometry(size[0], SIDES, SIDES / 2);
  return new THREE.CylinderGeometry(size[0], size[0], size[1], SIDES).rotateX(Math.PI / 2);
}

function turned(axis) {
  const pivot = new THREE.Group();
  const back = new THREE.Group();
  if (axis) {
    pivot.position.set(...axis.p);
    back.position.set(-axis.p[0], -axis.p[1], -axis.p[2]);
  }
  pivot.add(back);
  return { pivot, back, axis: new THREE.Vector3(...(axis ? axis.axis : [0, 0, 1])) };
}

export class Robot {
  constructor(model) {
    this.object = new THREE.Group();
    this.pan = turned(model.pan);
    this.tilt = turned(model.tilt);
    this.object.add(this.pan.pivot);
    this.pan.back.add(this.tilt.pivot);
    const parts = { body: this.object, pan: this.pan.back, tilt: this.tilt.back };
    for (const link of model.links) {
      for (const shape of link.shapes) {
        const material = new THREE.MeshStandardMaterial({ color: new THREE.Color().setRGB(...shape.rgb, THREE.SRGBColorSpace), roughness: 0.6 });
        const mesh = new THREE.Mesh(geometryOf(shape), material);
        mesh.position.set(shape.pose[0], shape.pose[1], shape.pose[2]);
        mesh.quaternion.set(shape.pose[3], shape.pose[4], shape.pose[5], shape.pose[6]);
        parts[link.part].add(mesh);
      }
    }
    this.frustum = this.makeFrustum(model);
    this.tilt.back.add(this.frustum);
  }

  /** What the camera sees, to 1.2 m; optical frame, z forward. */
  makeFrustum({ camera, view }) {
    const far = 1.2;
    const [x, y] = [(view[0] / 2) * far, (view[1] / 2) * far];
    const corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
    const points = [];
    const faces = [];
    corners.forEach(([u, v], i) => {
      const [p, q] = corners[(i + 1) % 4];
      points.push(0, 0, 0, u, v, far, u, v, far, p, q, far);
      faces.push(0, 0, 0, u, v, far, p, q, far);
    });
    const geometry = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
    const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: CAMERA.colour, transparent: true, opacity: 0.7 }));
    lines.position.set(camera[0], camera[1], camera[2]);
    lines.quaternion.set(camera[3], camera[4], camera[5], camera[6]);
    const sides = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(faces, 3));
    const glass = { color: CAMERA.colour, transparent: true, opacity: 0.12, side: THREE.DoubleSide, depthWrite: false };
    lines.add(new THREE.Mesh(sides, new THREE.MeshBasicMaterial(glass)));
    return lines;
  }

  set(pose) {
    const [x, y, yaw] = pose.p;
    this.object.position.set(x, y, 0);
    this.object.rotation.set(0, 0, yaw);
    this.pan.pivot.quaternion.setFromAxisAngle(this.pan.axis, pose.head[0]);
    this.tilt.pivot.quaternion.setFromAxisAngle(this.tilt.axis, pose.head[1]);
  }
}
