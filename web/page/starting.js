// Watches the start of the page and says what failed, with a way out. The build puts this script into index.html itself, for every
// other file may be missing; it is written for old browsers, too.

(function () {
  var LATE = 15000; // milliseconds after which the start takes long
  var PATIENCE = 5000; // that a new attempt waits for the server and the browser's stores
  var root = document.documentElement;
  var scope = location.href.replace(/[?#].*/, '').replace(/[^/]*$/, '');
  /** Files that did not load. @type {string[]} */
  var missing = [];
  var failed = false;
  var late = false;
  var what = '';

  function show() {
    var box = document.getElementById('failed');
    if (!box || !box.nextSibling) {
      return; // the page is not read that far: what stands in the box may still be missing
    }
    var ready = Boolean(root.dataset.ready);
    box.hidden = ready || !(failed || late);
    if (!box.hidden) {
      part('failed-start').hidden = !failed;
      part('failed-late').hidden = failed;
      part('failed-what').textContent = missing.length ? '(' + missing.slice(0, 3).join(', ') + ')' : what;
      part('failed-again').onclick = again;
    }
  }

  /** @param {string} id */
  function part(id) {
    return /** @type {HTMLButtonElement} */ (document.getElementById(id));
  }

  /** The path of a file of this build, without its folder; '' for others. @param {string} address */
  function nameOf(address) {
    return address.slice(0, scope.length) === scope ? address.slice(scope.length).replace(/^[^/]*\//, '') : '';
  }

  /** An uncaught error, or a file that an element of the page did not get. @param {any} event */
  function fail(event) {
    var target = event.target;
    if (root.dataset.ready) {
      return;
    }
    if (target === window) {
      if (event.filename && !nameOf(event.filename) && event.filename !== location.href) {
        return; // of an extension of the browser
      }
      failed = true;
      what = event.message.replace(/^Uncaught /, '') + (nameOf(event.filename || '') ? ' (' + nameOf(event.filename) + ')' : '');
    } else if (/^(LINK|SCRIPT)$/.test(target.tagName)) {
      var name = nameOf(target.href || target.src);
      failed = failed || name === 'main.js';
      target.dataset.missing = 'yes'; // page/whole.js asks for it
      if (missing.indexOf(name) < 0) {
        missing.push(name);
      }
    }
    show();
  }

  /** @param {Promise<any>[]} works @returns {Promise<any>} when all have ended, whatever came of them */
  function all(works) {
    return Promise.all(works.map(function (work) {
      return work.catch(function () {});
    }));
  }

  /** Makes the browser forget the service worker of this page and the files that it has cached, but nothing that was drawn. */
  function forget() {
    return all([
      navigator.serviceWorker.getRegistration().then(function (registration) {
        return registration && registration.scope === scope && registration.unregister();
      }),
      caches.keys().then(function (names) {
        return all(names.filter(function (name) {
          return name.indexOf('batten ' + scope + ' ') === 0;
        }).map(function (name) {
          return caches.delete(name);
        }));
      })
    ]);
  }

  /** Fetches everything once more past the browser's cache. */
  function refetch() {
    var addresses = performance.getEntriesByType('resource').map(function (entry) {
      return entry.name;
    });
    document.querySelectorAll('link[href], script[src]').forEach(function (/** @type {any} */ element) {
      addresses.push(element.href || element.src);
    });
    addresses.push(location.href.replace(/#.*/, ''));
    return all(addresses.filter(function (address, i) {
      return address.indexOf(scope) === 0 && addresses.indexOf(address) === i;
    }).map(function (address) {
      return fetch(address, { cache: 'reload' });
    }));
  }

  /** Begins anew. Without an answer from the server, what the browser has cached is better than nothing. */
  function again() {
    function reload() {
      location.reload();
    }
    part('failed-again').disabled = true;
    setTimeout(reload, PATIENCE);
    fetch(scope + 'sw.js', { cache: 'no-store' }).then(function () {
      return 'serviceWorker' in navigator && 'caches' in window && forget();
    }).then(refetch).then(reload, reload);
  }

  addEventListener('error', fail, true);
  document.addEventListener('DOMContentLoaded', show);
  setTimeout(function () {
    late = true;
    show();
  }, LATE);
  new MutationObserver(show).observe(root, { attributes: true, attributeFilter: ['data-ready'] });
})();
