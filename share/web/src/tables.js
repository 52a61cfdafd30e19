// The tables: everything that the scene shows, in words and numbers, at the instant that is shown.
import { make, metres, seconds, several } from './dom.js';
import { figures } from './figures.js';
import { finds, stepText, steps, touchText } from './lanes.js';
import { logged } from './log.js';
import { BODY, FAULT, NOTE, OBJECT, RECOVERY, REGION, SCRIPT, SEGMENT, VIEW, objectLook } from './look.js';
import { row, sentence, signed, table } from './rows.js';

const MOST_EVENTS = 200; // rows: a page with thousands of buttons is slow

function objects(state, app) {
  const { where } = state;
  const rows = (state.objects?.list ?? []).map((o) => row(
    [signed(objectLook(o, state.over), o.name), objectLook(o, state.over).verdict, seconds(o.found_at), metres(o.error, 3), where.place(o.p)],
    { act: () => app.choose({ kind: 'object', id: o.name }), chosen: state.chosen?.id === o.name, id: o.name }));
  const placed = table(['object', 'verdict', 'after', 'error', where.column], rows, 'No object was placed.');
  if (state.bodies.length === 0) return placed;
  const others = state.bodies.map((b) => row([signed(BODY, b.name), seconds(b.t), where.place(b.pose)], { act: () => app.goTo(b.pose) }));
  return make('div', {}, placed, make('h3', {}, 'what else moves or was moved'), table(['thing', 'there since', where.column], others, ''));
}

function segments(state, app) {
  const rows = state.examined.flatMap((e) => e.segments.map((s) => row(
    [signed(SEGMENT, e.region ? `of region ${e.region}` : 'of a frame'), s.size.map((v) => (100 * v).toFixed(0)).join(' × '), String(s.points), seconds(e.t), state.where.place(s.p)],
    { act: () => app.goTo(s.p) })));
  return table(['segment', 'size [cm]', 'points', 'at', state.where.column], rows, 'Nothing was segmented yet.');
}

function regions(state, app) {
  const rows = (state.regions?.list ?? []).map((r) => row(
    [signed(REGION[r.state], `region ${r.id}`), r.state, String(r.voxels), metres(r.radius), state.where.place(r.p)],
    { act: () => app.choose({ kind: 'region', id: r.id }), chosen: state.chosen?.kind === 'region' && state.chosen.id === r.id, id: r.id }));
  return table(['region', 'state', 'voxels', 'radius', state.where.column], rows, 'The map does not differ from the reference.');
}

function plan(state, app) {
  const { where } = state;
  const from = state.step && state.plan && state.step.t >= state.plan.t ? state.step.step : 0;
  const steps = (state.plan?.steps ?? []).map((s, i) => row(
    [`${i + 1}. ${stepText(s)}`, i < from ? 'done' : i === from ? 'now' : '', where.place(s.p), where.heading(s.p[2])],
    { act: () => app.goTo([s.p[0], s.p[1], 0]), chosen: i === from }));
  const views = (state.views?.list ?? []).map((v) => row(
    [signed(VIEW[v.state], `view ${v.id}`), v.state, where.place(v.p), where.heading(v.p[2])], { act: () => app.goTo([v.p[0], v.p[1], 0]) }));
  return make('div', {}, make('h3', {}, state.plan ? `plan ${state.plan.number}, made at ${seconds(state.plan.t)}` : 'plan'),
    table(['step', '', where.column, 'heading'], steps, 'No plan yet.'),
    make('h3', {}, 'view triangles'), table(['view', 'state', where.column, 'heading'], views, 'None yet.'));
}

/** Up to the instant, the newest first. */
function happened({ store, time, where }) {
  const list = [
    ...store.until('plan', time).map((e) => ({ t: e.t, text: `plan ${e.number}: ${several(e.steps.filter((s) => s.action === 'goto').length, 'place')}` })),
    ...steps(store).filter((e) => e.t <= time),
    ...(store.latest('regions', time)?.list ?? []).map((r) => ({ t: r.first_seen, text: `region ${r.id} detected`, look: REGION.open })),
    ...store.until('examined', time).map((e) => ({ t: e.t, text: `${e.region ? `region ${e.region}` : 'frame'} examined: ${several(e.segments.length, 'segment')}`, look: SEGMENT })),
    ...finds(store).filter((o) => o.found_at <= time).map((o) => ({ t: o.found_at, text: `${o.name} found`, look: OBJECT.found })),
    ...store.until('script', time).map((e) => ({ ...e, look: SCRIPT })),
    ...store.until('collision', time).map((e) => ({ t: e.t, text: `${touchText(e)} at ${where.sentence(e.p)}`, look: FAULT })),
    ...[FAULT, RECOVERY, NOTE].flatMap((look) => logged(store, look, time)),
  ];
  return list.sort((a, b) => b.t - a.t);
}

