// node bundle.mjs PACKAGES_FOLDER CORE.wasm HYRAX.svg PAGE.html: everything as one file, without data.
import { readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { argv } from 'node:process';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const [packages, coreFile, spriteFile, pageFile] = argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(packages, 'package.json'))('esbuild');

async function bundled(name) {
  const result = await esbuild.build({
    entryPoints: [join(here, name)],
    bundle: true,
    minify: true,
    write: false,
    metafile: true,
    format: 'iife',
    target: 'es2022',
    nodePaths: [join(packages, 'node_modules')],
    legalComments: 'none',
  });
  return { text: result.outputFiles[0].text, inputs: Object.keys(result.metafile.inputs) };
}

// The licences of the packages that are in the page, which ask to be kept with every copy.
async function notices(inputs) {
  const names = new Set(inputs.flatMap(path => path.match(/node_modules\/([^/]+)\//)?.[1] ?? []));
  const texts = [...names].map(async name => {
    const text = await readFile(join(packages, 'node_modules', name, 'LICENSE'), 'utf8');
    return `${name}\n\n${text.trim()}`;
  });
  return (await Promise.all(texts)).join('\n\n');
}

const script = await bundled('main.js');
const style = await bundled('page.css');
const parts = {
  STYLE: style.text,
  SCRIPT: script.text.replaceAll('</script', '<\\/script'),
  NOTICES: (await notices([...script.inputs, ...style.inputs])).replaceAll('&', '&amp;').replaceAll('<', '&lt;'),
  CORE: gzipSync(await readFile(coreFile), { level: 9 }).toString('base64'),
  SPRITE: Buffer.from((await readFile(spriteFile, 'utf8')).replace(/<!--.*?-->/gs, '').replace(/\n\s+/g, '\n')).toString('base64'),
};
const page = (await readFile(join(here, 'page.html'), 'utf8')).replace(/\{\{([A-Z]+)\}\}/g, (place, name) => {
  if (!(name in parts)) throw new Error(`unknown place ${place}`);
  return parts[name];
});
await writeFile(pageFile, page);
