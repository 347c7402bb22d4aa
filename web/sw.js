// The service worker: caches the files of one build, so that Batten opens without a network or a server, and beside them what was
// seen of the manual. A newer build waits until the user accepts it; an older one stays cached as long as a page of it lives.
// The build fills in its folder and its list of files, each with its digest.

/** The SHA-256 of each file. @type {Map<string, string>} */
const FILES = new Map('%FILES%'.split(' ').map((row) => /** @type {[string, string]} */ (row.split(':'))));

const worker = /** @type {any} */ (self);
/** @type {string} */
const scope = worker.registration.scope;
const OURS = `batten ${scope} `; // several sites may have one origin, and it has one set of caches
const CACHE = `${OURS}%BUILD%`;
const LOOPBACK = ['127.0.0.1', 'localhost', '[::1]'].includes(location.hostname);

/** Fetches a file of this build; throws when it is not there, or another. @param {string} file @returns {Promise<[string, Response]>} */
async function take(file) {
  const response = await fetch(new Request(scope + file, { cache: 'no-store' }));
  const bytes = await response.arrayBuffer();
  const digest = Array.from(new Uint8Array(await crypto.subtle.digest('SHA-256', bytes)), (byte) => byte.toString(16).padStart(2, '0'));
  if (!response.ok || digest.join('') !== FILES.get(file)) {
    throw new Error(`${file} is not of this build`);
  }
  return [scope + file, new Response(bytes, { headers: response.headers })]; // made anew: a page that was redirected would be refused
}

/** Caches all files or none: what is incomplete would take the room of drawings. */
async function install() {
  const files = await Promise.all([...FILES.keys()].map(take));
  try {
    const cache = await caches.open(CACHE);
    await Promise.all(files.map(([address, response]) => cache.put(address, response)));
  } catch (error) {
    await caches.delete(CACHE);
    throw error;
  }
}

/** Deletes the caches of builds of which no page lives: a page holds the lock of its cache's name (page/build.js). */
async function sweep() {
  for (const name of await caches.keys()) {
    if (name.startsWith(OURS) && name !== CACHE) {
      await navigator.locks.request(name, { ifAvailable: true }, async (lock) => {
        const { installing, waiting } = worker.registration; // a newer build may have no page yet
        return lock && !installing && !waiting && caches.delete(name);
      });
    }
  }
}

async function activate() {
  await worker.clients.claim();
  await sweep();
}

/** Leaves this address: no worker, nothing cached. */
async function forget() {
  await worker.registration.unregister();
  for (const name of await caches.keys()) {
    if (name.startsWith(OURS)) {
      await caches.delete(name);
    }
  }
}

/** @param {string} file @returns {Promise<Response | undefined>} */
const cached = (file) => caches.match(scope + file, { cacheName: CACHE }).catch(() => undefined);

/** The page of this build. The token of a running `batten edit` is inserted anew each time and never cached. */
async function page() {
  const own = await cached('index.html');
  const live = !own || LOOPBACK ? await fetch(scope, { cache: 'no-store' }).catch(() => null) : null;
  if (!live?.ok) {
    return own ?? live ?? Response.error();
  }
  const text = await live.clone().text();
  const token = /name="batten-token" content="([^"]*)"/.exec(text)?.[1];
  if (!own || token === undefined) {
    await forget(); // the browser has dropped what was cached, or another program uses this address now
    return live;
  }
  return new Response((await own.text()).replace('%TOKEN%', token), { headers: own.headers });
}

/** A file of this build or, for an older page, of that page's. @param {Request} request @param {string} file */
async function fileFor(request, file) {
  return await (FILES.has(file) ? cached(file) : caches.match(scope + file)) ?? fetch(request);
}

/**
 * A page of the manual, or what it shows: as it is now, and without a network as it was last seen.
 * @param {Request} request @param {string} file
 */
async function manual(request, file) {
  const response = await fetch(request).catch(() => null);
  if (!response?.ok) {
    return await cached(file) ?? response ?? Response.error();
  }
  const kept = response.clone();
  caches.open(CACHE).then((cache) => cache.put(scope + file, kept)).catch(() => {}); // where there is no room it is not kept
  return response;
}

/** What a page may ask for. @type {Record<string, () => Promise<unknown>>} */
const ORDERS = { use: () => worker.skipWaiting(), sweep, forget };

worker.oninstall = (/** @type {any} */ event) => event.waitUntil(install());
worker.onactivate = (/** @type {any} */ event) => event.waitUntil(activate());
worker.onmessage = (/** @type {any} */ event) => event.waitUntil(ORDERS[event.data]?.());
worker.onfetch = (/** @type {any} */ event) => {
  const [address] = event.request.url.split(/[?#]/);
  if (event.request.method !== 'GET' || !address.startsWith(scope)) {
    return;
  }
  const file = address.slice(scope.length);
  if (file === '') {
    event.respondWith(page());
  } else if (file.startsWith('manual/')) {
    event.respondWith(manual(event.request, file));
  } else if (FILES.has(file) || file.includes('/')) {
    event.respondWith(fileFor(event.request, file));
  }
};
