// Offline: the page can be installed and opens without a server; a newer build is offered, never installed silently.

import { word } from '../page/words.js';

const SLOW = 1500; // milliseconds: a browser may keep the old worker, which has nothing to do, until a page loads

/**
 * @param {import('../page/notice.js').Notices} notices
 * @param {() => Promise<void>} pack prepares the page to be closed
 */
export async function settle(notices, pack) {
  if (!isSecureContext) {
    notices.ask('insecure', word('shell.insecure'), []);
  }
  const link = document.createElement('link');
  link.rel = 'manifest';
  link.href = 'manifest.webmanifest';
  document.head.append(link);
  const workers = navigator.serviceWorker;
  if (!workers) {
    return;
  }
  let controlled = workers.controller !== null;

  /** @param {ServiceWorker | null} waiting */
  const offer = (waiting) => notices.ask('update', word('shell.update'), [{ label: word('shell.update-now'), run: async () => {
    await pack();
    if (waiting?.state === 'installed') {
      const late = setTimeout(() => location.reload(), SLOW);
      workers.addEventListener('controllerchange', () => {
        clearTimeout(late);
        location.reload();
      });
      waiting.postMessage('use');
    } else {
      location.reload();
    }
  } }]);

  workers.addEventListener('controllerchange', () => {
    if (controlled) {
      offer(null); // another tab has switched to it
    }
    controlled = true;
  });
  const registration = await workers.register('sw.js', { updateViaCache: 'none' }).catch(() => null);
  if (!registration) {
    return; // the browser does not allow service workers here
  }
  registration.active?.postMessage('sweep'); // the page that was here before is gone
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
      registration.update().catch(() => {}); // no server, no update
    }
  });
}
