// Numbers that the engine and its host have in common.

export const Phase = Object.freeze({ HOVER: 0, DOWN: 1, MOVE: 2, UP: 3, CANCEL: 4, LEAVE: 5 });
export const Device = Object.freeze({ MOUSE: 0, PEN: 1, TOUCH: 2 });
export const Modifier = Object.freeze({ SHIFT: 1, CTRL: 2, ALT: 4, META: 8 });
export const Ask = Object.freeze({ SAVE: 1, DOWNLOAD_SVG: 2, DOWNLOAD_NATIVE: 4, OPEN: 8, JOURNAL: 16,
  CUT: 32, COPY: 64, PASTE: 128, SPAN: 256, SHORTCUTS: 512, REGION: 1024, REGION_BACK: 2048, KEPT: 4096, LOSSES: 8192 });
