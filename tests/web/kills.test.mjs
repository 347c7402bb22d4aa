// label: smoke. 10 kills of a browser that draws: what was said to be kept is there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kills } from './kills.mjs';

test('10 kills', async () => {
  const all = await kills(10, 1);
  assert.equal(all.kills, 10);
  assert.ok(all.strokes >= 10, JSON.stringify(all));
});
