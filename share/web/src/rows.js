// Tables of things: a row each, led by what it is.
import { badge, make } from './dom.js';

export function table(columns, rows, empty) {
  if (rows.length === 0) return make('p', { class: 'empty' }, empty);
  return make('table', {},
    make('thead', {}, make('tr', {}, ...columns.map((name) => make('th', { scope: 'col' }, name)))),
    make('tbody', {}, ...rows));
}

/** act: what a click on it does; id: what it is known by. */
export function row(cells, { act, chosen, id } = {}) {
  const [first, ...rest] = cells;
  const head = act ? make('button', { type: 'button', onclick: act, 'data-id': id }, first) : first;
  return make('tr', { 'aria-selected': chosen ? 'true' : undefined }, make('th', { scope: 'row' }, head), ...rest.map((cell) => make('td', {}, cell)));
}

/** Words that begin with the letter of what they tell of. */
export const signed = (look, text) => make('span', { class: 'signed' }, badge(look), ' ', text);
/** The same for words that may need more than a line. */
export const sentence = (look, text) => make('span', { class: 'sentence' }, ...(look ? [badge(look), ' '] : []), text);
