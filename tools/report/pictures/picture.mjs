// node picture.mjs PACKAGES_FOLDER PAGE.html PICTURE.png [WIDTH HEIGHT [SCALE [light|dark [full [HASH]]]]]: a picture of a
// report page in Chromium.
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { argv } from 'node:process';

const [packages, file, picture, width = '1280', height = '900', scale = '1', scheme = 'light', extent = 'window', hash = ''] = argv.slice(2);
const { chromium } = createRequire(join(resolve(packages), 'package.json'))('playwright-core');
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium' });
const page = await browser.newPage({ viewport: { width: Number(width), height: Number(height) }, deviceScaleFactor: Number(scale), colorScheme: scheme });
page.on('pageerror', error => console.error(String(error)));
page.on('console', message => ['error', 'warning'].includes(message.type()) && console.error(message.text()));
await page.goto(`file://${resolve(file)}${hash}`);
await page.waitForFunction(() => 'ready' in document.documentElement.dataset);
await page.waitForTimeout(300);
await page.screenshot({ path: picture, fullPage: extent === 'full' });
await browser.close();
