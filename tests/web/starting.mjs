// What the tests of a start share: what the page says of it, its build, and what the browser has cached.
import assert from 'node:assert/strict';
import { bezier, expectFaults, GONE, open, place, ready, state, until } from './page.mjs';
import { serve } from './server.mjs';

const SKY = bezier([60, 60], [140, 20], [220, 100], [320, 60]);

export const exactly = (file) => new RegExp(`^${file.replaceAll('.', '\\.')}$`);
export const controlled = (page) => page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
export const version = (page) => page.evaluate(() => document.querySelector('script[src]').getAttribute('src').split('/')[0]);
export const caches = (page) => page.evaluate(async () => (await globalThis.caches.keys()).map((name) => name.split(' ').at(-1)).sort());

/** What the page says of its start, once it says this of it, too: a page that is left can still be looked at for a moment. */
export async function said(page, words = '') {
  const text = await page.waitForFunction((awaited) => {
    const box = document.getElementById('failed');
    return box?.checkVisibility() && box.innerText.includes(awaited) && box.innerText;
  }, words);
  return text.jsonValue();
}

/** Waits until the page's worker has looked for a newer one, and what came of it. */
export const updated = (page) => page.evaluate(async () => {
  const registration = await navigator.serviceWorker.getRegistration();
  await registration.update();
  const next = registration.installing;
  if (next) {
    await new Promise((done) => next.addEventListener('statechange', done, { once: true }));
  }
  return next?.state ?? '';
});

export async function tryAgain(page) {
  await Promise.all([page.waitForEvent('load'), page.click('#failed-again')]);
  await ready(page);
  assert.equal(await page.isVisible('#failed'), false);
}

/** A server and a context of a browser that knows nothing of it. @param {boolean} [lasting] whether the browser keeps the page's files */
export async function begun(t, browser, options = {}, lasting = true) {
  const server = await serve(undefined, lasting);
  t.after(() => server.close());
  expectFaults(/status of 404/, ...GONE);
  return { server, context: await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options }) };
}

/** A page with a drawing and its worker. */
export async function kept(t, browser) {
  const { server, context } = await begun(t, browser);
  const { page, hand } = await open(context, server.address);
  await controlled(page);
  await hand.stroke(await Promise.all(SKY.map(([x, y]) => place(page, x, y))));
  await page.evaluate(() => batten.keeper.settled());
  return { server, context, page, hand, drawn: (await state(page)).digest };
}

/** Makes the page one of a new visitor again, once its worker is there. */
export async function forgotten(page) {
  await controlled(page);
  await page.evaluate(() => navigator.serviceWorker.controller.postMessage('forget'));
  await until(page, async () => !await navigator.serviceWorker.getRegistration() && (await globalThis.caches.keys()).length === 0);
}
