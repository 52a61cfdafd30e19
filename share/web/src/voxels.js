// Voxels as lit cubes: only faces that can be seen, coloured by height, with the edges of every voxel and darker corners.
import * as THREE from 'three';
import { cubes } from './cubes.js';
import { voxelsOf } from './store.js';

const TOP = 1.6; // m: from here on the colour stays

const vertex = `
  attribute vec4 corner;
  uniform float resolution;
  uniform vec3 first;
  varying vec3 cell, normal_in_map;
  varying float open_sky;
  void main() {
    float direction = floor(corner.w / 4.0);
    float axis = floor(direction / 2.0);
    float sign_of = 2.0 * mod(direction, 2.0) - 1.0;
    normal_in_map = sign_of * vec3(axis == 0.0, axis == 1.0, axis == 2.0);
    open_sky = mod(corner.w, 4.0) / 3.0;
    cell = corner.xyz + first;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(resolution * cell, 1.0);
  }`;
// Light comes from above, the left and the front, so that the three sides that are seen of a cube differ.
const fragment = `
  uniform float opacity, resolution;
  uniform vec3 low, high;
  varying vec3 cell, normal_in_map;
  varying float open_sky;
  void main() {
    vec3 voxel = floor(cell - 0.5 * normal_in_map + 0.001);
    float grain = fract(sin(dot(voxel, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
    vec3 tint = mix(low, high, clamp((voxel.z + 0.5) * resolution / ${TOP.toFixed(1)}, 0.0, 1.0)) * (0.95 + 0.09 * grain);
    float lit = 0.74 + dot(normal_in_map, vec3(-0.05, -0.12, 0.24)) + 0.07 * abs(normal_in_map.y);
    vec3 to_edge = abs(fract(cell + 0.5) - 0.5) + abs(normal_in_map);
    float edge = min(to_edge.x, min(to_edge.y, to_edge.z));
    vec3 across = fwidth(cell) * (1.0 - abs(normal_in_map));
    float pixel = max(across.x, max(across.y, across.z));
    float line = (1.0 - smoothstep(0.025, 0.025 + pixel, edge)) * (1.0 - smoothstep(0.08, 0.3, pixel));
    gl_FragColor = vec4(tint * lit * (0.55 + 0.45 * open_sky) * (1.0 - 0.3 * line), opacity);
    #include <colorspace_fragment>
  }`;

export class Voxels {
  /** front: how far before others in the same place it is drawn, behind them if negative. */
  constructor({ low = '#888', high = low, opacity = 1, order = 0, front = 0 }) {
    this.uniforms = {
      resolution: { value: 0.05 }, first: { value: new THREE.Vector3() }, opacity: { value: opacity },
      low: { value: new THREE.Color(low) }, high: { value: new THREE.Color(high) },
    };
    this.order = order;
    this.front = front;
    this.upTo = Infinity;
    this.object = new THREE.Group();
    if (opacity < 1) {
      this.add({ colorWrite: false, transparent: true }); // first the depth: behind a face no other one shines through
      this.add({ transparent: true, depthFunc: THREE.EqualDepth });
    } else {
      this.add({});
    }
  }

  add(more) {
    const material = new THREE.ShaderMaterial({
      vertexShader: vertex, fragmentShader: fragment, uniforms: this.uniforms,
      polygonOffset: this.front !== 0, polygonOffsetFactor: -this.front, polygonOffsetUnits: -4 * this.front, ...more,
    });
    const mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
    mesh.frustumCulled = false;
    mesh.renderOrder = this.order + 0.1 * this.object.children.length;
    this.object.add(mesh);
  }

  setText(base64, resolution) { this.set(base64 ? voxelsOf(base64) : [], resolution); }

  /** Triplets of indices. */
  set(indices, resolution) {
    this.indices = indices;
    this.uniforms.resolution.value = resolution;
    this.build();
  }

  /** Nothing above that height [m] is drawn. */
  cut(upTo) {
    if (this.upTo === upTo) return;
    this.upTo = upTo;
    this.build();
  }

  build() {
    if (!this.indices) return;
    const { low, corners, triangles } = cubes(this.below());
    for (const mesh of this.object.children) mesh.geometry.dispose();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('corner', new THREE.Int16BufferAttribute(corners, 4));
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    for (const mesh of this.object.children) mesh.geometry = geometry;
    this.uniforms.first.value.set(...low);
    this.object.visible = triangles.length > 0;
  }

  below() {
    const top = this.upTo / this.uniforms.resolution.value;
    if (!Number.isFinite(top)) return this.indices;
    const kept = [];
    for (let i = 0; i < this.indices.length; i += 3) {
      if (this.indices[i + 2] + 0.5 < top) kept.push(this.indices[i], this.indices[i + 1], this.indices[i + 2]);
    }
    return kept;
  }

  colours(low, high) {
    this.uniforms.low.value.set(low);
    this.uniforms.high.value.set(high);
  }
}
