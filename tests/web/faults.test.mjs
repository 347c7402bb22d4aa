// A test that causes an undeclared error on the console fails: page.mjs checks after every test.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const HERE = path.dirname(fileURLToPath(import.meta.url));

test('an error on the console, caught or not, fails the test that saw it', () => {
  const { NODE_TEST_CONTEXT, ...env } = process.env; // the child is a test runner itself
  const { stdout } = spawnSync(process.execPath, ['run.mjs', 'broken.mjs'], { cwd: HERE, encoding: 'utf8', env });
  const lines = [...stdout.matchAll(/^(ok|FAIL) +(.*) \(\d+ ms\)$/gm)].map(([, result, name]) => `${result} ${name}`);
  assert.deepEqual(lines, ['FAIL an error that is logged', 'FAIL an error that nobody catches',
    'FAIL a promise whose failure nobody catches', 'FAIL a style that the policy refuses', 'FAIL a file that is not there',
    'ok an error that the test declares', 'ok nothing'], stdout);
});
