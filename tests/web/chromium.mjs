// How Chromium is started for tests.
import fs from 'node:fs';

/** Milliseconds: a test step that takes longer counts as hanging, however busy the machine. */
export const HANG = 90000;

/**
 * Features of Chromium that are off: those that Playwright puts off (the last such flag replaces all before it), and pages of
 * the address bar that no window here shows and that cost as much as opening the editor.
 */
const OFF = ['AvoidUnnecessaryBeforeUnloadCheckSync', 'BoundaryEventDispatchTracksNodeRemoval', 'DestroyProfileOnBrowserClose',
  'DialMediaRouteProvider', 'GlobalMediaControls', 'HttpsUpgrades', 'LensOverlay', 'MediaRouter', 'PaintHolding',
  'ThirdPartyStoragePartitioning', 'Translate', 'AutoDeElevate', 'RenderDocument', 'OptimizationHints',
  'WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'WebUIOmniboxFullPopup', 'PreloadTopChromeWebUI'];

/** Chromium with its windows, for what only those have: settings of a site, dialogs. */
export const WINDOWED = process.env.BATTEN_CHROMIUM ?? '/usr/bin/chromium';
/** The same engine without windows, which opens a page in half the time, where it is installed. */
const SHELL = '/usr/bin/chromium-headless-shell';

export const BROWSER = {
  timeout: HANG,
  executablePath: process.env.BATTEN_CHROMIUM ?? (fs.existsSync(SHELL) ? SHELL : WINDOWED),
  headless: true,
  args: ['--disable-gpu', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--font-render-hinting=none',
    '--js-flags=--wasm-enforce-bounds-checks', // else an access out of the module's memory ends the page, which has no handler of such
    `--disable-features=${OFF.join()}`],
};
