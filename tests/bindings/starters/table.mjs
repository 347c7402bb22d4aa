// What a new project is for each bundler, framework and runtime: its packages, its files, and the commands that its developer types.
// No settings of ours are among them.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const docs = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../../docs');
const SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200"><path d="M50 50H250V150H50Z" fill="none" stroke="black"/></svg>';

/** Lines that both a page and a script have: a curve is fitted and told. */
const fit = (word) => `const b = await load();
const curve = b.fit([[0, 0], [10, 8], [20, 10], [30, 8], [40, 0]], { tolerance: 0.5 });
tell('core', '${word} ' + curve.toSVG());`;
const TELL = "const tell = (what, text) => { (globalThis.told ??= {})[what] = text; };\n";
const WORKER = `import { load } from 'batten-core/sketch';
onmessage = async () => {
  const b = await load();
  postMessage(b.fit([[0, 0], [10, 8], [20, 10], [30, 8], [40, 0]], { tolerance: 0.5 }).toSVG());
};
`;
const worker = (address) => `const worker = new Worker(${address}, { type: 'module' });
worker.onmessage = ({ data }) => tell('worker', data);
worker.onerror = ({ message }) => tell('worker', 'failed: ' + message);
worker.postMessage('');`;
const EDITOR = `const editor = document.createElement('batten-editor');
editor.addEventListener('ready', ({ detail }) => tell('editor', detail.svg));
editor.addEventListener('error', ({ detail }) => tell('editor', 'failed: ' + detail.message));
editor.load('${SVG}');
document.body.append(editor);`;
const BESIDE = "new URL('./worker.js', import.meta.url)";

/** The page's script: a curve in the page, one in a worker, and the editor. */
const page = (word, address = BESIDE) => `import { load } from 'batten-core';
import 'batten-editor';
${TELL}${EDITOR}
${worker(address)}
${fit(word)}
`;
const html = (tag) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>A page</title><link rel="icon" href="data:,"><body>${tag}</body></html>\n`;
const module = (src) => html(`<div id="app"></div><script type="module" src="${src}"></script>`);

/** The sample of this name in a page of the docs: what a reader copies. */
function sample(doc, file) {
  const found = new RegExp(`\`${file.replace('.', '\\.')}\`[^]*?\`\`\`\\w*\\n([^]*?)\`\`\``).exec(fs.readFileSync(path.join(docs, doc), 'utf8'));
  if (!found) {
    throw new Error(`${doc} has no ${file}`);
  }
  return found[1];
}

/** Vite, with what differs from version to version. */
const vite = (version) => ({
  packages: [`vite@${version}`],
  files: { 'index.html': module('/main.js'), 'worker.js': WORKER },
  main: 'main.js',
  text: page,
  dev: ['vite', '--port', 'PORT', '--strictPort', '--host', '127.0.0.1'],
  build: ['vite', 'build'],
  out: 'dist',
});

/** A framework of Vite: the wrapper is what the docs say. */
const framed = (packages, doc, names, main, text) => ({
  ...vite(7),
  packages: ['vite@7', ...packages],
  get files() {
    return { 'index.html': module(`/${main}`), ...Object.fromEntries(names.map((name) => [name, sample(doc, name)])) };
  },
  main,
  component: true,
  text: (word) => `globalThis.told = { core: '${word}' };\n${text}`,
});

/** A script that a runtime runs. */
const script = (command, ...packages) => ({
  packages,
  script: command,
  files: { 'worker.mjs': `import { parentPort } from 'node:worker_threads';
import { load } from 'batten-core/levels';
const b = await load();
parentPort.postMessage(b.fit([[0, 0], [5, 5], [10, 0]]).toSVG());
` },
  main: 'main.mjs',
  text: scripted,
});

