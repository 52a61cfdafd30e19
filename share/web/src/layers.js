// The layers of the scene, each made anew only when what it shows has changed.
import * as THREE from 'three';
import { Floor } from './floor.js';
import { Robot } from './robot.js';
import { Voxels } from './voxels.js';
import { box, cylinder, dispose, handle, letterAt, plateAt, ribbonThrough, triangle } from './marks.js';
import {
  APPEARED, BODY, CAMERA, FAULT, FLOOR, HIGH, LOW, OBJECT, REFERENCE, REGION, SEGMENT, STOP, TRAIL, VANISHED, VIEW, WALL, WAY,
  colourOf, objectLook,
} from './look.js';

/** Name, what it is called, what is in it, shown at first. */
export const LAYERS = [
  ['floor', 'floor plan', [FLOOR, WALL], true],
  ['reference', 'reference map', [REFERENCE], true],
  ['current', 'map now', [LOW, HIGH], true],
  ['difference', 'difference', [APPEARED, VANISHED], true],
  ['views', 'view triangles', [VIEW.open], true],
  ['path', 'way and plan', [WAY, STOP], true],
  ['trail', 'driven', [TRAIL], true],
  ['regions', 'regions', Object.values(REGION), true],
  ['objects', 'objects', [...Object.values(OBJECT), SEGMENT], true],
  ['touches', 'touches', [FAULT], true],
  ['bodies', 'what moves', [BODY], true],
  ['robot', 'robot', [CAMERA], true],
];

export class Layers {
  constructor(world) {
    this.groups = {};
    this.shown = {};
    for (const [name, , , on] of LAYERS) {
      world.add((this.groups[name] = new THREE.Group()));
      this.groups[name].visible = on;
    }
    this.reference = new Voxels({ opacity: 0.4, order: 1, front: -1 });
    this.current = new Voxels({});
    this.appeared = new Voxels({ low: APPEARED.colour, front: 1 });
    this.vanished = new Voxels({ low: VANISHED.colour, opacity: 0.85, order: 2, front: 1 });
    this.groups.reference.add(this.reference.object);
    this.groups.current.add(this.current.object);
    this.groups.difference.add(this.appeared.object, this.vanished.object);
  }

  begin(start) {
    dispose(this.groups.floor);
    dispose(this.groups.robot);
    this.shown = {};
    this.resolution = start.resolution;
    this.floor = new Floor(start.floor);
    this.groups.floor.add(this.floor.object);
    this.reference.setText(start.reference, start.resolution);
    this.robot = new Robot(start.robot);
    this.groups.robot.add(this.robot.object);
  }

  setVisible(name, on) { this.groups[name].visible = on; }
  /** Nothing of the maps above that height [m] is drawn. */
  cut(upTo) { for (const voxels of [this.reference, this.current, this.appeared, this.vanished]) voxels.cut(upTo); }

  /** In the colours of the theme; ways are drawn anew by the next update. */
  restyle() {
    this.floor?.paint();
    this.reference.colours(colourOf(REFERENCE), colourOf(REFERENCE));
    this.current.colours(colourOf(LOW), colourOf(HIGH));
    for (const name of ['path', 'trail']) delete this.shown[name];
  }

  handles() {
    return ['objects', 'regions'].filter((name) => this.groups[name].visible)
      .flatMap((name) => this.groups[name].children.filter((child) => child.userData.what));
  }

  update(state) {
    if (!this.robot) return;
    if (state.pose) this.robot.set(state.pose);
    this.when('current', state.voxelChanges, () => this.current.set(state.voxels(), this.resolution));
    this.when('difference', state.difference, (difference) => {
      this.appeared.setText(difference?.appeared, this.resolution);
      this.vanished.setText(difference?.vanished, this.resolution);
    });
    this.group('views', state.views, state.views, (add) => {
      for (const view of state.views?.list ?? []) {
        if (view.state !== 'dropped') add(triangle(view, VIEW[view.state].colour, view.state === 'open'));
      }
    });
    this.group('path', `${state.path?.t} ${state.plan?.t} ${state.step?.t}`, true, (add) => this.addPlan(state, add));
    this.group('trail', state.trail?.length, state.trail, (add) => {
      if (state.trail.length > 1) add(ribbonThrough(state.trail, 0.045, 0.03, colourOf(TRAIL), 0.85));
    });
    this.group('touches', state.touches.length, true, (add) => {
      for (const touch of state.touches) add(letterAt(FAULT, touch.p, 0.026));
    });
    this.group('bodies', JSON.stringify(state.bodies.map((body) => body.pose)), true, (add) => {
      for (const body of state.bodies) {
        add(letterAt(BODY, body.pose.slice(0, 3), 0.03));
        add(plateAt(body.name, body.pose.slice(0, 3), 0.018));
      }
    });
    const chosen = state.chosen;
    this.group('regions', `${state.regions?.t} ${chosen?.kind === 'region' && chosen.id}`, state.regions, (add) => this.addRegions(state, add));
    this.group('objects', `${state.objects?.t} ${state.over} ${state.examined.length} ${chosen?.kind}${chosen?.id}`, true, (add) => this.addObjects(state, add));
  }

  when(name, key, act) {
    if (this.shown[name] === key && name in this.shown) return;
    this.shown[name] = key;
    act(key);
  }
  group(name, key, present, fill) {
    this.when(name, key, () => {
      dispose(this.groups[name]);
      if (present) fill((mark) => this.groups[name].add(mark));
    });
  }

  addPlan(state, add) {
    if (state.path && state.path.points.length > 1) add(ribbonThrough(state.path.points, 0.04, 0.05, colourOf(WAY), 0.9));
    const from = state.step && state.plan && state.step.t >= state.plan.t ? state.step.step : 0;
    const visits = (state.plan?.steps ?? []).slice(from).filter((step) => step.action === 'goto');
    if (visits.length) add(ribbonThrough(visits.map((step) => step.p), 0.04, 0.02, colourOf(WAY), 0.55));
    visits.forEach((step, i) => add(letterAt({ ...STOP, letter: String(i + 1) }, [step.p[0], step.p[1], 0.06], 0.022)));
  }

  addRegions(state, add) {
    for (const region of state.regions.list) {
      const look = REGION[region.state];
      const chosen = state.chosen?.kind === 'region' && state.chosen.id === region.id;
      add(cylinder(region, look.colour, chosen));
      add(letterAt(look, [region.p[0], region.p[1], region.z[0]], chosen ? 0.046 : 0.032, [0.5, 1.25]));
      add(handle([region.p[0], region.p[1], (region.z[0] + region.z[1]) / 2], Math.max(0.15, region.radius), { kind: 'region', id: region.id }));
    }
  }

  addObjects(state, add) {
    for (const examined of state.examined) for (const segment of examined.segments) add(box(segment, SEGMENT.colour));
    for (const object of state.objects?.list ?? []) {
      const look = objectLook(object, state.over);
      const [x, y, z] = object.p;
      const top = z + 0.45;
      const chosen = state.chosen?.kind === 'object' && state.chosen.id === object.name;
      const stem = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute([x, y, z, x, y, top], 3));
      add(new THREE.Line(stem, new THREE.LineBasicMaterial({ color: look.colour })));
      add(letterAt(look, [x, y, top], chosen ? 0.056 : 0.042, [0.5, 0.1]));
      if (chosen) add(plateAt(object.name, [x, y, top]));
      add(handle([x, y, top], 0.2, { kind: 'object', id: object.name }));
    }
  }
}
