// How a run stands, above the page: running, paused, ended, or out of reach; and the buttons of the simulation.
import { make } from './dom.js';

const $ = (id) => document.getElementById(id);

const OVER = {
  gone: 'the run is gone',
  refused: 'no connection: the run is there, but lets no further page watch',
};

/** What is said, and the state that gives the colour. */
function standing(app) {
  const { start, ended, reach, pace } = app;
  if (ended) return [`ended: ${ended.outcome}`, 'ended'];
  if (reach?.over) return [OVER[reach.over], 'ended'];
  if (reach?.attempt) return [`connection lost; connecting again (${reach.attempt} of ${reach.of})`, 'lost'];
  if (!app.live) return [start ? 'as far as it was written' : 'loading', 'ended'];
  if (!start) return ['waiting for the run to begin; a new place is mapped first', 'running'];
  return pace.paused ? ['paused', 'paused'] : ['running', 'running'];
}

export function paintStatus(app) {
  const [text, state] = standing(app);
  if ($('status').textContent !== text) $('status').textContent = text; // it is read aloud when it changes
  $('status').dataset.state = state;
  const running = app.live && !app.ended && !app.reach;
  $('pace').hidden = !running;
  $('halt').textContent = app.pace?.paused ? 'Go on' : 'Pause';
  if (running && document.activeElement !== $('speed')) {
    const speed = String(app.pace.speed);
    if (![...$('speed').options].some((option) => option.value === speed)) $('speed').append(make('option', { value: speed }, speed + '×'));
    $('speed').value = speed;
  }
  $('newest').textContent = running ? 'Live' : 'End';
  $('newest').setAttribute('aria-label', running ? 'Follow the run' : 'To the end');
  $('newest').setAttribute('aria-pressed', String(app.following));
}
