// Voxels as square points with darker edges: as fast as points, and read as blocks. Colour by height or one colour.
import * as THREE from 'three';
import { voxelsOf } from './store.js';

const vertex = `
  uniform float size, scale, opacity;
  uniform vec3 low, high;
  varying vec3 tint;
  void main() {
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * seen;
    gl_PointSize = max(1.5, size * scale / -seen.z);
    float grain = fract(sin(dot(floor(position * 20.0), vec3(12.9898, 78.233, 37.719))) * 43758.5453);
    tint = mix(low, high, clamp(position.z / 1.6, 0.0, 1.0)) * (0.93 + 0.12 * grain);
  }`;
const fragment = `
  uniform float opacity;
  varying vec3 tint;
  void main() {
    vec2 edge = abs(gl_PointCoord - 0.5);
    float shade = max(edge.x, edge.y) > 0.43 ? 0.8 : 1.0;
    gl_FragColor = vec4(tint * shade, opacity);
    #include <colorspace_fragment>
  }`;

export class Voxels {
  constructor({ low, high = low, size = 1, opacity = 1, order = 0 }) {
    this.grain = size;
    this.material = new THREE.ShaderMaterial({
      vertexShader: vertex,
      fragmentShader: fragment,
      transparent: opacity < 1,
      depthWrite: opacity >= 1,
      uniforms: {
        size: { value: 0.05 }, scale: { value: 500 }, opacity: { value: opacity },
        low: { value: new THREE.Color(low) }, high: { value: new THREE.Color(high) },
      },
    });
    this.object = new THREE.Points(new THREE.BufferGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
  }

  setText(base64, resolution) { this.set(base64 ? voxelsOf(base64) : [], resolution); }

  /** Triplets of indices. */
  set(indices, resolution) {
    const positions = new Float32Array(indices.length);
    for (let i = 0; i < indices.length; ++i) positions[i] = (indices[i] + 0.5) * resolution;
    this.object.geometry.dispose();
    this.object.geometry = new THREE.BufferGeometry();
    this.object.geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    this.material.uniforms.size.value = resolution * this.grain;
  }

  colours(low, high) {
    this.material.uniforms.low.value.set(low);
    this.material.uniforms.high.value.set(high);
  }
  /** Height of the picture in pixels for one unit at distance one. */
  setScale(scale) { this.material.uniforms.scale.value = scale; }
}
