// For builds with Vite, or Rollup: the editor's page goes along, into the folder of the script that shows it.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const PAGE = fileURLToPath(new URL('./page/', import.meta.url));

/** A plugin: `plugins: [battenEditor()]`. Vite's dev server needs none. */
export default function battenEditor() {
  let folder = ''; // of scripts
  return {
    name: 'batten-editor',
    apply: 'build',
    configResolved({ build }) {
      folder = build.assetsDir;
    },
    generateBundle() {
      for (const one of fs.readdirSync(PAGE, { recursive: true, withFileTypes: true })) {
        const file = path.join(one.parentPath ?? one.path, one.name);
        if (one.isFile()) {
          const fileName = path.posix.join(folder, 'page', ...path.relative(PAGE, file).split(path.sep));
          this.emitFile({ type: 'asset', fileName, source: fs.readFileSync(file) });
        }
      }
    },
  };
}
