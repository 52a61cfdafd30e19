// Colours and letters: what a thing is can be told by either. Okabe and Ito's palette, which the colour-blind can tell.
// Scene, legend, tables and timeline all take them from here; `themed` ones are of the style sheet, for light and dark.
export const PALETTE = {
  orange: '#e69f00', sky: '#56b4e9', green: '#009e73', yellow: '#f0e442', blue: '#0072b2', vermillion: '#d55e00',
  purple: '#cc79a7', grey: '#8a8f98',
};

export const REGION = {
  open: { letter: 'O', colour: PALETTE.orange, meaning: 'region to be examined' },
  examined: { letter: 'E', colour: PALETTE.blue, meaning: 'region that was examined' },
  withdrawn: { letter: 'W', colour: PALETTE.grey, meaning: 'region withdrawn: looked at again and not confirmed' },
};

export const OBJECT = {
  found: { letter: 'F', colour: PALETTE.green, meaning: 'object found', verdict: 'found' },
  awaited: { letter: 'N', colour: PALETTE.grey, meaning: 'object not found yet', verdict: 'not found yet' },
  missing: { letter: 'M', colour: PALETTE.vermillion, meaning: 'object missed: not found until the end', verdict: 'not found' },
};

export const SEGMENT = { letter: 'S', colour: PALETTE.purple, meaning: 'segment that the robot took for an object' };

export const VIEW = {
  open: { letter: 'V', colour: PALETTE.sky, meaning: 'view triangle still to be visited' },
  visited: { letter: 'v', colour: PALETTE.sky, meaning: 'view triangle visited' },
  dropped: { letter: 'd', colour: PALETTE.grey, meaning: 'view triangle dropped: seen on the way, or out of reach' },
};

export const FAULT = { letter: '!', colour: PALETTE.vermillion, meaning: 'fault: a touch, or something that failed' };
export const RECOVERY = { letter: 'R', colour: PALETTE.green, meaning: 'recovery: it goes on after a fault' };
export const NOTE = { letter: 'i', colour: PALETTE.sky, meaning: "note in the run's log" };
export const SCRIPT = { letter: '*', colour: PALETTE.grey, meaning: 'done by the script of the scenario' };
export const BODY = { letter: 'B', colour: '#a6761d', meaning: 'truth: a thing or a person that was moved or moves' };
export const HOLDS = { letter: '✓', colour: PALETTE.green, meaning: 'holds' };
export const FAILS = { letter: '✗', colour: PALETTE.vermillion, meaning: 'does not hold' };

export const FLOOR = { themed: 'floor', meaning: 'free floor' };
export const WALL = { themed: 'wall', meaning: 'wall or furniture in the floor plan' };
export const REFERENCE = { themed: 'reference', meaning: 'occupied in the reference' };
export const LOW = { themed: 'map-low', meaning: "occupied in the robot's map, low" };
export const HIGH = { themed: 'map-high', meaning: "occupied in the robot's map, high" };
export const APPEARED = { colour: PALETTE.orange, meaning: 'appeared: occupied, free in the reference' };
export const VANISHED = { colour: PALETTE.blue, meaning: 'vanished: free, occupied in the reference' };
export const WAY = { themed: 'way', meaning: 'way to the next place, and on along the plan' };
export const STOP = { letter: '1', colour: PALETTE.yellow, meaning: 'place of the plan, by its number' };
export const TRAIL = { themed: 'trail', meaning: 'way that was driven' };
export const CAMERA = { colour: PALETTE.purple, meaning: 'what the camera sees' };

/** Until a run is over, nothing is missed. */
export function objectLook(object, over) {
  if (object.found) return OBJECT.found;
  return over ? OBJECT.missing : OBJECT.awaited;
}

/** Black or white, whichever is read better on a colour (contrast of WCAG 2). */
export function inkOn(colour) {
  const linear = [1, 3, 5].map((i) => (parseInt(colour.slice(i, i + 2), 16) / 255 + 0.055) / 1.055).map((v) => v ** 2.4);
  const brightness = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  return 1.05 / (brightness + 0.05) > (brightness + 0.05) / 0.05 ? '#ffffff' : '#0b0f14';
}

/** A colour for the style sheet, which changes with the theme. */
export const styled = (look) => look.colour ?? `var(--${look.themed})`;
/** The same as it is now, for what the style sheet does not reach. */
export const colourOf = (look) => look.colour ?? themed(look.themed);
export const themed = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
