// Text that a file brings, where it is plain: one font, one colour, lines that stand where lines do. Fetched with the first that is
// double clicked. The page's policy lets no style of a file be parsed: style attributes are read here.

/** @typedef {import('./writing.js').Text} Text */

const ALONE = 'svg, g, a, text, tspan, defs, defs *, title, desc, metadata, metadata *';
/** What would be lost; of each property, the values that say nothing. @type {Record<string, RegExp>} */
const SILENT = {
  'text-decoration': /^none$/, 'text-decoration-line': /^none$/, 'baseline-shift': /^(0|baseline)$/, 'word-spacing': /^(normal|0(px)?)$/,
  'font-variant': /^normal$/, 'font-stretch': /^(normal|100%)$/, 'writing-mode': /^(lr(-tb)?|horizontal-tb)$/, 'stroke': /^none$/,
  'filter': /^none$/, 'mask': /^none$/, 'clip-path': /^none$/, 'dominant-baseline': /^(auto|alphabetic)$/, 'direction': /^ltr$/, 'font': /^$/,
  'text-transform': /^none$/, 'font-kerning': /^(auto|normal)$/, 'font-feature-settings': /^normal$/, 'inline-size': /^(0|auto)$/,
  'shape-inside': /^(auto|none)$/, 'mix-blend-mode': /^normal$/,
};
const BARRED = ['rotate', 'textLength', 'dx', 'class'];
/** Pixels of a unit. @type {Record<string, number>} */
const UNITS = { '': 1, 'px': 1, 'pt': 4 / 3, 'mm': 96 / 25.4, 'cm': 96 / 2.54, 'in': 96, 'pc': 16 };

/** @param {string} value @returns {number} NaN: it depends on something else */
function length(value) {
  const [, number, unit] = /^([-+.\de]+)([a-z%]*)$/i.exec(value.trim()) ?? [];
  return Number(number) * (UNITS[unit] ?? NaN);
}

/** What an element says itself. @param {Element} element @param {string} name */
function own(element, name) {
  const [, said] = new RegExp(`(?:^|;)\\s*${name}\\s*:([^;]*)`).exec(element.getAttribute('data-style') ?? '') ?? [];
  return said?.replace(/!\s*important/, '').trim() || element.getAttribute(name) || '';
}

/** What it has from those around it. @param {Element | null} element @param {string} name @returns {string} */
const inherited = (element, name) => (element ? own(element, name) || inherited(element.parentElement, name) : '');

/** @param {Element} text */
const around = (text) => {
  const way = [];
  for (let at = /** @type {Element | null} */ (text); at; at = at.parentElement) {
    way.push(at);
  }
  return way;
};

/** @param {string} words @param {boolean} kept as they are */
const spaced = (words, kept) => (kept ? words.replace(/[\n\t]/g, ' ') : words.replace(/\n/g, '').replace(/[ \t]+/g, ' ').trim());

/**
 * The lines of a text, and how far apart they stand; null: there is more to it.
 * @param {Element} text @param {number[]} at @param {number} size
 */
function linesOf(text, at, size) {
  const kept = text.getAttribute('xml:space') === 'preserve' || /^pre/.test(inherited(text, 'white-space'));
  const spans = [...text.children];
  if (spans.length === 0) {
    return { lines: [spaced(text.textContent ?? '', kept)], line: 1.2 };
  }
  const loose = [...text.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim());
  if (loose || spans.some((span) => span.children.length || (spans.length > 1 && !span.hasAttribute('x')))) {
    return null;
  }
  let y = at[1];
  const steps = spans.map((span, i) => {
    const x = span.getAttribute('x');
    const dy = span.getAttribute('dy') ?? '0';
    const before = y;
    y = (span.hasAttribute('y') ? length(span.getAttribute('y') ?? '') : y) + (dy.endsWith('em') ? Number.parseFloat(dy) * size : length(dy));
    at[1] = i ? at[1] : y;
    return x !== null && length(x) !== at[0] ? NaN : y - before;
  }).slice(1);
  const even = steps.every((step) => step > 0 && Math.abs(step - steps[0]) < 1e-3 * size);
  return even && Number.isFinite(y) ? { lines: spans.map((span) => spaced(span.textContent ?? '', kept)), line: steps.length ? steps[0] / size : 1.2 } : null;
}

