// The service worker: caches exactly the files of one build, so that Batten opens without a network or a server. A
// newer build waits until the user accepts it. The build fills in its folder and its list of files.

const FILES = '%FILES%'.split(' ');

const worker = /** @type {any} */ (self);
/** @type {string} */
const scope = worker.registration.scope;
const OURS = `batten ${scope} `; // several sites may have one origin, and it has one set of caches
const CACHE = `${OURS}%BUILD%`;
const LOOPBACK = ['127.0.0.1', 'localhost', '[::1]'].includes(location.hostname);

async function install() {
  const cache = await caches.open(CACHE);
  await cache.addAll(FILES.map((file) => new Request(file, { cache: 'no-store' })));
}

async function activate() {
  for (const name of await caches.keys()) {
    if (name.startsWith(OURS) && name !== CACHE) {
      await caches.delete(name);
    }
  }
  await worker.clients.claim();
}

/** @param {string} file */
async function kept(file) {
  return await (await caches.open(CACHE)).match(scope + file) ?? fetch(scope + file);
}

/** The page of this build. The token of a running `batten edit` is inserted anew each time and never cached. */
async function page() {
  const own = await kept('index.html');
  const live = LOOPBACK ? await fetch(scope, { cache: 'no-store' }).catch(() => null) : null;
  if (!live?.ok) {
    return own;
  }
  const text = await live.clone().text();
  const token = /name="batten-token" content="([^"]*)"/.exec(text)?.[1];
  if (token === undefined) {
    await worker.registration.unregister(); // another program uses this address now
    return live;
  }
  return new Response((await own.text()).replace('%TOKEN%', token), { headers: own.headers });
}

worker.oninstall = (/** @type {any} */ event) => event.waitUntil(install());
worker.onactivate = (/** @type {any} */ event) => event.waitUntil(activate());
worker.onmessage = (/** @type {MessageEvent} */ event) => event.data === 'use' && worker.skipWaiting();
worker.onfetch = (/** @type {any} */ event) => {
  const [address] = event.request.url.split(/[?#]/);
  if (event.request.method !== 'GET' || !address.startsWith(scope)) {
    return;
  }
  const file = address.slice(scope.length);
  if (file === '') {
    event.respondWith(page());
  } else if (FILES.includes(file)) {
    event.respondWith(kept(file));
  }
};
