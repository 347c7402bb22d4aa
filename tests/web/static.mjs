// The built site behind a plain file server, under a sub-path: it is built once, by its target.
import { spawn, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const TREE = process.env.BATTEN_TREE ?? path.join(ROOT, 'build/release');
export const SITE = path.join(TREE, 'site');

/** Builds the part of the site that the editor needs. */
export function buildSite() {
  const built = spawnSync('cmake', ['--build', TREE, '--target', 'site_page'], { encoding: 'utf8' });
  if (built.status !== 0) {
    throw new Error(`site_page: ${built.stdout}${built.stderr}`);
  }
}

/** Python's own file server on a folder that holds the site at some depth. */
export async function serveSite(port = 0) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-site-'));
  fs.mkdirSync(path.join(folder, 'some'));
  fs.symlinkSync(SITE, path.join(folder, 'some', 'where'));
  fs.symlinkSync(SITE, path.join(folder, 'some', 'else'));
  const server = spawn('python3', ['-u', '-m', 'http.server', String(port), '--bind', '127.0.0.1', '--directory', folder],
    { stdio: ['ignore', 'pipe', 'ignore'] });
  const said = await new Promise((resolve, reject) => {
    server.on('error', reject);
    server.on('exit', (status) => reject(new Error(`the file server ended with ${status}`)));
    server.stdout.on('data', (text) => resolve(/http:\/\/127\.0\.0\.1:\d+\//.exec(String(text))?.[0]));
  });
  return {
    address: `${said}some/where/`,
    other: `${said}some/else/`, // the same under another path
    async close() {
      if (server.exitCode !== null || server.signalCode) {
        return;
      }
      const gone = new Promise((resolve) => server.on('exit', resolve));
      server.kill();
      await gone;
      fs.rmSync(folder, { recursive: true, force: true });
    },
  };
}
