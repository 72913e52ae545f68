// node drive.mjs PACKAGES_FOLDER: opens pages in one Chromium, one after another. Reads lists of tasks from standard
// input and prints the list of their results, each list as JSON in one line.
//
// A task is {file, hash, bypass_csp, plain (without JavaScript), size, scheme, actions}; an action is ["evaluate", expression], ["click", selector],
// ["press", key], ["mouse", selector, [[x, y]...]] (a drag along points given as fractions of the element),
// ["touch", selector, [[x, y]...]] (the same with a finger), ["download", selector, path], ["wait", expression],
// ["look", {size, scheme}] (from now on), ["paper"] (as it is printed), ["axe"] (what axe-core finds wrong: a list of texts) or ["tab", n] (what has the focus after each of n tabs). A result is {attributes, errors, requests, values}, or {failed: MESSAGE}.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { argv, stdin } from 'node:process';
import { createInterface } from 'node:readline';

const require = createRequire(join(argv[2], 'package.json'));
const { chromium } = require('playwright-core');
const axeSource = await readFile(require.resolve('axe-core/axe.min.js'), 'utf8');
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium' });

// By hand, with 20 ms from point to point however busy the machine is: each point comes frames after its time.
async function drag(page, device, selector, points) {
  const place = page.locator(selector).first();
  await place.scrollIntoViewIfNeeded();
  const box = await place.boundingBox();
  const input = await page.context().newCDPSession(page);
  const begin = Date.now() / 1000;
  const types = device === 'touch' ? ['touchStart', 'touchMove', 'touchEnd'] : ['mousePressed', 'mouseMoved', 'mouseReleased'];
  const send = async (type, [partX, partY], index) => {
    const [x, y] = [box.x + partX * box.width, box.y + partY * box.height];
    const timestamp = begin + 0.02 * index;
    if (index > 0) await page.waitForTimeout(70);
    if (device === 'touch') return input.send('Input.dispatchTouchEvent', { type, timestamp, touchPoints: type === 'touchEnd' ? [] : [{ x, y }] });
    return input.send('Input.dispatchMouseEvent', { type, timestamp, x, y, button: 'left', buttons: 1, clickCount: 1 });
  };
  await send(types[0], points[0], 0);
  for (let i = 1; i < points.length; ++i) await send(types[1], points[i], i);
  await send(types[2], points.at(-1), points.length);
}

// Not waitForFunction, which evaluates text, as the page's policy forbids.
async function waitFor(page, expression) {
  const end = Date.now() + 90_000;
  while (!(await page.evaluate(expression))) {
    if (Date.now() > end) throw new Error(`never true: ${expression}`);
    await page.waitForTimeout(20);
  }
  return true;
}

async function faults(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => axe.run());
  return violations.flatMap(({ id, nodes }) => nodes.map(node => `${id}: ${node.target.join(' ')}: ${node.failureSummary}`));
}

async function focused(page, count) {
  const names = [];
  for (let i = 0; i < count; ++i) {
    await page.keyboard.press('Tab');
    names.push(await page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim()));
  }
  return names;
}

async function look(page, { size: [width, height] = [1280, 900], scheme = 'light' }) {
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ colorScheme: scheme });
}

const actions = {
  look: async (page, wanted) => {
    await look(page, wanted);
    await page.waitForTimeout(300); // It is laid out and drawn again.
  },
  paper: async page => {
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await page.emulateMedia({ media: 'print' });
  },
  axe: faults,
  mouse: (page, selector, points) => drag(page, 'mouse', selector, points),
  touch: (page, selector, points) => drag(page, 'touch', selector, points),
  tab: focused,
  evaluate: (page, expression) => page.evaluate(expression),
  click: (page, selector) => page.click(selector),
  press: (page, key) => page.keyboard.press(key),
  wait: waitFor,
  download: async (page, selector, path) => {
    const [file] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
    await file.saveAs(path);
    return file.suggestedFilename();
  },
};

async function perform(task) {
  const seen = { errors: [], requests: [], values: [] };
  const context = await browser.newContext({ acceptDownloads: true, bypassCSP: task.bypass_csp ?? false, hasTouch: true, javaScriptEnabled: !task.plain });
  const page = await context.newPage();
  await look(page, task);
  page.on('pageerror', error => seen.errors.push(String(error)));
  // But what Chromium advises a test that reads a canvas.
  page.on('console', message => message.text().includes('willReadFrequently') || seen.errors.push(message.text()));
  page.on('dialog', dialog => seen.errors.push(`dialog: ${dialog.message()}`) && dialog.dismiss());
  await context.route(url => !/^(file|data|blob):/.test(url.href), route => {
    seen.requests.push(route.request().url());
    return route.abort();
  });
  await page.goto(`file://${task.file}${task.hash ?? ''}`);
  if (!task.plain) await page.waitForFunction(() => 'ready' in document.documentElement.dataset, null, { timeout: 30_000 });
  seen.attributes = await page.evaluate(() => ({ ...document.documentElement.dataset }));
  for (const [name, ...rest] of task.actions ?? []) seen.values.push((await actions[name](page, ...rest)) ?? null);
  await context.close();
  return seen;
}

for await (const line of createInterface({ input: stdin })) {
  const results = [];
  for (const task of JSON.parse(line)) results.push(await perform(task).catch(error => ({ failed: String(error) })));
  console.log(JSON.stringify(results));
}
await browser.close();
