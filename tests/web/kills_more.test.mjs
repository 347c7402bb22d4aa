// 60 kills of a browser that draws: what was said to be kept is there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kills } from './kills.mjs';

test('60 kills', async () => {
  const all = await kills(60, 2);
  assert.equal(all.kills, 60);
  assert.ok(all.strokes >= 60, JSON.stringify(all));
});
