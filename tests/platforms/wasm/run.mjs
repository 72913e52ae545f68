// node run.mjs PROGRAM.wasm ARGUMENT...: a WASI program, which sees the current folder.
import { readFile } from 'node:fs/promises';
import process, { argv } from 'node:process';
import { WASI } from 'node:wasi';

const [program, ...rest] = argv.slice(2);
const wasi = new WASI({ version: 'preview1', args: ['hyrax-replay', ...rest], preopens: { '.': '.' }, returnOnExit: true });
const { instance } = await WebAssembly.instantiate(await readFile(program), wasi.getImportObject());
process.exitCode = wasi.start(instance);
