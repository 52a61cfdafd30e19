// Lines of a run's log are words for people: which of them tell of something that failed, which that it goes on, and
// which are plain notes. Their wordings are those of libs/mission.
import { FAULT, NOTE, RECOVERY } from './look.js';

const FAILED = [
  /^(waits|gives in|no plan|stopped on the way|waypoint \d+): /,
  /^(view triangle|viewpoint of region) \d+ was not reached/,
  / cannot be seen from anywhere$/,
];
const WENT_ON = /^goes on\b/;
/** What the log says beside an event of its own, which is shown already. */
const TOLD_BY_EVENTS = [/^plan \d+$/, /^(region \d+ examined|frame segmented): \d+ segments$/, /^found /];

export function lookOf(text) {
  if (WENT_ON.test(text)) return RECOVERY;
  return FAILED.some((wording) => wording.test(text)) ? FAULT : NOTE;
}

/** Lines that tell the same one after the other, as one that tells how often. */
function folded(lines) {
  const list = [];
  for (const { t, text } of lines) {
    if (TOLD_BY_EVENTS.some((wording) => wording.test(text))) continue;
    const last = list.at(-1);
    if (last?.text === text) ++last.times;
    else list.push({ t, text, times: 1 });
  }
  return list.map((e) => ({ t: e.t, text: e.times > 1 ? `${e.text} (${e.times} times)` : e.text, look: lookOf(e.text) }));
}

export const logged = (store, look, time = Infinity) => folded(store.until('log', time)).filter((e) => e.look === look);
