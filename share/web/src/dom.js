// Small helpers to make elements; text is always set as text, never as markup.
import { inkOn } from './look.js';

export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.filter((child) => child !== undefined));
  return element;
}

const SVG = 'http://www.w3.org/2000/svg';
export function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** Letter on its colour. */
export function badge(look) {
  const element = make('b', { class: 'badge', title: look.meaning }, look.letter);
  element.style.background = look.colour;
  element.style.color = inkOn(look.colour);
  return element;
}

/** "1 segment", "2 segments". */
export const several = (count, thing) => `${count} ${thing}${count === 1 ? '' : 's'}`;

/** A number that is not "-0.0". */
export function fixed(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace('-', '') : text;
}
export const metres = (value, digits = 2) => (value === null || value === undefined ? '–' : `${fixed(value, digits)} m`);
export const seconds = (value) => (value === null || value === undefined ? '–' : `${fixed(value, 1)} s`);
export const percent = (value) => `${Math.round(100 * value)} %`;
export const degrees = (radians) => `${fixed((radians * 180) / Math.PI, 0)}°`;
