// Firefox as Debian has it, driven by WebDriver BiDi: the session of elsewhere.mjs. label: all (another browser)
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import puppeteer from 'puppeteer-core';
import { HANG, session } from './elsewhere.mjs';

test('Firefox: drawn, drawn over, saved, kept, tilted, exported, text, both languages', async (t) => {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-firefox-'));
  const browser = await puppeteer.launch({ browser: 'firefox', executablePath: '/usr/bin/firefox-esr', headless: true, userDataDir: profile,
    timeout: HANG, protocolTimeout: HANG, defaultViewport: { width: 1280, height: 800 } });
  t.after(async () => {
    await browser.close();
    fs.rmSync(profile, { recursive: true, force: true });
  });
  const page = await browser.newPage();
  page.on('dialog', (dialog) => void dialog.accept()); // it asks whether to leave
  await session({
    name: 'firefox',
    version: () => browser.version(),
    go: (address) => page.goto(address),
    run: (code) => page.evaluate(code),
    drag: async ([[x, y], ...rest]) => {
      await page.mouse.move(x, y);
      await page.mouse.down();
      for (const [left, top] of rest) {
        await page.mouse.move(left, top);
      }
      await page.mouse.up();
    },
    escape: () => page.keyboard.press('Escape'),
    type: (text) => page.keyboard.type(text),
    picture: async () => Buffer.from(await page.screenshot()),
  });
});
