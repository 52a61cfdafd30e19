// What was chosen, in a drawer over the scene (a sheet at the bottom where the page is narrow), so that nothing moves.
import { objectDetail, regionDetail } from './detail.js';
import { make } from './dom.js';

export class Drawer {
  constructor(host, app) {
    this.host = host;
    this.app = app;
    this.close = make('button', { type: 'button', class: 'close', 'aria-label': 'Close', onclick: () => app.choose(null) }, '×');
  }

  update(state) {
    const { chosen } = state;
    const list = { object: state.objects, region: state.regions }[chosen?.kind]?.list ?? [];
    const thing = list.find((one) => (one.name ?? one.id) === chosen.id);
    const key = thing ? JSON.stringify([thing, state.over]) : '';
    if (key === this.key) return;
    this.key = key;
    const hadFocus = this.host.contains(document.activeElement);
    this.host.hidden = !thing;
    if (thing) {
      const parts = chosen.kind === 'object' ? objectDetail(thing, state, this.app.source) : regionDetail(thing, state, this.app.source);
      const top = this.chosen === chosen.id ? this.host.scrollTop : 0;
      this.host.replaceChildren(this.close, ...parts);
      this.host.scrollTop = top;
      if (hadFocus) this.close.focus();
    } else if (hadFocus) {
      this.backTo(this.chosen);
    }
    this.app.scene.leaveFree(this.covers());
    this.chosen = chosen?.id;
  }

  /** How many pixels of the scene it hides: at the right, or at the bottom where it is a sheet. */
  covers() {
    if (this.host.hidden) return { right: 0, bottom: 0 };
    const [own, stage] = [this.host, this.app.scene.canvas].map((element) => element.getBoundingClientRect());
    if (getComputedStyle(this.host).position !== 'fixed') return { right: stage.right - own.left, bottom: 0 };
    return { right: 0, bottom: Math.min(0.8 * stage.height, Math.max(0, stage.bottom - own.top)) };
  }

  /** The keyboard goes on where it was. */
  backTo(id) {
    const rows = [...document.querySelectorAll('tbody button[data-id]')];
    const row = rows.find((button) => button.dataset.id === String(id) && button.offsetParent);
    (row ?? this.app.scene.canvas).focus({ preventScroll: true });
  }
}
