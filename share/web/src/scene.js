// The scene: camera, light, layers, picking. Draws only when something has changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Layers } from './layers.js';
import { themed } from './look.js';

const FIELD = 45; // degrees
const CLICK = 5; // pixels that a click may slip
const FLIGHT = 350; // ms from one view to another
const EAST = new THREE.Vector3(1, 0, 0);

/** What draws into a canvas; undefined where there is no WebGL 2. */
export function contextOf(canvas) {
  const context = canvas.getContext('webgl2', { antialias: true, alpha: false });
  return context && !context.isContextLost() ? context : undefined;
}

export class Scene {
  /** told.pick(what) when something is clicked, told.name(what) for what the pointer is over. */
  constructor(canvas, context, told) {
    this.canvas = canvas;
    this.told = told;
    this.renderer = new THREE.WebGLRenderer({ canvas, context });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(FIELD, 1, 0.1, 200);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(-6, -8, 9);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = 0.49 * Math.PI;
    this.controls.minDistance = 0.6;
    this.controls.maxDistance = 60;
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => (this.flight = undefined));
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(-3, -5, 8);
    this.world.add(new THREE.HemisphereLight(0xffffff, 0x8a8f98, 1.6), sun);
    this.layers = new Layers(this.world);
    this.following = false;
    this.covered = { left: 0, right: 0, bottom: 0 }; // pixels that legend and drawer hide
    this.listen();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.restyle();
    this.resize();
  }

  listen() {
    let down = null;
    this.canvas.addEventListener('pointerdown', (event) => (down = [event.clientX, event.clientY]));
    this.canvas.addEventListener('pointerup', (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > CLICK) return;
      const what = this.at(event);
      this.told.pick(what);
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (event.buttons !== 0) return;
      const what = this.at(event);
      this.canvas.style.cursor = what ? 'pointer' : 'grab';
      this.canvas.title = what ? this.told.name(what) : '';
    });
  }

  /** What is under the pointer, the nearest. */
  at(event) {
    const box = this.canvas.getBoundingClientRect();
    const pointer = new THREE.Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(pointer, this.camera);
    return ray.intersectObjects(this.layers.handles(), false)[0]?.object.userData.what;
  }

  /** Where a place of the map is on the page [pixels]; for tests and for the keyboard. */
  onPage(p) {
    const v = new THREE.Vector3(...p).project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return [box.left + ((v.x + 1) / 2) * box.width, box.top + ((1 - v.y) / 2) * box.height];
  }

  begin(start) {
    this.layers.begin(start);
    this.resize();
    this.look('fit');
  }

  look(from) {
    const [west, south, east, north] = this.layers.floor?.bounds() ?? [-3, -3, 3, 3];
    const middle = new THREE.Vector3((west + east) / 2, (south + north) / 2, 0);
    const half = Math.tan((FIELD / 2) * (Math.PI / 180));
    const slant = from === 'top' ? 1 : 0.86;
    const aspect = this.camera.aspect * (1 - (this.covered.left + this.covered.right) / this.canvas.clientWidth);
    const lies = this.camera.aspect < 1 === east - west > north - south; // the long side of the place along that of the picture
    const [wide, deep] = lies ? [north - south, east - west] : [east - west, north - south];
    const distance = Math.max(deep * slant, wide / aspect) / 2 / half + (from === 'top' ? 1.6 : 2.2);
    const away = from === 'top' ? new THREE.Vector3(0, -0.001, distance) : new THREE.Vector3(0, -0.56 * distance, 0.83 * distance);
    if (lies) away.applyAxisAngle(this.camera.up, -Math.PI / 2);
    this.flyTo(middle, middle.clone().add(away));
  }

  goTo([x, y, z]) {
    const target = new THREE.Vector3(x, y, z ?? 0);
    const away = this.camera.position.clone().sub(this.controls.target);
    away.setLength(Math.min(away.length(), 4.5));
    this.flyTo(target, target.clone().add(away));
  }

  /** There at once for those who want no motion, else within FLIGHT. */
  flyTo(target, position) {
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const from = { target: this.controls.target.clone(), position: this.camera.position.clone() };
    this.flight = { from, to: { target, position }, begun: still || !this.flown ? -Infinity : performance.now() };
    this.flown = true;
    this.fly();
  }

  fly() {
    if (!this.flight) return;
    const { from, to, begun } = this.flight;
    const part = Math.min(1, (performance.now() - begun) / FLIGHT);
    const eased = part * part * (3 - 2 * part);
    this.controls.target.lerpVectors(from.target, to.target, eased);
    this.camera.position.lerpVectors(from.position, to.position, eased);
    if (part >= 1) this.flight = undefined;
    this.controls.update();
    this.draw();
  }

  /** Round what is looked at [radians]. */
  turn(right, up) {
    const away = new THREE.Spherical().setFromVector3(this.seenFrom().applyAxisAngle(EAST, -Math.PI / 2));
    away.theta += right;
    away.phi = Math.min(this.controls.maxPolarAngle, Math.max(0.001, away.phi - up));
    this.standAt(new THREE.Vector3().setFromSpherical(away).applyAxisAngle(EAST, Math.PI / 2));
  }

  /** Along the floor, by a part of the distance. */
  shift(right, up) {
    const away = this.seenFrom();
    const ahead = new THREE.Vector3(-away.x, -away.y, 0).normalize();
    const aside = new THREE.Vector3().crossVectors(ahead, this.camera.up);
    const step = 0.08 * away.length();
    this.controls.target.addScaledVector(ahead, up * step).addScaledVector(aside, right * step);
    this.standAt(away);
  }

  approach(factor) { this.standAt(this.seenFrom().multiplyScalar(factor)); }

  seenFrom() { return this.camera.position.clone().sub(this.controls.target); }
  standAt(away) {
    this.flight = undefined;
    this.camera.position.copy(this.controls.target).add(away);
    this.controls.update();
    this.draw();
  }

  /** Some of { left, right, bottom } are covered so far [pixels]: what is looked at stays in the middle of the rest. */
  leaveFree(covered) {
    if (Object.entries(covered).every(([side, pixels]) => this.covered[side] === pixels)) return;
    Object.assign(this.covered, covered);
    this.resize();
  }

  update(state) {
    if (this.following && state.pose) {
      const [x, y] = state.pose.p;
      const move = new THREE.Vector3(x, y, 0.4).sub(this.controls.target);
      this.controls.target.add(move);
      this.camera.position.add(move);
      this.controls.update();
    }
    this.layers.update(state);
    this.draw();
  }

  restyle() {
    this.world.background = new THREE.Color(themed('sky'));
    this.layers.restyle();
    this.draw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const { left, right, bottom } = this.covered;
    this.camera.setViewOffset(width, height, (right - left) / 2, bottom / 2, width, height);
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.fly();
      this.renderer.render(this.world, this.camera);
    });
  }
}
