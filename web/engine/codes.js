// Numbers that the engine and its host have in common: made of the headers by tests/house/check_codes.py.

/** Of events of a pointer. */
export const Phase = Object.freeze({ HOVER: 0, DOWN: 1, MOVE: 2, UP: 3, CANCEL: 4, LEAVE: 5 });
export const Device = Object.freeze({ MOUSE: 0, PEN: 1, TOUCH: 2 });
/** Keys that are held. */
export const Modifier = Object.freeze({ SHIFT: 1, CTRL: 2, ALT: 4, META: 8 });
/** What an item of a picture is. */
export const Role = Object.freeze({ OBJECT: 0, HIGHLIGHT: 1, STRETCH: 2, TRANSITION: 3, INK: 4, FIT: 5, PREDICTED: 6,
  KNOT: 7, PAGE: 8, PENDING: 9, SELECTION: 10, HANDLE: 11, MARQUEE: 12, GHOST: 13, POINT: 14, CHOSEN: 15, PROMPT: 16,
  ARROW: 17, WEDGE: 18, BEYOND: 19, GUIDE: 20, VALUE: 21, POLYGON: 22, COMB: 23, REACH: 24, ERASED: 25, IMAGE: 26,
  GRID: 27, GRID_STRONG: 28, RULER: 29, GUIDELINE: 30, PAGE_BACK: 31, PIVOT: 32, GROUP: 33, CLIP: 34, AXIS_X: 35,
  AXIS_Y: 36, AXIS_Z: 37 });
/** How an item is painted. */
export const Flag = Object.freeze({ STROKED: 1, FILLED: 2, EVEN_ODD: 4, SCREEN_WIDTH: 8, DASHED: 16,
  STROKE_FIRST: 32 });
/** Commands of a path. */
export const Path = Object.freeze({ MOVE: 0, LINE: 1, CUBIC: 2, CLOSE: 3 });
export const Cap = Object.freeze({ BUTT: 0, ROUND: 1, SQUARE: 2 });
export const Join = Object.freeze({ MITER: 0, ROUND: 1, BEVEL: 2 });
export const Cursor = Object.freeze({ CROSS: 0, PEN: 1, GRAB: 2, GRABBING: 3, WAIT: 4, ARROW: 5, MOVE: 6,
  RESIZE_EW: 7, RESIZE_NS: 8, RESIZE_NWSE: 9, RESIZE_NESW: 10, ZOOM_IN: 11, ZOOM_OUT: 12 });
/** What is done to a level. */
export const Act = Object.freeze({ CHOOSE: 0, GAIN: 1, MUTE: 2, SOLO: 3 });
/** Flags: what the host is asked to do. */
export const Ask = Object.freeze({ SAVE: 1, DOWNLOAD_SVG: 2, DOWNLOAD_NATIVE: 4, OPEN: 8, JOURNAL: 16, CUT: 32,
  COPY: 64, PASTE: 128, SPAN: 256, SHORTCUTS: 512, REGION: 1024, REGION_BACK: 2048, KEPT: 4096, LOSSES: 8192,
  EXPORT: 16384, HISTORY: 32768, WIDTH: 65536, SIZE: 131072, SAVE_AS: 262144, EXPORT_AGAIN: 524288,
  COPY_PICTURE: 1048576, TEXT: 2097152 });

/**
 * Its names in small letters, each at its number.
 * @param {Record<string, number>} family
 */
export const names = (family) => {
  /** @type {string[]} */
  const list = [];
  for (const [name, number] of Object.entries(family)) list[number] = name.toLowerCase();
  return list;
};
