// What passes through the memory of the page's core, in which order, and under which name it comes back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { element, load } from './stand_in.mjs';

const { Core } = await load('core');

/** A core that answers a call with a list or a text, and keeps the calls with what was given before them. */
function cored(answers) {
  const memory = { buffer: new ArrayBuffer(1024) }, called = [];
  let given = [], list = [], text = '', value = 0;
  const calls = new Proxy({ memory, input_room: count => ((given = new Float64Array(memory.buffer, 512, count)), 512), output: () => 0, output_count: () => list.length, text: () => 256, text_length: () => text.length }, {
    get: (own, name) => own[name] ?? ((...values) => {
      called.push([name, ...values, ...given].join(' '));
      given = [];
      ({ list = [], text = '', value = 0 } = (typeof answers[name] === 'function' ? answers[name](...values) : answers[name]) ?? {});
      memory.buffer = new ArrayBuffer(1024); // It moves.
      new Float64Array(memory.buffer, 0, list.length).set(list);
      new Uint8Array(memory.buffer, 256, text.length).set(Buffer.from(text));
      return value;
    }),
  });
  return { core: new Core(calls), called };
}

test('a record goes in with rows and digests, row by row', () => {
  const { core, called } = cored({ load: { value: 7 }, play_to: { value: 5 } });
  const rows = { step: [0, 10], t: [1, 11], dt: [2, 12], x: [3, 13], y: [4, 14], vx: [5, 15], vy: [6, 16], contact: [7, 17] };
  assert.deepEqual([core.load([21, 22], rows, [31, 32, 33]), core.load([23]), core.playTo(6)], [7, 7, 5]);
  assert.deepEqual(called, ['expect_rows 16 0 1 2 3 4 5 6 7 10 11 12 13 14 15 16 17', 'expect_blocks 3 31 32 33', 'load 2 21 22', 'expect_rows 0', 'expect_blocks 0', 'load 1 23', 'play_to 6']);
});

test('what a run came to has each number under its name', () => {
  const { core } = cored({ finish: { list: [9, 2, NaN, 5, 1, NaN, 1.5, 0.1, 0.2, 0.3, NaN, 11, 12, 13, 14, 1, 2, 3, 4], text: 'abc' } });
  assert.deepEqual(core.finish(), { steps: 9, every: 2, compared: 5, firstDifference: null, isComplete: true, nonFinite: null, stateHash: 'abc', atRestSince: 1.5, contacts: { left: 11, right: 12, top: 13, ground: 14 }, bounces: { left: 1, right: 2, top: 3, ground: 4 },
    errors: { implementation_px: 0.1, truncation_px: 0.2, model_px: 0.3, energy_drift_rel: null } });
  assert.equal(cored({ finish: { list: [9, 2, 0, 5, 0] } }).core.finish().isComplete, false);
});

test('columns come by name until there is none', () => {
  const columns = first => column => (column < 2 ? { list: [first, column], text: ['t', 'x'][column], value: 1 } : { value: 0 });
  const names = { rows: 'row_column', contacts: 'contact_column', errors: 'error_column', contactErrors: 'contact_error_column', causes: 'cause_column' };
  const { core } = cored(Object.fromEntries(Object.values(names).map((name, i) => [name, columns(i)])));
  Object.keys(names).forEach((name, i) => assert.deepEqual(core[name](), { t: Float64Array.of(i, 0), x: Float64Array.of(i, 1) }, name));
});

test('the playground’s calls have their numbers in order', () => {
  const { core, called } = cored({ flight: { list: [0, 1, 2, 10, 11, 12] }, live_release: { list: [1, 2, 3, 4] }, live_velocity: { list: [5, 6] }, live_frame: { list: [1, 2, 3, 4, 5, 6, 7] }, live_scenario: { list: [8, 9], text: 'hash' } });
  const start = { x: 1, y: 2, vx: 3, vy: 4, window: [5, 6], sprite: [7, 8], step: 9 };
  assert.deepEqual(core.flight(start, 24, 20), { t: Float64Array.of(0, 10), x: Float64Array.of(1, 11), y: Float64Array.of(2, 12) });
  core.liveStart(start);
  core.liveGrab(1, 2, 3);
  core.liveDrag(4, 5, 6);
  assert.deepEqual([core.liveRelease(7, 8, 9), core.liveVelocity(10), core.liveFrame(0.5), core.liveScenario()],
    [{ x: 1, y: 2, vx: 3, vy: 4 }, { vx: 5, vy: 6 }, { t: 1, x: 2, y: 3, vx: 4, vy: 5, contact: 6, frames: 7 }, { record: Float64Array.of(8, 9), stateHash: 'hash' }]);
  assert.deepEqual(called, ['flight 24 20 1 2 3 4 5 6 7 8', 'live_start 1 2 3 4 5 6 7 8', 'live_grab 1 2 3', 'live_drag 4 5 6', 'live_release 7 8 9', 'live_velocity 10', 'live_frame 0.5', 'live_scenario']);
});

test('the constants are those that are given last', () => {
  const { core, called } = cored({});
  core.useConstants([1, 2, 3, 4, 5]);
  core.useConstants([]);
  assert.deepEqual(called, ['use_constants 5 1 2 3 4 5', 'use_constants 0']);
});

test('another core is named on top', () => {
  element('other-core').hidden = true;
  const { core } = cored({ fingerprint: { text: 'ab' } });
  core.requireSame('ab', 'hyrax-sim 1');
  assert.deepEqual([element('other-core').hidden, document.documentElement.dataset.core], [true, undefined]);
  core.requireSame('cd', 'hyrax-sim 1');
  assert.deepEqual([element('other-core').hidden, document.documentElement.dataset.core], [false, 'differs']);
  assert.match(element('other-core').textContent, /page's core: ab; of hyrax-sim 1's: cd\./);
  delete document.documentElement.dataset.core;
});
