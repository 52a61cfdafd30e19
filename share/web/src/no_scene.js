// In the place of the scene where a browser has no WebGL: says so, and lets the rest of the page work as ever.
import { make } from './dom.js';

const WHY = 'There is no 3D scene here: this browser has no WebGL 2, or it is switched off. All that the scene would show '
  + 'stands in the tables; timeline, camera and curves work.';

export class NoScene {
  constructor(canvas) {
    this.canvas = canvas;
    this.following = false;
    this.layers = { cut() {}, setVisible() {} };
    const stage = canvas.parentElement;
    stage.classList.add('flat');
    stage.prepend(make('p', { class: 'notice' }, WHY));
  }
  begin() {}
  look() {}
  goTo() {}
  update() {}
  restyle() {}
  leaveFree() {}
  draw() {}
  turn() {}
  shift() {}
  approach() {}
}
