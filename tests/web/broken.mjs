// Tests that each cause an error on the console in a different way; faults.test.mjs runs them.
import { after, before, test } from 'node:test';
import { expectFaults, launch, settle } from './page.mjs';
import { serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await browser.close();
  server.close();
});

const breaks = {
  'an error that is logged': () => console.error('logged'),
  'an error that nobody catches': () => setTimeout(() => { throw new Error('thrown'); }),
  'a promise whose failure nobody catches': () => void Promise.reject(new Error('rejected')),
  'a style that the policy refuses': () => document.body.setAttribute('style', 'color: red'),
  'a file that is not there': () => void fetch('nothing'),
  'an error that the test declares': () => console.error('declared'),
  'nothing': () => {},
};

for (const [name, spoil] of Object.entries(breaks)) {
  test(name, async () => {
    expectFaults(/declared/);
    const page = await browser.newPage();
    await page.goto(server.address);
    await page.evaluate(spoil);
    await page.waitForLoadState('networkidle');
    await settle(page);
    await page.context().close();
  });
}
