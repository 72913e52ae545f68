// node bundle.mjs PACKAGES_FOLDER CORE.wasm HYRAX.svg FOLDER: the pages as one file each, without data. Each carries
// only what it shows.
import { readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { argv } from 'node:process';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const [packages, coreFile, spriteFile, folder] = argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(packages, 'package.json'))('esbuild');

const scripts = {
  'runs.js': `import { showRuns } from './runs.js'; showRuns();`,
  'sweeps.js': `import { showSweeps } from './members.js'; showSweeps();`,
};

async function bundled(name) {
  const result = await esbuild.build({
    ...(name.endsWith('.js') ? { stdin: { contents: scripts[name], resolveDir: here } } : { entryPoints: [join(here, name)] }),
    bundle: true,
    minify: true,
    write: false,
    metafile: true,
    format: 'iife',
    target: 'es2022',
    nodePaths: [join(packages, 'node_modules')],
    legalComments: 'none',
  });
  const [output] = Object.values(result.metafile.outputs);
  const used = Object.entries(output.inputs).filter(([, { bytesInOutput }]) => bytesInOutput > 0);
  return { text: result.outputFiles[0].text, inputs: used.map(([path]) => path) };
}

// The licences of the packages that are in the page, which ask to be kept with every copy.
async function notices(inputs) {
  const names = new Set(inputs.flatMap(path => path.match(/.*node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1] ?? []));
  const texts = [...names].sort().map(async name => {
    const text = await readFile(join(packages, 'node_modules', name, 'LICENSE'), 'utf8');
    return `${name}\n\n${text.trim()}`;
  });
  return (await Promise.all(texts)).join('\n\n');
}

const core = await readFile(coreFile);

// As core.js reads it, of the core that goes into the page.
async function fingerprint() {
  const { instance: { exports: calls } } = await WebAssembly.instantiate(core, {});
  calls.__wasm_call_ctors();
  calls.fingerprint();
  return Buffer.from(calls.memory.buffer, calls.text(), calls.text_length()).toString();
}

const spriteText = (await readFile(spriteFile, 'utf8')).replace(/<!--.*?-->/gs, '').replace(/\n\s+/g, '\n');
const shared = {
  FINGERPRINT: await fingerprint(),
  CORE: gzipSync(core, { level: 9 }).toString('base64'),
  STAGE: (await readFile(join(here, 'stage.html'), 'utf8')).trimEnd(),
  SPRITE: Buffer.from(spriteText).toString('base64'),
};

for (const name of ['runs', 'sweeps']) {
  const script = await bundled(`${name}.js`);
  const style = await bundled(`${name}.css`);
  const parts = {
    ...shared,
    STYLE: style.text,
    PICTURES: await readFile(join(here, 'pictures.js'), 'utf8'),
    SCRIPT: script.text.replaceAll('</script', '<\\/script'),
    NOTICES: (await notices([...script.inputs, ...style.inputs])).replaceAll('&', '&amp;').replaceAll('<', '&lt;'),
  };
  const page = (await readFile(join(here, `${name}.html`), 'utf8')).replace(/\{\{([A-Z]+)\}\}/g, (place, part) => {
    if (!(part in parts)) throw new Error(`unknown place ${place}`);
    return parts[part];
  });
  await writeFile(join(folder, `${name}.html`), page);
}