function events(state, app) {
  const all = happened(state);
  const rows = all.slice(0, MOST_EVENTS).map((e) => row([seconds(e.t), sentence(e.look, e.text)], { act: () => app.seek(e.t) }));
  const list = table(['at', 'what'], rows, 'Nothing yet.');
  if (all.length <= MOST_EVENTS) return list;
  return make('div', {}, make('p', { class: 'empty' }, `The newest ${MOST_EVENTS} of ${all.length} up to this instant; at an earlier instant earlier ones stand here.`), list);
}

/** Name, title, what it holds, and what it depends on. */
const TABS = [
  ['objects', 'Objects', objects, (s) => [s.objects?.t, s.over, s.chosen?.id, s.bodies.map((b) => b.t)]],
  ['regions', 'Regions', regions, (s) => [s.regions?.t, s.chosen?.id]],
  ['segments', 'Segments', segments, (s) => [s.examined.length]],
  ['plan', 'Plan', plan, (s) => [s.plan?.t, s.step?.t, s.views?.t]],
  ['events', 'Events', events, (s) => [Math.floor(s.time), s.store.count]],
  ['run', 'Run', figures, (s) => [s.time.toFixed(1), s.over]],
];

export class Tables {
  constructor(host, app, still) {
    this.app = app;
    this.list = host.querySelector('[role=tablist]');
    this.panels = new Map();
    this.shown = {};
    for (const [name, title] of [...TABS, ['parameters', 'Parameters']]) {
      const tab = make('button', { type: 'button', role: 'tab', id: 'tab-' + name, 'aria-controls': name, onclick: () => this.open(name), onkeydown: (e) => this.walk(e) }, title);
      const panel = make('div', { role: 'tabpanel', id: name, 'aria-labelledby': 'tab-' + name, tabindex: '0' });
      if (still) panel.dataset.title = title;
      this.list.append(tab);
      host.append(panel);
      this.panels.set(name, { tab, panel });
    }
    this.all = still; // a report shows them all, one below the other
    this.open('objects');
  }

  open(name) {
    this.current = name;
    for (const [other, { tab, panel }] of this.panels) {
      tab.setAttribute('aria-selected', String(other === name));
      tab.tabIndex = other === name ? 0 : -1;
      panel.hidden = !this.all && other !== name;
    }
    if (this.state) this.update(this.state);
    if (name === 'parameters' || this.all) this.loadParameters();
  }

  walk(event) {
    const names = [...this.panels.keys()];
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    event.stopPropagation();
    this.open(names[(names.indexOf(this.current) + by + names.length) % names.length]);
    this.panels.get(this.current).tab.focus();
  }

  async loadParameters() {
    const { panel } = this.panels.get('parameters');
    if (panel.firstChild) return;
    const text = make('pre', {}, 'loading');
    const others = make('pre');
    panel.append(
      make('details', { open: !this.all }, make('summary', {}, 'as they were used'), text), // long, in a report folded
      make('details', {}, make('summary', {}, 'software of others in this page'), others));
    text.textContent = (await this.app.text('params.yaml')) ?? 'The parameters cannot be read.';
    others.textContent = (await this.app.text('licences.txt')) ?? 'The licences cannot be read.';
  }

  update(state) {
    this.state = state;
    for (const [name, , fill, depends] of TABS) {
      if (!this.all && name !== this.current) continue;
      const key = JSON.stringify(depends(state));
      if (this.shown[name] === key) continue;
      this.shown[name] = key;
      const { panel } = this.panels.get(name);
      const focused = panel.contains(document.activeElement) ? [...panel.querySelectorAll('button')].indexOf(document.activeElement) : -1;
      panel.replaceChildren(fill(state, this.app));
      if (focused >= 0) panel.querySelectorAll('button')[focused]?.focus({ preventScroll: true });
    }
  }
}