/** @type {Record<string, any>} */
export const STARTERS = {
  vite7: vite(7),
  vite8: vite(8),
  webpack: {
    packages: ['webpack@5', 'webpack-cli', 'webpack-dev-server'],
    files: { 'public/index.html': html('<script src="main.js"></script>'), 'src/worker.js': WORKER },
    main: 'src/index.js',
    text: page,
    dev: ['webpack', 'serve', '--mode', 'development', '--port', 'PORT', '--host', '127.0.0.1'],
    build: ['webpack', '--mode', 'production'],
    page: 'public/index.html',
    out: 'dist',
  },
  esbuild: {
    packages: ['esbuild'],
    files: { 'www/index.html': module('main.js'), 'worker.js': WORKER },
    main: 'main.js',
    text: (word) => page(word, "'worker.js'"),
    dev: ['esbuild', 'main.js', 'worker.js', '--bundle', '--format=esm', '--outdir=www', '--servedir=www', '--serve=127.0.0.1:PORT', '--watch=forever'],
    build: ['esbuild', 'main.js', 'worker.js', '--bundle', '--minify', '--format=esm', '--splitting', '--outdir=www'],
    reloads: true,
    out: 'www',
  },
  'esbuild-iife': {
    packages: ['esbuild'],
    files: { 'www/index.html': html('<script src="main.js"></script>'), 'worker.js': WORKER },
    main: 'main.js',
    text: (word) => `(async () => {\n${page(word, "'worker.js'").replace(/^import .*\n/gm, '')}})();\n`.replace(/^/, "import { load } from 'batten-core';\nimport 'batten-editor';\n").replace(", { type: 'module' }", ''),
    build: ['esbuild', 'main.js', 'worker.js', '--bundle', '--minify', '--outdir=www'],
    out: 'www',
  },
  rollup: {
    packages: ['rollup', '@rollup/plugin-node-resolve'],
    files: { 'www/index.html': module('main.js'), 'worker.js': WORKER },
    main: 'main.js',
    text: (word) => page(word, "'worker.js'"),
    watch: ['rollup', 'main.js', 'worker.js', '--dir', 'www', '--format', 'es', '--plugin', 'node-resolve', '--watch'],
    build: ['rollup', 'main.js', 'worker.js', '--dir', 'www', '--format', 'es', '--plugin', 'node-resolve'],
    reloads: true,
    out: 'www',
  },
  plain: {
    packages: [],
    files: {
      'index.html': html(`<script type="importmap">{ "imports": { "batten-core": "/node_modules/batten-core/index.js", "batten-editor": "/node_modules/batten-editor/index.js" } }</script>
<script type="module" src="main.js"></script>`),
      'worker.js': WORKER.replace('batten-core/sketch', './node_modules/batten-core/sketch.js'),
    },
    main: 'main.js',
    text: page,
    reloads: true,
    out: '.',
  },
  next: {
    packages: ['next', 'react', 'react-dom'],
    files: {
      'app/layout.js': 'export default function Layout({ children }) {\n  return <html lang="en"><body>{children}</body></html>;\n}\n',
      'app/worker.js': WORKER,
      'app/page.js': "import Drawing from './drawing.js';\nimport { load } from 'batten-core';\nexport default async function Page() {\n  const b = await load();\n  return <main id=\"server\">{b.fit([[0, 0], [5, 5], [10, 0]]).toSVG()}<Drawing /></main>;\n}\n",
    },
    main: 'app/drawing.js',
    begun: "'use client';\nexport default function Drawing() {\n  return <p>begun</p>;\n}\n",
    text: (word) => `'use client';
import { useEffect } from 'react';
import { load } from 'batten-core';
import 'batten-editor';
${TELL}async function begin() {
${page(word).replace(/^import .*\n|^const tell.*\n/gm, '')}}
export default function Drawing() {
  useEffect(() => { begin(); }, []);
  return <p>here</p>;
}
`,
    dev: ['next', 'dev', '--port', 'PORT', '--hostname', '127.0.0.1'],
    build: ['next', 'build'],
    start: ['next', 'start', '--port', 'PORT', '--hostname', '127.0.0.1'],
    also: 'server',
  },
  node: script(['node', 'main.mjs']),
  deno: script(['deno', 'run', '--allow-read', 'main.mjs'], 'deno'),
  react: framed(['@vitejs/plugin-react@5', 'react', 'react-dom'], 'react.md', ['Drawing.jsx', 'Curve.jsx', 'App.jsx', 'vite.config.js'], 'main.jsx',
    "import { createRoot } from 'react-dom/client';\nimport App from './App.jsx';\ncreateRoot(document.getElementById('app')).render(<App />);\n"),
  vue: framed(['@vitejs/plugin-vue@6', 'vue'], 'vue.md', ['Drawing.vue', 'Curve.vue', 'App.vue', 'vite.config.js'], 'main.js',
    "import { createApp } from 'vue';\nimport App from './App.vue';\ncreateApp(App).mount('#app');\n"),
  svelte: framed(['@sveltejs/vite-plugin-svelte@6', 'svelte'], 'svelte.md', ['Drawing.svelte', 'Curve.svelte', 'App.svelte', 'vite.config.js'], 'main.js',
    "import { mount } from 'svelte';\nimport App from './App.svelte';\nmount(App, { target: document.getElementById('app') });\n"),
};

/** A script outside of a page, with a worker of Node. */
function scripted(word) {
  return `import { load } from 'batten-core';
import { Worker } from 'node:worker_threads';
${TELL}${fit(word)}
const worker = new Worker(new URL('./worker.mjs', import.meta.url));
worker.on('message', (data) => { tell('worker', data); console.log(JSON.stringify(told)); });
`;
}