/**
 * A picture of foreign content as a text, if it is nothing but that; its units are those in which it was written.
 * @param {Uint8Array} bytes @returns {{ text: Partial<Text>, inner: DOMMatrix } | null} inner: from its units to the picture's pixels
 */
export function plainOf(bytes) {
  const source = new TextDecoder().decode(bytes);
  if (/<([\w-]+:)?style[\s>]/.test(source)) {
    return null;
  }
  const apart = source.replace(/<[^!?][^>]*>/g, (tag) => tag.replace(/(\s)style(\s*=)/, '$1data-style$2'));
  const file = new DOMParser().parseFromString(apart, 'image/svg+xml');
  const root = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (file.documentElement));
  const [text, ...more] = file.querySelectorAll('text');
  if (!text || more.length || [...file.querySelectorAll('*')].some((one) => !one.matches(ALONE))) {
    return null;
  }
  const way = around(text);
  const all = [...way, ...text.children];
  const exotic = all.some((one) => BARRED.some((name) => one.hasAttribute(name)) ||
    Object.entries(SILENT).some(([name, silent]) => own(one, name) && !silent.test(own(one, name))));
  const differs = [...text.children].some((span) => ['font-family', 'font-size', 'font-weight', 'font-style', 'letter-spacing', 'fill', 'text-anchor', 'opacity']
    .some((name) => own(span, name) && own(span, name) !== inherited(text, name)));
  const size = length(inherited(text, 'font-size') || '16');
  const at = ['x', 'y'].map((name) => length(text.getAttribute(name) ?? '0'));
  const said = exotic || differs ? null : linesOf(text, at, size);
  const paint = document.createElement('canvas').getContext('2d');
  const opacity = way.reduce((product, one) => product * Number(own(one, 'opacity') || 1), 1);
  const fill = inherited(text, 'fill') || '#000000';
  if (!said || !paint || opacity !== 1 || !(size > 0) || !at.every(Number.isFinite) || /url|none|context|current/i.test(fill)) {
    return null;
  }
  paint.fillStyle = '#010203';
  paint.fillStyle = fill;
  if (!/^#[\da-f]{6}$/i.test(String(paint.fillStyle)) || (paint.fillStyle === '#010203' && fill !== '#010203')) {
    return null;
  }
  const alpha = Math.round(255 * Number(inherited(text, 'fill-opacity') || 1));
  const weight = inherited(text, 'font-weight') || '400';
  const spacing = inherited(text, 'letter-spacing') || '0';
  const { x, y, width, height } = root.viewBox.baseVal;
  const inner = new DOMMatrix().scale(root.width.baseVal.value / width, root.height.baseVal.value / height).translate(-x, -y);
  for (const one of way.reverse()) {
    const list = /** @type {SVGGraphicsElement} */ (one).transform?.baseVal;
    const moved = one === root || one.localName === 'svg' ? null : list?.consolidate()?.matrix;
    if (moved) {
      inner.multiplySelf(moved);
    }
  }
  return {
    inner,
    text: {
      text: said.lines.join('\n'), line: said.line, size, at: [at[0], at[1]],
      family: inherited(text, 'font-family') || 'serif',
      weight: { normal: 400, bold: 700 }[weight] ?? (Number(weight) || 400),
      italic: /italic|oblique/.test(inherited(text, 'font-style')),
      spacing: spacing === 'normal' ? 0 : length(spacing) || 0,
      align: /** @type {Text['align']} */ ({ start: 'start', middle: 'middle', end: 'end' }[inherited(text, 'text-anchor')] ?? 'start'),
      fill: `${paint.fillStyle}${alpha.toString(16).padStart(2, '0')}`,
    },
  };
}
