// label: all (a minute and a half). 50 more kills of a browser that draws: what was said to be kept is there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kills } from './kills.mjs';

test('50 kills', async () => {
  const all = await kills(50, 2);
  assert.equal(all.kills, 50);
  assert.ok(all.strokes >= 20, JSON.stringify(all));
});
