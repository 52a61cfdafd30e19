// The page of a run: events -> the scene, tables and pictures of one instant, which follows the run or is scrubbed.
import { Scene, contextOf } from './scene.js';
import { NoScene } from './no_scene.js';
import { Legend } from './legend.js';
import { Store } from './store.js';
import { openSource } from './source.js';
import { Tables } from './tables.js';
import { Lanes } from './lanes.js';
import { Drawer } from './drawer.js';
import { paintStatus } from './status.js';
import { Where } from './where.js';
import { listenToKeys } from './keys.js';
import { fixed, make } from './dom.js';

const $ = (id) => document.getElementById(id);
const TABLES_EVERY = 200; // ms between two updates of what is no picture

class App {
  constructor() {
    this.source = openSource();
    this.store = new Store();
    this.time = 0;
    this.following = true; // the newest instant
    this.playing = false;
    this.live = false;
    this.chosen = null;
    document.body.classList.toggle('still', this.source.still);
    this.where = new Where();
    const context = contextOf($('scene'));
    const told = { pick: (what) => this.choose(what), name: (what) => this.nameOf(what) };
    this.scene = context ? new Scene($('scene'), context, told) : new NoScene($('scene'));
    this.legend = new Legend($('layers'), this.scene);
    this.tables = new Tables($('tables'), this, this.source.still);
    this.lanes = new Lanes($('lanes'), (time) => this.seek(time));
    this.drawer = new Drawer($('detail'), this);
    this.listen();
    this.source.start({
      begin: () => this.startOver(),
      add: (events) => this.add(events),
      lost: (attempt, of) => this.setReach({ attempt, of }),
      over: (why) => this.setReach({ over: why }),
    });
  }

  /** All events from the first one on follow. */
  startOver() {
    this.store = new Store();
    this.ended = undefined;
    this.reach = undefined;
  }

  add(events) {
    for (const event of events) {
      if (event.e === 'pace') this.setPace(event);
      else this.store.add(event);
      if (event.e === 'start') this.begin(event);
      if (event.e === 'end') this.ended = event.report;
    }
    if (this.following) this.time = this.store.end;
    this.refresh();
  }

  begin(start) {
    const same = this.start && JSON.stringify(this.start) === JSON.stringify(start);
    this.start = start;
    if (same) return; // told again: the scene stands, and is seen from where one was
    this.where = new Where(start.place?.T_world_map);
    document.title = `amiss: ${start.world}, seed ${start.seed}`;
    $('subject').textContent = `${start.world} · seed ${start.seed} · ${start.method} search`;
    this.scene.begin(start);
  }

  setPace(pace) {
    this.live = pace.live;
    this.pace = pace;
    this.refresh();
  }

  /** Of the run: undefined while it is heard. */
  setReach(reach) {
    this.reach = reach;
    this.refresh();
  }

  /** Everything that there is to know of the instant that is shown. */
  state() {
    const { store, time } = this;
    const trail = store.until('pose', time);
    const placed = new Set((store.first('objects')?.list ?? []).map((object) => object.name));
    const thin = Math.max(1, Math.floor(trail.length / 1500));
    const state = {
      store, time, start: this.start, chosen: this.chosen, where: this.where,
      mapOf: store.merged ? 'map at the end' : 'map now',
      pose: store.poseAt(time),
      trail: trail.filter((_, i) => i % thin === 0).map((e) => e.p),
      examined: store.until('examined', time),
      touches: store.until('collision', time),
      bodies: store.bodiesAt(time).filter((body) => !placed.has(body.name)),
      voxelChanges: store.until('voxels', time).length,
      voxels: () => store.voxels.at(time),
      voxelCount: () => store.voxels.at(time).length / 3,
      report: time >= store.end - 1e-6 ? this.ended : undefined,
    };
    state.over = Boolean(state.report);
    for (const kind of ['regions', 'views', 'plan', 'step', 'path', 'difference', 'objects', 'progress', 'frame']) {
      state[kind] = store.latest(kind, time);
    }
    state.objects ??= store.first('objects');
    return state;
  }

