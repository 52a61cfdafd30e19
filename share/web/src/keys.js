// The keyboard: what each key does, here and in the scene.

const TURN = 0.12; // radians for one press
const CLOSER = 0.85;

/** True if the key is for what has the focus. */
function isTaken(event) {
  const { target } = event;
  if (event.key === 'Escape') return Boolean(document.querySelector(':popover-open')); // the browser closes that
  if (/^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName)) return target.type !== 'checkbox' || event.key === ' ';
  return event.key === ' ' && /^(BUTTON|SUMMARY)$/.test(target.tagName);
}

/** Arrows while the scene has the focus. */
function turn(event, scene) {
  const [right, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
  if (right === 0 && up === 0) return false;
  if (event.shiftKey) scene.shift(right, up);
  else scene.turn(TURN * right, TURN * up);
  return true;
}

export function listenToKeys(app) {
  const { scene } = app;
  const second = (event) => (event.shiftKey ? 10 : 1);
  const keys = {
    ' ': () => app.setPlaying(!app.playing),
    ArrowLeft: (event) => app.seek(app.time - second(event)),
    ArrowRight: (event) => app.seek(app.time + second(event)),
    Home: () => app.seek(0),
    End: () => app.follow(),
    Escape: () => app.choose(null),
    0: () => app.look('fit'),
    t: () => app.look('top'),
    f: () => app.look('robot'),
    '+': () => scene.approach(CLOSER),
    '=': () => scene.approach(CLOSER),
    '-': () => scene.approach(1 / CLOSER),
  };
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || isTaken(event)) return;
    if (event.target === scene.canvas && turn(event, scene)) return event.preventDefault();
    if (!keys[event.key]) return;
    keys[event.key](event);
    event.preventDefault();
  });
}
