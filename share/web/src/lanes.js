// The timeline: a lane for each kind of thing that happened, and how much floor was seen.
import { svg } from './dom.js';
import { OBJECT, PALETTE, REGION, SEGMENT } from './look.js';

export const LANES = [
  { name: 'plans', colour: PALETTE.yellow, marks: (store) => store.all('plan').map((e) => [e.t, `plan ${e.number}`]) },
  { name: 'steps', colour: PALETTE.sky, marks: (store) => steps(store).map((e) => [e.t, e.text]) },
  { name: 'regions', colour: REGION.open.colour, marks: (store) => detections(store) },
  { name: 'examined', colour: SEGMENT.colour, marks: (store) => store.all('examined').map((e) => [e.t, `${e.region ? 'region ' + e.region : 'frame'} examined`]) },
  { name: 'found', colour: OBJECT.found.colour, marks: (store) => finds(store).map((o) => [o.found_at, o.name + ' found']) },
  { name: 'script', colour: PALETTE.grey, optional: true, marks: (store) => store.all('script').map((e) => [e.t, e.text]) },
  { name: 'faults', colour: PALETTE.vermillion, marks: (store) => faults(store).map((e) => [e.t, e.text]) },
];

/** What a step of a plan is called. */
export const stepText = (s) => `${{ goto: 'go to', explore: 'look into', examine: 'examine' }[s.action] ?? s.action} ${s.of === 'view' ? 'view' : 'region'} ${s.id}`;
/** Steps as they were begun, each of the newest plan. */
export function steps(store) {
  const list = store.all('step').map((e) => ({ t: e.t, step: store.latest('plan', e.t)?.steps[e.step] }));
  return list.filter((e) => e.step).map((e) => ({ t: e.t, text: stepText(e.step) }));
}
export const detections = (store) => (store.all('regions').at(-1)?.list ?? []).map((r) => [r.first_seen, `region ${r.id} detected`]);
export const finds = (store) => (store.all('objects').at(-1)?.list ?? []).filter((o) => o.found);
export const touchText = (e) => `${e.link} touched ${e.body}`;
const faults = (store) => [
  ...store.all('collision').map((e) => ({ t: e.t, text: touchText(e) })),
  ...store.all('log').map((e) => ({ t: e.t, text: e.text })),
];

const LANE = 14;
const NEAR = 6; // pixels within which a mark is meant
const NAMES = 62; // pixels for the names at the left; the slider begins there, too

export class Lanes {
  constructor(host, seek) {
    this.host = host;
    const go = (event) => {
      if (event.buttons !== 1) return;
      const box = host.getBoundingClientRect();
      seek(this.instant(event.clientX - box.left, event.clientY - box.top));
    };
    host.addEventListener('pointerdown', (event) => {
      host.setPointerCapture(event.pointerId);
      go(event);
    });
    host.addEventListener('pointermove', go);
    this.key = '';
    this.cursor = svg('line', { class: 'cursor', y1: 0 });
  }

  update(store, time) {
    this.store = store;
    const width = this.host.clientWidth;
    const key = `${width} ${Math.ceil(store.end)} ${LANES.map((lane) => lane.marks(store).length)}`;
    if (key !== this.key) {
      this.key = key;
      this.paint(store, width);
    }
    const x = this.x(time, store.end, width);
    this.cursor.setAttribute('x1', x);
    this.cursor.setAttribute('x2', x);
  }

  /** When that is [s] of a point of the picture [pixels]: of the mark that is near, else of the place. */
  instant(x, y) {
    const width = this.host.clientWidth;
    const lane = this.lanes?.[Math.floor(y / LANE)];
    const near = (lane?.marks(this.store) ?? []).map(([t]) => [Math.abs(this.x(t, this.store.end, width) - x), t]).sort((a, b) => a[0] - b[0])[0];
    if (near && near[0] < NEAR) return near[1];
    return (this.store.end * (x - NAMES)) / Math.max(1, width - NAMES - 8);
  }

  x(time, end, width) { return NAMES + (width - NAMES - 8) * (end > 0 ? time / end : 0); }

  paint(store, width) {
    const lanes = (this.lanes = LANES.filter((lane) => !lane.optional || lane.marks(store).length > 0));
    const height = LANE * lanes.length;
    this.cursor.setAttribute('y2', height);
    const drawing = svg('svg', { width, height, viewBox: `0 0 ${width} ${height}` });
    const progress = store.all('progress');
    const most = Math.max(1, ...progress.map((e) => e.seen_m2));
    if (progress.length > 1) {
      const points = progress.map((e) => `${this.x(e.t, store.end, width).toFixed(1)},${(height - (height * e.seen_m2) / most).toFixed(1)}`);
      const [from, to] = [progress[0], progress.at(-1)].map((e) => this.x(e.t, store.end, width));
      drawing.append(svg('polygon', { class: 'seen', points: `${from},${height} ${points.join(' ')} ${to},${height}` }));
    }
    lanes.forEach((lane, i) => {
      const y = LANE * (i + 0.5);
      const name = svg('text', { x: 0, y: y + 4 });
      name.textContent = lane.name;
      drawing.append(name, svg('line', { class: 'lane', x1: NAMES, x2: width - 8, y1: y, y2: y }));
      for (const [t, text] of lane.marks(store)) {
        const title = svg('title');
        title.textContent = `${t.toFixed(1)} s: ${text}`;
        drawing.append(svg('circle', { cx: this.x(t, store.end, width), cy: y, r: 4, fill: lane.colour }, title));
      }
    });
    drawing.append(this.cursor);
    this.host.replaceChildren(drawing);
  }
}