  /** Once for each picture of the screen, however often it is called. */
  refresh() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame((now) => {
      this.waiting = 0;
      this.paint(now);
    });
  }

  paint(now) {
    if (this.playing) this.advance(now);
    if (!this.start) return paintStatus(this);
    const state = this.state();
    this.scene.update(state);
    this.legend.update(state);
    $('now').textContent = `${this.time.toFixed(1)} s`;
    const scrub = $('scrub');
    scrub.max = Math.max(0.1, this.store.end).toFixed(1);
    scrub.value = this.time;
    scrub.setAttribute('aria-valuetext', `${this.time.toFixed(1)} seconds`);
    this.lanes.update(this.store, this.time);
    this.paintCamera(state);
    if (now - (this.tablesAt ?? -1e9) >= TABLES_EVERY || !this.playing && !this.live) {
      this.tablesAt = now;
      this.tables.update(state);
      this.drawer.update(state);
      this.paintFigures(state);
      paintStatus(this);
    } else {
      clearTimeout(this.later);
      this.later = setTimeout(() => this.refresh(), TABLES_EVERY);
    }
    if (this.playing) this.refresh();
  }

  advance(now) {
    const passed = Math.min(0.1, (now - (this.playedAt ?? now)) / 1000);
    this.playedAt = now;
    this.time = Math.min(this.store.end, this.time + passed * Number($('rate').value));
    if (this.time >= this.store.end) this.setPlaying(false);
  }

  paintFigures(state) {
    const list = state.objects?.list ?? [];
    const figures = [
      [`${list.filter((o) => o.found).length} of ${list.length}`, 'found'],
      [`${fixed(state.progress?.seen_m2 ?? 0, 0)} m²`, 'seen'],
      [String((state.regions?.list ?? []).filter((r) => r.state !== 'withdrawn').length), 'regions'],
      [String(state.touches.length), 'touches'],
    ];
    const text = JSON.stringify(figures);
    if (text === this.figures) return;
    this.figures = text;
    $('figures').replaceChildren(...figures.map(([value, name]) => make('span', {}, make('strong', {}, value), ' ' + name)));
  }

  async paintCamera({ frame }) {
    $('camera').hidden = !this.store.first('frame');
    $('camera').classList.toggle('none', !frame || !this.frame);
    if (!frame || this.loading || this.frame === frame) return;
    this.loading = true;
    const [colour, depth] = await Promise.all([this.source.picture(frame.colour), this.source.picture(frame.depth)]);
    this.loading = false;
    this.frame = frame;
    if (colour && depth) {
      $('colour').src = colour;
      $('depth').src = depth;
      $('colour').alt = `camera at ${frame.t.toFixed(1)} s`;
      $('depth').alt = `depth at ${frame.t.toFixed(1)} s`;
      $('taken').textContent = `colour, ${frame.t.toFixed(1)} s`;
    }
    this.refresh(); // there may be a newer one
  }

  choose(what) {
    this.chosen = what ?? null;
    this.tablesAt = undefined;
    if (what) {
      const thing = this.find(what);
      if (thing && !this.scene.following) this.scene.goTo([thing.p[0], thing.p[1], 0.1]);
    }
    this.refresh();
  }

  /** The object or region of what was clicked. */
  find({ kind, id }) {
    const state = this.state();
    const list = (kind === 'object' ? state.objects : state.regions)?.list ?? [];
    return list.find((one) => (one.name ?? one.id) === id);
  }

  /** For the pointer over the scene. */
  nameOf(what) {
    const thing = this.find(what);
    const name = what.kind === 'region' ? `region ${what.id}` : what.id;
    return thing ? `${name} at ${this.where.sentence(thing.p)}` : name;
  }

  goTo(p) { this.scene.goTo(p); }
  text(name) { return this.source.text(name); }

  seek(time) {
    this.following = false;
    this.setPlaying(false);
    this.time = Math.min(this.store.end, Math.max(0, time));
    this.refresh();
  }

  follow() {
    this.setPlaying(false);
    this.following = true;
    this.time = this.store.end;
    this.refresh();
  }

  setPlaying(playing) {
    this.playing = playing;
    this.playedAt = undefined;
    if (playing) {
      if (this.time >= this.store.end) this.time = 0;
      this.following = false;
    }
    $('play').textContent = playing ? '❚❚' : '▶';
    $('play').setAttribute('aria-label', playing ? 'Halt' : 'Play');
    this.refresh();
  }

  look(from) {
    if (from === 'robot') this.scene.following = !this.scene.following;
    else this.scene.following = false;
    document.querySelector('[data-look=robot]').setAttribute('aria-pressed', String(this.scene.following));
    if (from === 'robot') {
      if (this.scene.following) this.scene.goTo(this.state().pose?.p.slice(0, 2) ?? [0, 0]);
    } else {
      this.scene.look(from);
    }
    this.refresh();
  }

  listen() {
    for (const button of document.querySelectorAll('[data-look]')) button.onclick = () => this.look(button.dataset.look);
    $('play').onclick = () => this.setPlaying(!this.playing);
    $('begin').onclick = () => this.seek(0);
    $('newest').onclick = () => this.follow();
    $('scrub').oninput = (event) => this.seek(Number(event.target.value));
    $('halt').onclick = () => this.source.send({ pause: !this.pace?.paused });
    $('step').onclick = () => {
      this.follow();
      this.source.send({ step: true });
    };
    $('speed').onchange = (event) => this.source.send({ speed: Number(event.target.value) });
    $('theme').onclick = () => this.setTheme(document.documentElement.dataset.theme);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.restyle());
    addEventListener('resize', () => this.refresh());
    listenToKeys(this);
  }

  setTheme(before) {
    const dark = before ? before === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    document.documentElement.dataset.theme = dark ? 'light' : 'dark';
    this.restyle();
  }

  restyle() {
    this.scene.restyle();
    this.refresh();
  }
}

window.amiss = new App();
