// The timeline: a lane for each kind of thing that happened, and how much floor was seen.
import { svg } from './dom.js';
import { logged } from './log.js';
import { FAULT, NOTE, OBJECT, PALETTE, RECOVERY, REGION, SCRIPT, SEGMENT } from './look.js';

export const LANES = [
  { name: 'plans', colour: PALETTE.yellow, marks: (store) => store.all('plan').map((e) => [e.t, `plan ${e.number}`]) },
  { name: 'steps', colour: PALETTE.sky, marks: (store) => steps(store).map((e) => [e.t, e.text]) },
  { name: 'regions', colour: REGION.open.colour, marks: (store) => detections(store) },
  { name: 'examined', colour: SEGMENT.colour, marks: (store) => store.all('examined').map((e) => [e.t, `${e.region ? 'region ' + e.region : 'frame'} examined`]) },
  { name: 'found', colour: OBJECT.found.colour, marks: (store) => finds(store).map((o) => [o.found_at, o.name + ' found']) },
  { name: 'script', colour: SCRIPT.colour, optional: true, marks: (store) => store.all('script').map((e) => [e.t, e.text]) },
  { name: 'notes', colour: NOTE.colour, optional: true, marks: (store) => logged(store, NOTE).map((e) => [e.t, e.text]) },
  { name: 'faults', colour: FAULT.colour, marks: (store) => faults(store).map((e) => [e.t, e.text]) },
  { name: 'recovered', colour: RECOVERY.colour, optional: true, marks: (store) => logged(store, RECOVERY).map((e) => [e.t, e.text]) },
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
const faults = (store) => [...store.all('collision').map((e) => ({ t: e.t, text: touchText(e) })), ...logged(store, FAULT)].sort((a, b) => a.t - b.t);

const LANE = 14;
const NEAR = 6; // pixels within which a mark is meant
const NAMES = 62; // pixels for the names at the left; half a thumb before that the slider begins
const APART = 1; // pixels; what is nearer than that is one mark
const MOST_WORDS = 6; // things that one mark names

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

  /** Marks that would lie on one another as one. */
  together(marks, width) {
    const list = [];
    for (const [t, text] of marks) {
      const x = this.x(t, this.store.end, width);
      if (!list.length || Math.abs(x - list.at(-1).x) >= APART) list.push({ x, words: [] });
      list.at(-1).words.push(`${t.toFixed(1)} s: ${text}`);
    }
    return list;
  }

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
      for (const { x, words } of this.together(lane.marks(store), width)) {
        const title = svg('title');
        const more = words.length - MOST_WORDS;
        title.textContent = [...words.slice(0, MOST_WORDS), ...(more > 0 ? [`and ${more} more`] : [])].join('\n');
        drawing.append(svg('circle', { cx: x, cy: y, r: 4, fill: lane.colour }, title));
      }
    });
    drawing.append(this.cursor);
    this.host.replaceChildren(drawing);
  }
}
