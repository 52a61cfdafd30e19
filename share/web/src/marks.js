// Marks of the scene: letters that face the viewer, lines, triangles, cylinders, boxes. Map frame, z up.
import * as THREE from 'three';
import { inkOn } from './look.js';

const letters = new Map();

function letterTexture(letter, colour) {
  const key = letter + colour;
  if (letters.has(key)) return letters.get(key);
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext('2d');
  pen.fillStyle = colour;
  pen.strokeStyle = '#fff';
  pen.lineWidth = 4;
  pen.beginPath();
  pen.arc(32, 32, 28, 0, 7);
  pen.fill();
  pen.stroke();
  pen.fillStyle = inkOn(colour);
  pen.font = 'bold 36px system-ui, sans-serif';
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.fillText(letter, 32, 34);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  letters.set(key, texture);
  return texture;
}

export function letterAt(look, [x, y, z], size = 0.032, centre = [0.5, 0.5]) {
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map: letterTexture(look.letter, look.colour), depthTest: false, sizeAttenuation: false }));
  sprite.scale.set(size, size, 1);
  sprite.center.set(...centre);
  sprite.position.set(x, y, z);
  sprite.renderOrder = 10;
  return sprite;
}

/** A name on a plate, which keeps its size on the screen. */
export function plateAt(text, [x, y, z], size = 0.03) {
  const canvas = document.createElement('canvas');
  const pen = canvas.getContext('2d');
  const font = '600 30px system-ui, sans-serif';
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + 32;
  canvas.height = 52;
  pen.font = font; // a canvas that was resized has forgotten it
  pen.fillStyle = '#0b0f14e0';
  pen.roundRect(0, 0, canvas.width, canvas.height, 14);
  pen.fill();
  pen.fillStyle = '#ffffff';
  pen.textBaseline = 'middle';
  pen.fillText(text, 16, 28);
  const map = new THREE.CanvasTexture(canvas);
  map.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map, depthTest: false, sizeAttenuation: false }));
  sprite.scale.set((size * canvas.width) / canvas.height, size, 1);
  sprite.center.set(0.5, -2.0);
  sprite.position.set(x, y, z);
  sprite.renderOrder = 11;
  sprite.userData.own = true;
  return sprite;
}

export function lineThrough(points, height, colour, opacity = 1) {
  const flat = points.flatMap(([x, y]) => [x, y, height]);
  const geometry = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(flat, 3));
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({ color: colour, transparent: opacity < 1, opacity }));
}

/** A way as a ribbon on the floor, which is seen better than a line of one pixel. */
export function ribbonThrough(points, height, width, colour, opacity = 1) {
  const flat = [];
  for (let i = 1; i < points.length; ++i) {
    const [ax, ay] = points[i - 1];
    const [bx, by] = points[i];
    const length = Math.hypot(bx - ax, by - ay);
    if (length < 1e-4) continue;
    const [nx, ny] = [(-(by - ay) / length) * (width / 2), ((bx - ax) / length) * (width / 2)];
    const corners = [[ax + nx, ay + ny], [ax - nx, ay - ny], [bx - nx, by - ny], [bx + nx, by + ny]];
    for (const k of [0, 1, 2, 0, 2, 3]) flat.push(corners[k][0], corners[k][1], height);
  }
  const geometry = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(flat, 3));
  const material = new THREE.MeshBasicMaterial({ color: colour, side: THREE.DoubleSide, transparent: true, opacity, depthWrite: false });
  return new THREE.Mesh(geometry, material);
}

export function triangle(view, colour, filled) {
  const [x, y, yaw] = view.p;
  const side = view.height / Math.cos(view.angle / 2);
  const corner = (turn) => [x + side * Math.cos(yaw + turn), y + side * Math.sin(yaw + turn)];
  const corners = [[x, y], corner(-view.angle / 2), corner(view.angle / 2)];
  const group = new THREE.Group();
  group.add(lineThrough([...corners, corners[0]], 0.03, colour, filled ? 0.9 : 0.45));
  const geometry = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(corners.flatMap(([u, v]) => [u, v, 0.02]), 3));
  const opacity = filled ? 0.22 : 0.05;
  group.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: colour, transparent: true, opacity, side: THREE.DoubleSide, depthWrite: false })));
  return group;
}

export function cylinder(region, colour, strong) {
  const [low, high] = region.z;
  const height = Math.max(0.05, high - low);
  const geometry = new THREE.CylinderGeometry(region.radius, region.radius, height, 32, 1, true).rotateX(Math.PI / 2);
  const material = new THREE.MeshBasicMaterial({ color: colour, transparent: true, opacity: strong ? 0.5 : 0.22, side: THREE.DoubleSide, depthWrite: false });
  const group = new THREE.Group();
  group.add(new THREE.Mesh(geometry, material));
  const ring = Array.from({ length: 49 }, (_, i) => [region.radius * Math.cos((i * Math.PI) / 24), region.radius * Math.sin((i * Math.PI) / 24)]);
  for (const z of [-height / 2, height / 2]) group.add(lineThrough(ring, z, colour));
  group.position.set(region.p[0], region.p[1], (low + high) / 2);
  return group;
}

export function box(segment, colour) {
  const geometry = new THREE.BoxGeometry(...segment.size.map((length) => Math.max(0.01, length)));
  const group = new THREE.Group();
  group.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry), new THREE.LineBasicMaterial({ color: colour })));
  group.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.35, depthWrite: false })));
  group.position.set(...segment.p);
  group.rotation.z = segment.yaw;
  return group;
}

/** What can be clicked: an invisible ball that is large enough for a finger. */
export function handle([x, y, z], radius, what) {
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(radius, 8, 6), new THREE.MeshBasicMaterial({ colorWrite: false, depthWrite: false }));
  mesh.position.set(x, y, z);
  mesh.userData.what = what;
  return mesh;
}

export function dispose(group) {
  group.traverse((node) => {
    node.geometry?.dispose();
    if (node.userData.own) node.material.map.dispose();
    if (node.material && (node.userData.own || !node.material.map)) node.material.dispose();
  });
  group.clear();
}
