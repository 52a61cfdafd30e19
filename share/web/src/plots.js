// Small line plots over simulated time, with axes that can be read.
import { make, svg } from './dom.js';
import { PALETTE } from './look.js';
import { finds } from './lanes.js';

const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT] = [340, 150, 40, 24, 10, 10];

/** 1, 2 or 5 times a power of ten, so that at most `most` of them fit. */
function step(range, most) {
  const raw = range / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((k) => k * power >= raw - 1e-12);
}

function plot({ name, unit, series, steps }, end) {
  const high = Math.max(1e-9, ...series.flatMap((s) => s.points.map((p) => p[1]))) * 1.08;
  const x = (t) => LEFT + ((WIDTH - LEFT - RIGHT) * t) / Math.max(end, 1e-9);
  const y = (v) => HEIGHT - BOTTOM - ((HEIGHT - BOTTOM - TOP) * v) / high;
  const drawing = svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': `${name} over time` });
  const label = (text, attributes) => {
    const element = svg('text', attributes);
    element.textContent = text;
    drawing.append(element);
  };
  const up = step(high, 4);
  for (let v = 0; v <= high + 1e-12; v += up) {
    drawing.append(svg('line', { class: 'grid', x1: LEFT, x2: WIDTH - RIGHT, y1: y(v), y2: y(v) }));
    label(Number(v.toPrecision(3)), { x: LEFT - 5, y: y(v) + 4, 'text-anchor': 'end' });
  }
  const along = step(Math.max(end, 1e-9), 5);
  for (let t = 0; t <= end; t += along) label(`${Number(t.toPrecision(3))}${t === 0 ? ' s' : ''}`, { x: x(t), y: HEIGHT - 7, 'text-anchor': 'middle' });
  for (const { colour, points } of series) {
    const path = points.map(([t, v], i) => (i === 0 ? 'M' : steps ? `H${x(t).toFixed(1)} V` : 'L') + (i === 0 || !steps ? `${x(t).toFixed(1)},` : '') + y(v).toFixed(1));
    drawing.append(svg('path', { d: path.join(' '), fill: 'none', stroke: colour, 'stroke-width': 2 }));
  }
  return make('figure', { class: 'plot' }, make('figcaption', {}, `${name}${unit ? ` [${unit}]` : ''}`), drawing);
}

/** What of a run is worth a curve. */
export function plots(store) {
  const progress = store.all('progress');
  const poses = store.all('pose');
  const thin = Math.max(1, Math.floor(poses.length / 400));
  const errors = poses.filter((_, i) => i % thin === 0).map((e) => [e.t, 1000 * Math.hypot(e.p[0] - e.true[0], e.p[1] - e.true[1])]);
  const times = finds(store).map((o) => o.found_at).sort((a, b) => a - b);
  const found = [[0, 0], ...times.map((t, i) => [t, i + 1]), [store.end, times.length]];
  return [
    plot({ name: 'ground seen', unit: 'm²', series: [{ colour: PALETTE.sky, points: progress.map((e) => [e.t, e.seen_m2]) }] }, store.end),
    plot({ name: 'objects found', steps: true, series: [{ colour: PALETTE.green, points: found }] }, store.end),
    plot({ name: 'error of the position', unit: 'mm', series: [{ colour: PALETTE.vermillion, points: errors }] }, store.end),
  ];
}
