// Offline: the page can be installed and opens without a server; a newer build is offered, never slipped in.

import { Notice } from './notice.js';
import { word } from './words.js';

/** @param {() => Promise<void>} leave all that is not saved is on the disk, and the page may go */
export async function settle(leave) {
  const link = document.createElement('link');
  link.rel = 'manifest';
  link.href = 'manifest.webmanifest';
  document.head.append(link);
  const workers = navigator.serviceWorker;
  if (!workers) {
    return;
  }
  const notice = new Notice('update');
  let controlled = workers.controller !== null;

  /** @param {ServiceWorker | null} waiting */
  const offer = (waiting) => notice.say(word('shell.update'), { label: word('shell.update-now'), run: async () => {
    await leave();
    if (waiting?.state === 'installed') {
      workers.addEventListener('controllerchange', () => location.reload());
      waiting.postMessage('use');
    } else {
      location.reload();
    }
  } });

  workers.addEventListener('controllerchange', () => {
    if (controlled) {
      offer(null); // another tab has changed over
    }
    controlled = true;
  });
  const registration = await workers.register('sw.js', { updateViaCache: 'none' });
  const watch = () => {
    const next = registration.installing;
    next?.addEventListener('statechange', () => {
      if (next.state === 'installed' && workers.controller) {
        offer(next);
      }
    });
  };
  registration.addEventListener('updatefound', watch);
  watch();
  if (registration.waiting && workers.controller) {
    offer(registration.waiting);
  }
  document.addEventListener('visibilitychange', () => {
    if (!document.hidden) {
      registration.update().catch(() => {}); // no server: no news
    }
  });
}
