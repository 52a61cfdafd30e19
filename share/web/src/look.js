// Colours and letters: what a thing is can be told by either. Okabe and Ito's palette, which the colour-blind can tell.
export const PALETTE = {
  orange: '#e69f00', sky: '#56b4e9', green: '#009e73', yellow: '#f0e442', blue: '#0072b2', vermillion: '#d55e00',
  purple: '#cc79a7', grey: '#8a8f98',
};

export const REGION = {
  open: { letter: 'O', colour: PALETTE.orange, meaning: 'to be examined' },
  examined: { letter: 'E', colour: PALETTE.blue, meaning: 'examined' },
  withdrawn: { letter: 'W', colour: PALETTE.grey, meaning: 'withdrawn: looked at again and not confirmed' },
};

export const OBJECT = {
  found: { letter: 'F', colour: PALETTE.green, meaning: 'found' },
  missing: { letter: 'M', colour: PALETTE.vermillion, meaning: 'not found' },
};

export const SEGMENT = { letter: 'S', colour: PALETTE.purple, meaning: 'segment that the robot took for an object' };

export const VIEW = {
  open: { letter: 'V', colour: PALETTE.sky, meaning: 'still to be visited' },
  visited: { letter: 'v', colour: PALETTE.sky, meaning: 'visited' },
  dropped: { letter: 'd', colour: PALETTE.grey, meaning: 'dropped: seen on the way, or out of reach' },
};

export const FAULT = { letter: '!', colour: PALETTE.vermillion, meaning: 'fault' };
export const SCRIPT = { letter: '*', colour: PALETTE.grey, meaning: 'done by the script of the scenario' };
export const BODY = { letter: 'B', colour: '#a6761d', meaning: 'truth: a thing or a person that was moved or moves' };
export const HOLDS = { letter: '✓', colour: PALETTE.green, meaning: 'holds' };
export const FAILS = { letter: '✗', colour: PALETTE.vermillion, meaning: 'does not hold' };

export const objectLook = (object) => (object.found ? OBJECT.found : OBJECT.missing);

/** Black or white, whichever is read better on a colour (contrast of WCAG 2). */
export function inkOn(colour) {
  const linear = [1, 3, 5].map((i) => (parseInt(colour.slice(i, i + 2), 16) / 255 + 0.055) / 1.055).map((v) => v ** 2.4);
  const brightness = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  return 1.05 / (brightness + 0.05) > (brightness + 0.05) / 0.05 ? '#ffffff' : '#0b0f14';
}

/** A colour of the style sheet, for what the style sheet does not reach. */
export const themed = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
