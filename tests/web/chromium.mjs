// How Chromium is started for tests.

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

export const BROWSER = {
  timeout: HANG,
  executablePath: process.env.BATTEN_CHROMIUM ?? '/usr/bin/chromium',
  headless: true,
  args: ['--disable-gpu', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', `--disable-features=${OFF.join()}`],
};
