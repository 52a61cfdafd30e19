// What the scene shows: layers to be switched on and off, what their colours and letters mean, and the cut through the maps.
import { badge, make } from './dom.js';
import { LAYERS } from './layers.js';
import { NOTE, RECOVERY, SCRIPT, VIEW, styled } from './look.js';

const CUT = 1.5; // m: the maps are shown to this height at first
const HIGHEST = 2.6; // m: and from here on whole
const NARROW = 820; // pixels: there it is folded at first
const MOST = 0.35; // of the scene's width that is left to it alone

/** What is in tables and timeline only. */
const ELSEWHERE = [VIEW.visited, VIEW.dropped, RECOVERY, NOTE, SCRIPT];

/** A letter on its colour, or the colour alone. */
function sign(look) {
  if (look.letter) return badge(look);
  const patch = make('i', { title: look.meaning });
  patch.style.background = styled(look);
  return patch;
}

export class Legend {
  constructor(host, scene) {
    this.host = host;
    this.scene = scene;
    this.titles = new Map();
    host.open = innerWidth > NARROW;
    for (const [name, title, signs, on] of LAYERS) {
      const box = make('input', { type: 'checkbox', checked: on, onchange: () => this.show(name, box.checked) });
      const words = make('span', {}, title);
      this.titles.set(name, words);
      host.append(make('label', { 'data-layer': name }, box, words, ...signs.map(sign)));
    }
    host.append(this.cut(), this.meanings());
    new ResizeObserver(() => this.leaveFree()).observe(host);
    this.leaveFree();
  }

  show(name, on) {
    this.scene.layers.setVisible(name, on);
    this.scene.draw();
  }

  /** The robot's map is that of the instant, or of the end throughout where a report holds no other one. */
  update(state) { this.titles.get('current').textContent = state.mapOf; }

  /** What is looked at stays beside it, unless the scene is too narrow for both. */
  leaveFree() {
    const { right, bottom, height } = this.host.getBoundingClientRect();
    const stage = this.scene.canvas.parentElement.getBoundingClientRect();
    const left = this.host.open && height > 0 && bottom > stage.top ? right - stage.left : 0;
    this.scene.leaveFree({ left: left > MOST * stage.width ? 0 : left });
  }

  meanings() {
    const all = [...new Set([...LAYERS.flatMap(([, , signs]) => signs), ...ELSEWHERE])];
    const lines = all.map((look) => make('li', {}, sign(look), make('span', {}, look.meaning)));
    return make('details', { class: 'meanings' }, make('summary', {}, 'what they mean'), make('ul', {}, ...lines));
  }

  /** The maps are shown up to a height, so that one can look over the walls. */
  cut() {
    const said = make('output');
    const slider = make('input', { type: 'range', id: 'cut', 'aria-label': 'Height to which the maps are shown, metres', min: 0.2, max: HIGHEST, step: 0.1, value: CUT, oninput: () => set() });
    const set = () => {
      const height = Number(slider.value);
      said.textContent = height < HIGHEST ? `${height.toFixed(1)} m` : 'all';
      slider.setAttribute('aria-valuetext', height < HIGHEST ? `${height.toFixed(1)} metres` : 'all');
      this.scene.layers.cut(height < HIGHEST ? height : Infinity);
      this.scene.draw();
    };
    set();
    return make('div', { class: 'cut' }, 'maps up to ', said, slider);
  }
}
