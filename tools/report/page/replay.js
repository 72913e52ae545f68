// Plays a run of the report in the browser, and compares it with the file.
import { bytes, doubles, lastAtMost, rowsOf } from './data.js';

/** Lets the browser draw and follow its reader. */
export const pause = () => new Promise(resolve => setTimeout(resolve));

async function playAll(core, steps, progress) {
  let piece = 20_000;
  for (let at = 0; at < steps; ) {
    const begin = performance.now();
    const end = Math.min(steps, at + piece);
    at = core.playTo(end);
    if (at < end) return; // Not finite: the run ended there.
    const took = performance.now() - begin;
    if (took < 15) piece *= 2;
    if (took > 40) piece = Math.max(1000, piece / 2);
    progress(at / steps);
    if (at < steps) await pause();
  }
}

/** By which a run is played in place of the core's own; of one without parameters none. */
export const constantsOf = ({ parameters }) => (Object.keys(parameters?.given ?? {}).length ? parameters.values : []);

/**
 * The run as this browser computes it: rows, contacts, errors, and whether its bits are those of the file.
 * `outcome` is "agrees", "differs" or "none".
 */
export async function replay(core, run, progress) {
  const file = rowsOf(run);
  core.useConstants(constantsOf(run));
  core.measureBy(run.model);
  const steps = core.load(doubles(run.record), file, bytes(run.blocks));
  if (steps < 0) return { run, file, rows: file, outcome: 'none' };
  const begin = performance.now();
  await playAll(core, steps, progress);
  const result = {};
  for (const [name, get] of partsPlayed(core)) {
    if (steps > 50_000) await pause();
    result[name] = get();
  }
  const { check } = result, isSame = check.firstDifference === null && check.isComplete && check.steps === run.steps && check.stateHash === run.state_hash;
  return { ...result, run, file, milliseconds: performance.now() - begin, outcome: isSame ? 'agrees' : 'differs' };
}

// What is known of the run that was played to its end, by name.
const partsPlayed = core => [['check', () => core.finish()], ...['rows', 'contacts', 'errors', 'contactErrors', 'causes'].map(name => [name, () => core[name]()])];

/** The run of a record that this page made, as replay has one. */
export function playedHere(core, record, { stateHash, constants, inputs = [] }) {
  const begin = performance.now();
  core.playTo(core.load(record));
  const result = Object.fromEntries(partsPlayed(core).map(([name, get]) => [name, get()])), { check, rows } = result, last = rows.step.length - 1;
  return { ...result, milliseconds: performance.now() - begin, outcome: check.stateHash === stateHash ? 'agrees' : 'differs',
    run: { name: 'fling', constants, steps: check.steps, row_count: last + 1, expect: null, inputs, errors: core.isMeasuring ? check.errors : null, non_finite: check.nonFinite,
      result: { contacts: check.contacts, bounces: check.bounces, final: { x_px: rows.x[last], y_px: rows.y[last] }, at_rest_since_s: check.atRestSince } } };
}

/** Where a run is at a time, and which way it looks. */
export function placeAt({ t, x, y }, time) {
  const row = Math.max(0, lastAtMost(t, time));
  return { x: x[row], y: y[row], vx: x[row] - x[Math.max(0, row - 1)] };
}

/** The window and sprite in force at each row: [{step, window, sprite}], by step; of a record and its inputs. */
export function sizesOf(record, inputs) {
  const sizes = [{ step: 0, window: [...record.slice(0, 2)], sprite: [...record.slice(2, 4)] }];
  for (const input of inputs) {
    if (input.kind !== 'resize') continue;
    const last = sizes.at(-1);
    sizes.push({ step: input.frame + 1, window: input.window ?? last.window, sprite: input.sprite ?? last.sprite });
  }
  return sizes;
}

export function sizesAt(sizes, step) {
  let index = sizes.length - 1;
  while (index > 0 && sizes[index].step > step) --index;
  return sizes[index];
}
