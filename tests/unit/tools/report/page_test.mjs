// What the pages compute from a report: verdicts, lists, series of charts, cells of a sweep, sizes, files, numbers.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { base64, count, frame, later, load, page, textOf } from './stand_in.mjs';

const [cells, data, lists, { Moment }, numbers, { atRate, inputsIn, listOf, partsOf, scenarioText }, replay, series, { verdictOf }, whatIf] =
  await Promise.all(['cells', 'data', 'lists', 'moment', 'numbers', 'record', 'replay', 'series', 'verdict', 'what_if'].map(load));

// Five rows, of which every second step is recorded; the window and the sprite grow in step 5.
const rows = { step: [0, 2, 4, 6, 8], t: [0, 0.5, 1, 2, 3], dt: [0, 0.25, 0.25, 0.5, 0.5], x: [0, 3, 6, 9, 12], y: [0, 10, 20, 30, 40],
  vx: [6, 6, 6, 6, -8], vy: [8, 10, 20, 30, 0], contact: [0, 0, 0, 0, 8] };
const inputs = [{ kind: 'grab', frame: 1 }, { kind: 'resize', frame: 4, window: [200, 130], sprite: [20, 30] }, { kind: 'resize', frame: 6, window: [210, 140] },
  { kind: 'resize', frame: 7, sprite: [21, 31] }];
const sizes = replay.sizesOf([100, 80, 10, 20, 0, 0], inputs);
const errors = { step: [0, 4, 8], model: [0, 1e-3, 2], truncation: [0, 2e-3, 3], implementation: [0, 1e-9, 2e-9] };
const causes = { step: [0, 4, 8], gravity: [0, 1, 2], drag: [0, -1, -20], lift: [0, 3, 4], bounce: [0, 5, 7], sum: [0, 8, 11] };
const contactErrors = { step: [4, 6], time_error: [0.001, NaN], effective_restitution: [0.5, 0.625] };
const result = { rows, errors, causes, contactErrors, run: { constants: [500] }, contacts: { step: [4, 6], wall: [3, 1] } };
const said = charts => charts.map(({ id, title, unit, isLog, decimals, series: all }) => [`${id}: ${title}, ${unit}${isLog ? ', logarithmic' : ''}${decimals === undefined ? '' : ` .${decimals}`}`, ...all.map(({ name, color, dash, points, steps, values }) =>
  [`${name} ${color}${dash ? ' dashed' : ''}${points ? ' points' : ''}${steps ? ' steps' : ''}`, values])]);

test('each size is in force from the row after its frame', () => {
  assert.deepEqual(sizes.map(({ step, window, sprite }) => [step, ...window, ...sprite]),
    [[0, 100, 80, 10, 20], [5, 200, 130, 20, 30], [7, 210, 140, 20, 30], [8, 210, 140, 21, 31]]);
  assert.deepEqual(count(10).map(step => replay.sizesAt(sizes, step).step), [0, 0, 0, 0, 0, 5, 5, 7, 8, 8]);
});

test('charts have these series, units and values', () => {
  const drift = (name, tint, key) => [`${name} ${tint}`, [causes[key][0], undefined, causes[key][1], undefined, causes[key][2]]];
  assert.deepEqual(said(series.chartsOf(result, sizes)), [
    ['position: Position, px .1', ['x blue', rows.x], ['y orange', rows.y]],
    ['velocity: Velocity, px/s .1', ['vx blue', rows.vx], ['vy orange', rows.vy]],
    // (vx² + vy²) / 2 + 500 (window height - sprite height - y)
    ['energy: Energy, px²/s² .0', ['run green', [50 + 500 * 60, 68 + 500 * 50, 218 + 500 * 40, 468 + 500 * 70, 32 + 500 * 69]]],
    ['errors: Errors, px, logarithmic', ['model orange', [null, null, 1e-3, null, 2]], ['truncation blue', [null, null, 2e-3, null, 3]], ['implementation green', [null, null, 1e-9, null, 2e-9]]],
    ['drift: Energy drift by cause, px of height .2', drift('gravity', 'blue', 'gravity'), drift('drag', 'green', 'drag'), drift('lift', 'vermilion', 'lift'),
      drift('late bounce', 'purple', 'bounce'), drift('all', 'ink dashed', 'sum')],
    ['contact-time: Contact time error, ms .3', ['late by vermilion points', [null, null, 1, null, null]]],
    ['contact-restitution: Effective restitution,  .4', ['speed after / at the true impact purple points', [null, null, 0.5, 0.625, null]]],
    ['dt: Frame time, ms .3', ['dt blue steps', [null, 250, 250, 500, 500]]],
  ]);
});

test('errors with the drag of 60 Hz are one line', () => {
  const errorNames = model => series.chartsOf({ ...result, errors: { ...errors, model } }, sizes).find(({ id }) => id === 'errors').series.map(({ name }) => name);
  assert.deepEqual(errorNames([0, 2e-3, 3]), ['model and truncation', 'implementation']);
  assert.deepEqual(errorNames([0, 2e-3, 3.00001]), ['model', 'truncation', 'implementation']);
});

test('a run of another clock is compared at the same times', () => {
  const other = { t: [0, 0.25, 0.75, 1, 1.5, 2.5], dt: [0, 0.25, 0.5, 0.25, 0.5, 1], x: [0, 3, 5, 7, 9, 11], y: [0, 14, 20, 22, 30, 40], vx: [1, 2, 3, 4, 5, 6], vy: [7, 8, 9, 10, 11, 12] };
  const shown = series.shownAt(rows, other);
  assert.deepEqual(shown, { step: [0, 2, 4, 6], t: [0, 0.5, 1, 2], x: [0, 4, 7, 10], y: [0, 17, 22, 35], vx: [1, 2.5, 4, 5.5], vy: [7, 8.5, 10, 11.5] });
  assert.deepEqual(series.distancesFrom(shown, rows), [0, Math.hypot(1, 7), Math.hypot(1, 2), Math.hypot(1, 5), null]);
});

test('another run is drawn dashed, with its distance', () => {
  const other = { label: 'golden', name: 'golden file', rows: { step: [2, 4, 5, 8], x: [3, 2, 0, 12], y: [10, 23, 0, 40], vx: [1, 2, 3, 4], vy: [5, 6, 7, 8] } };
  other.distances = series.distancesFrom(other.rows, rows);
  assert.deepEqual(other.distances, [null, 0, 5, null, 0]);
  const charts = series.chartsOf({ ...result, other }, sizes), [{ series: [apart] }] = charts, [distance, position, velocity] = said(charts);
  // No place on a logarithmic axis, but a value: of rows that are the same it is 0, and of others none.
  assert.deepEqual(count(5).map(i => series.valueAt(rows, apart, i)), [null, 0, 5, null, 0]);
  assert.match(series.csvOf({ unit: 'px', series: [apart] }, rows), /\n0,0,\n2,0.5,0\n4,1,5\n6,2,\n8,3,0\n$/);
  const [implementation] = charts.find(({ id }) => id === 'errors').series.filter(({ name }) => name === 'implementation');
  assert.equal(series.valueAt(rows, implementation, 0), 0);
  assert.deepEqual(distance, ['distance: Distance from the golden file, px, logarithmic', ['distance vermilion', [null, null, 5, null, null]]]);
  assert.deepEqual(position.slice(3), [['x, golden blue dashed', [null, 3, 2, null, 12]], ['y, golden orange dashed', [null, 10, 23, null, 40]]]);
  assert.deepEqual(velocity.slice(3), [['vx, golden blue dashed', [null, 1, 2, null, 4]], ['vy, golden orange dashed', [null, 5, 6, null, 8]]]);
});

test('the value of a moment is the last contact, and the place on a line', () => {
  const drift = { known: { steps: [0, 4, 8], values: [0, 10, 20], isJoined: true } }, late = { known: { steps: [4, 6], values: [7, 9] } };
  assert.deepEqual(count(5).map(i => series.valueAt(rows, drift, i)), [0, 5, 10, 15, 20]);
  assert.deepEqual(count(5).map(i => series.valueAt(rows, late, i)), [null, null, 7, 9, 9]);
  assert.equal(series.valueAt(rows, { values: rows.vy }, 3), 30);
});

test('a chart as CSV has each row, empty where it has no value', () => {
  assert.equal(series.csvOf({ unit: 'ms', series: [{ name: 'a "b"', values: [null, undefined, NaN, -0, 0.1] }] }, rows),
    '"step","t_s","a ""b"" (ms)"\n0,0,\n2,0.5,\n4,1,\n6,2,-0.0\n8,3,0.1\n');
  assert.match(series.csvOf({ unit: '', series: [{ name: 'ratio', values: [] }] }, rows), /^"step","t_s","ratio"\n/);
});

test('axes are of whole decades, and of what is drawn', () => {
  const ends = series.chartsOf(result, sizes).filter(({ range }) => range).map(({ id, range }) => [id, ...[[-5, 10], [2, 4], [0, 0], [null, null]].map(([low, high]) => range(null, low, high))]);
  assert.deepEqual(ends, [['contact-time', [-6, 12], [0, 4.8], [0, 1], [0, 1]], ['contact-restitution', [-7.25, 12.25], [1.7, 4.3], [-0.015, 0.015], [0, 1]], ['dt', [-5, 11.5], [0, 4.6], [0, 1], [0, 1]]]);
  const axis = series.logAxis();
  assert.deepEqual(axis.range(null, 2e-3, 5), [1e-3, 10]);
  assert.deepEqual(axis.range(null, 1, 1), [1, 10]);
  assert.deepEqual(axis.splits(null, 0, 1e-3, 10).map(Math.log10).map(Math.round), [-3, -2, -1, 0, 1]);
  assert.deepEqual(axis.splits(null, 0, 1e-12, 1).map(Math.log10).map(Math.round), [-12, -9, -6, -3, 0]);
  assert.deepEqual(axis.values(null, [1e-12, 1, 10]), ['10⁻¹²', '10⁰', '10¹']);
  assert.equal(series.rangeText({ values: [3, null, -2, undefined, NaN] }, 'px'), '−2 to 3 px');
  assert.equal(series.rangeText({ values: [null, NaN] }, 'px'), 'no value');
  assert.deepEqual([99999, -1234, 100000, -2.5e6].map(series.thousands), ['99,999', '−1,234', '0.1 M', '−2.5 M']);
});

test('the overview of many rows has each row and contact once', () => {
  for (const length of [series.overviewRowsMin - 1, series.overviewRowsMin, series.overviewRowsMin + 1]) {
    const all = count(length), step = Float64Array.from(all), t = step.map(i => i / 100), zeros = step.map(() => 0);
    const many = { step, t, dt: zeros, x: zeros, y: zeros, vx: step.map(i => (i * 7919) % 1009), vy: zeros, contact: zeros };
    const contacts = { step: all.filter(i => i % 97 === 1), wall: [] };
    const charts = series.chartsOf({ ...result, rows: many, contacts }, sizes).filter(chart => chart.isOverview);
    assert.equal(charts.length, length < series.overviewRowsMin ? 0 : 2);
    if (!charts.length) continue;
    const [speed, met] = charts.map(chart => chart.series[0].known), ends = [...speed.steps.slice(1), length];
    assert.ok(speed.steps.length > 300 && speed.steps.length <= 400);
    speed.steps.forEach((from, i) => {
      const part = all.slice(from, ends[i]), seconds = (part.length - (i === 0)) / 100;
      assert.equal(speed.values[i], part.reduce((most, row) => Math.max(most, many.vx[row]), 0));
      assert.ok(Math.abs(met.values[i] - part.filter(row => row % 97 === 1).length / seconds) < 1e-9);
    });
    assert.equal(speed.steps[0], 0);
    assert.deepEqual(charts.map(({ unit }) => unit), ['px/s', '1/s']);
  }
});

test('searches agree with a plain loop', () => {
  for (const length of [0, 1, 2, 3, 8, 17]) {
    const values = count(length).map(i => 2 * Math.floor(i / 2));
    for (let wanted = -1; wanted <= length + 1; ++wanted) {
      assert.equal(data.firstAtLeast(values, wanted), values.filter(value => value < wanted).length);
      assert.equal(data.lastAtMost(values, wanted), values.filter(value => value <= wanted).length - 1);
    }
  }
  assert.deepEqual(data.rangeOf([undefined, 4, null, -1, NaN]), [-1, 4]);
  assert.deepEqual(data.rangeOf([NaN]), [null, null]);
  assert.deepEqual([...data.doubles(base64([0.1, -0, NaN]))], [0.1, -0, NaN]);
});

test('a place looks the way it came from', () => {
  assert.deepEqual([-1, 0, 0.49, 0.5, 2.9, 3, 9].map(time => replay.placeAt({ t: rows.t, x: [0, 3, 1, 1, 5], y: rows.y }, time)).map(({ x, y, vx }) => [x, y, vx]),
    [[0, 0, 0], [0, 0, 0], [0, 0, 0], [3, 10, 3], [1, 30, 0], [5, 40, 4], [5, 40, 4]]);
});

test('a run agrees only if every check of it does', async () => {
  const run = { record: '', blocks: '', rows: Object.fromEntries(data.rowFields.map(field => [field, base64([0])])), steps: 3, state_hash: 'a' };
  const checked = { firstDifference: null, isComplete: true, steps: 3, stateHash: 'a' };
  const core = (found, steps = 3) => ({ useConstants() {}, measureBy() {}, load: () => steps, playTo: end => end, finish: () => ({ ...checked, ...found }), rows: () => rows, contacts: () => ({}),
    errors: () => ({}), contactErrors: () => ({}), causes: () => ({}) });
  const outcome = async (...found) => (await replay.replay(core(...found), run, () => {})).outcome;
  assert.deepEqual([await outcome({}), await outcome({}, -1)], ['agrees', 'none']);
  for (const found of [{ firstDifference: 0 }, { isComplete: false }, { steps: 2 }, { stateHash: 'b' }]) assert.equal(await outcome(found), 'differs', JSON.stringify(found));
  assert.deepEqual(['a', 'b'].map(stateHash => replay.playedHere(core({}), [], { stateHash }).outcome), ['agrees', 'differs']);
});

test('a long run is played in pieces, which say how far it is', async () => {
  const run = { record: '', blocks: '', rows: Object.fromEntries(data.rowFields.map(field => [field, base64([0])])) };
  for (const [steps, reaches, took, ends, shares] of [[100_000, 100_000, 1, [20_000, 60_000, 100_000], [0.2, 0.6, 1]], [100_000, 30_000, 1, [20_000, 60_000], [0.2]],
    [40_000, 40_000, 61, [20_000, 30_000, 35_000, 37_500, 38_750, 39_750, 40_000], [0.5, 0.75, 0.875, 0.9375, 0.96875, 0.99375, 1]]]) {
    const played = [], reports = [];
    const playTo = end => (played.push(end), frame(performance.now() + took), Math.min(end, reaches));
    const core = { useConstants() {}, measureBy() {}, load: () => steps, playTo, finish: () => ({}), rows: () => rows, contacts() {}, errors() {}, contactErrors() {}, causes() {} };
    const waiting = setInterval(later, 1);
    const { milliseconds } = await replay.replay(core, run, share => reports.push(share)).finally(() => clearInterval(waiting));
    assert.deepEqual([played, reports, milliseconds], [ends, shares, took * ends.length]);
  }
});

const number = (values, isGrid) => ({ values, isGrid });

const itemsOf = numbers => cells.itemsOf(numbers, count(numbers.tint.values.length));
test('a cell is the mean of its members; of many values cells are even, and points at most 5000, evenly taken', () => {
  const x = number([1, 2, 4, 1, 2, 4, 1], true), y = number([0, 0, 0, 10, 10, 10, 0], true), tint = number([1, 2, 3, 4, NaN, 6, 9], false);
  const { edges, items } = itemsOf({ x, y, tint });
  assert.deepEqual(edges, [[0.25, 1.5, 3, 4.75], [-5, 5, 15]]);
  assert.deepEqual(items.map(({ column, line, row, x: across, y: up, count: of, value }) => [column, line, row, across, up, of, value]),
    [[0, 0, 0, 1, 0, 2, 5], [1, 0, 1, 2, 0, 1, 2], [2, 0, 2, 4, 0, 1, 3], [0, 1, 3, 1, 10, 1, 4], [1, 1, 4, 2, 10, 0, NaN], [2, 1, 5, 4, 10, 1, 6]]);
  for (const side of [1, 99, 100, 101, 250]) {
    const x = number(count(side * 2).map(i => i % side), true), y = number(count(side * 2).map(i => Math.floor(i / side)), true);
    const { edges: [across], items } = itemsOf({ x, y, tint: number(x.values, false) });
    assert.equal(across.length, Math.min(side, 100) + 1);
    assert.ok(across[0] < 0 && across.at(-1) > side - 1);
    assert.equal(items.reduce((sum, item) => sum + item.count, 0), 2 * side);
    for (const { column, value } of items) assert.ok(across[column] <= value && value <= across[column + 1], `${side}: ${value}`);
  }
  for (const [members, shown, stride] of [[1, 1, 1], [4999, 4999, 1], [5000, 5000, 1], [5001, 2501, 2], [10001, 3334, 3]]) {
    const x = number(count(members), true), { edges, items } = itemsOf({ x, y: number(x.values.map(i => 2 * i), false), tint: number(x.values.map(i => 3 * i), false) });
    assert.deepEqual([edges, items.length, ...Object.values(items.at(-1))], [null, shown, ...[1, 1, 2, 3].map(factor => factor * stride * (shown - 1))]);
  }
  assert.equal(itemsOf({ x: number([1, NaN], false), y: number([1, 1], false), tint: number([1, 1], false) }).items.length, 1);
});

test('a member has its own record, seeds with all 64 bits', () => {
  const sweep = { record: base64([0, 0, 0, 0, 9]), inputs: [{ name: '/start/x_px', place: 1, is_seed: false, is_grid: true, values: base64([5, 0.1]) },
    { name: '/clock/jitter/seed', place: 2, is_seed: true, values: base64([0, 7, 0xffffffff, 0xfffffffe]) }],
  results: [{ name: 'final_x', unit: 'px', values: base64([1, 2]) }, { name: 'contacts', unit: '1', values: base64([3, 4]) }] };
  const all = cells.numbersOf(sweep, [10, 20]);
  assert.deepEqual(all.map(({ label, isGrid, isInput, values }) => [label, isGrid, isInput, ...values]), [['start, x from the left, px', true, true, 5, 0.1],
    ['seed of the jitter', undefined, true, 7, 2 ** 64], ['final_x, px', false, undefined, 1, 2], ['contacts', false, undefined, 3, 4]]);
  const { record, texts, constants } = cells.recordOf(sweep, all, 1);
  assert.deepEqual(constants, []);
  assert.deepEqual(cells.numbersOf({ inputs: ['/parameters/GRAVITY', '/events/0/fling/vx_px_per_s'].map(name => ({ name, values: base64([1]) })), results: [] }, [10]).map(({ label }) => label), ['GRAVITY', '/events/0/fling/vx_px_per_s']);
  // A varied parameter is one of the constants that it is played with.
  const parameters = { names: ['GRAVITY', 'RESTITUTION'], values: [1200, 0.5], given: { RESTITUTION: 0.5 } }, varied = { ...sweep, parameters, inputs: [{ name: '/parameters/RESTITUTION', place: 5, values: base64([0.25, 0.75]) }] };
  const moon = cells.recordOf(varied, cells.numbersOf(varied, [10, 20]), 1);
  assert.deepEqual([[...moon.record], moon.constants, moon.texts], [[0, 0, 0, 0, 9], [1200, 0.75], { '/parameters/RESTITUTION': '0.75' }]);
  assert.deepEqual([...record], [0, 0.1, 0xffffffff, 0xfffffffe, 9]);
  assert.deepEqual(texts, { '/start/x_px': '0.1', '/clock/jitter/seed': '18446744073709551614' });
});

test('the scale of colours is viridis', () => {
  assert.deepEqual([-1, 0, 0.0625, 0.5, 1, 2].map(cells.viridis), ['rgb(68 1 84)', 'rgb(68 1 84)', 'rgb(70 23 104)', 'rgb(33 145 140)', 'rgb(253 231 37)', 'rgb(253 231 37)']);
});

test('a fling is written with each number and input', () => {
  const record = [800, 600, 64, 32, 1, 2, 3, 4, 1, 0, 0, 2, 3, 0.016, 0.017, -0, 0, 4, 0, 0, 5, 0, 0, 0, 0, 0, 1, 6, 10, 20, 0, 0, 0, 1, 1, 30, 40, 0, 0, 0, 2, 0, 50, 60, 0, 0];
  const { events, ...rest } = JSON.parse(scenarioText(partsOf(record), { stateHash: 'abc', name: 'fling', description: 'by hand' }));
  assert.deepEqual(events, [{ step: 0, grab: {} }, { step: 1, release: { vx_px_per_s: 10, vy_px_per_s: 20 } }, { step: 1, place: { x_px: 30, y_px: 40 } },
    { step: 2, fling: { vx_px_per_s: 50, vy_px_per_s: 60 } }]);
  assert.deepEqual(rest, { format: 'hyrax-scenario/1', name: 'fling', description: 'by hand', window: { width_px: 800, height_px: 600 }, sprite: { width_px: 64, height_px: 32 },
    start: { x_px: 1, y_px: 2, vx_px_per_s: 3, vy_px_per_s: 4 }, clock: { dt_s: [0.016, 0.017, -0] }, expect: { state_hash: 'abc' } });
});

test('a scenario of any kind goes through its parts, and is written with every key', () => {
  const head = [800, 600, 64, 32, 1, 2, 3, -4, 3], events = [4, 0, 9, 3, 400, 300, -1, -1, 1, 0.5, 4, 0.25, 0, 0, 0, 0, 12, 2, 0, 0, 0, 0, 0, 20, 3, -1, -1, 8, 9];
  for (const [clock, written] of [[[1, 60, 0, 120, 0], { steps: 60, clock: { rate_hz: 120 } }], [[2, 1.5, 1, 0.01, 1, 0, 0.2, 1, 7], { duration_s: 1.5, clock: { dt_s: 0.01, jitter: { kind: 'uniform', fraction: 0.2, seed: 2 ** 32 + 7 } } }],
    [[0, 0, 2, 2, 0.5, 1, 0], { clock: { dt_s: [0.5, 1] } }]]) {
    const list = [...head, ...clock, ...events];
    assert.deepEqual(listOf(partsOf(list)), list);
    const { events: found, record, parameters, ...rest } = JSON.parse(scenarioText(partsOf(list), { stateHash: 'a', name: 'n', description: '', parameters: { GRAVITY: 5e-324 } }));
    assert.deepEqual([found, record, parameters], [[{ step: 9, resize: { window: { width_px: 400, height_px: 300 } } }, { at_s: 0.5, hitch: { dt_s: 0.25 } }, { step: 12, stop: {} }, { step: 20, resize: { sprite: { width_px: 8, height_px: 9 } } }],
      { every: 3 }, { GRAVITY: 5e-324 }]);
    for (const [key, value] of Object.entries(written)) assert.deepEqual(rest[key], value);
    assert.deepEqual(Object.keys(rest).filter(key => key === 'steps' || key === 'duration_s'), Object.keys(written).filter(key => key !== 'clock'));
  }
  assert.match(scenarioText(partsOf([...head, 1, 60, 0, 120, 1, 2, 0.5, 2 ** 32 - 1, 2 ** 32 - 1, 0]), {}), /"missed_frames", "probability": 0.5, "seed": 18446744073709551615 }/);
});

test('at another rate a run is as long, and each event comes in the first frame of its time', () => {
  const parts = (length, clock, events) => ({ window: [9, 9], length, clock, jitter: null, events: events.map(when => ({ when, action: 2, numbers: [] })) });
  const at = (...which) => (({ length, clock, events }) => [length, clock, ...events.map(({ when }) => when)])(atRate(parts(...which.slice(0, 3)), which[3]));
  const fixed = { kind: 0, values: [60] }, slow = { kind: 0, values: [30] };
  assert.deepEqual(at([1, 600], fixed, [[0, 0], [0, 1], [0, 599], [1, 0.5]].slice(0, 3), 30), [[1, 300], slow, [0, 0], [0, 1]]); // The last begins after its last frame.
  assert.deepEqual(at([1, 600], fixed, [[0, 1], [0, 7], [1, 0.5]], 144), [[1, 1440], { kind: 0, values: [144] }, [0, 3], [0, 17], [0, 72]]);
  assert.deepEqual(at([2, 2.5], { kind: 1, values: [0.1] }, [[0, 7]], 30), [[1, 75], slow, [0, 21]]);
  assert.deepEqual(at([0, 0], { kind: 2, values: [0.5, 0.25, 1] }, [[0, 1], [0, 2]], 30), [[1, 53], slow, [0, 15], [0, 23]]);
  assert.deepEqual(inputsIn({ events: [[3, [100, 80, -1, -1]], [4, [0.5]], [0, [1, 2]]].map(([action, numbers], i) => ({ when: [0, i], action, numbers })) }), [{ frame: 0, kind: 'resize', window: [100, 80] }, { frame: 2, kind: 'fling' }]);
});

test('sliders stand at the run’s own values, and change only what is moved', () => {
  const run = { steps: 600, model: [1200, 0.6, 0.999, 0.8, 40], parameters: { names: ['GRAVITY', '', 'AIR_DRAG', 'GROUND_FRICTION', 'REST'], values: [5000, 0.6, 0.999, 0.8, 40], given: { GRAVITY: 5000 } } };
  const parts = partsOf([800, 600, 64, 32, 1, 2, 3, -4, 1, 1, 600, 0, 60, 0, 0]), sliders = whatIf.slidersOf(run, parts);
  assert.deepEqual(sliders.map(({ key, own, low, high }) => [key, Math.round(own * 1000) / 1000, low, high]), [['rate', 60, 10, 360], ['speed', 5, 0, 4000], ['angle', 53.13, -180, 180],
    ['GRAVITY', 5000, 0, 5000], ['AIR_DRAG', 0.999, 0.9, 1], ['GROUND_FRICTION', 0.8, 0, 1]]);
  const own = Object.fromEntries(sliders.map(each => [each.key, each.own])), changed = values => whatIf.changedRun(run, parts, sliders, { ...own, ...values });
  assert.deepEqual(changed({}), { parts, constants: run.parameters.values, model: run.model, parameters: { GRAVITY: 5000 } });
  assert.deepEqual(changed({ GRAVITY: 900, AIR_DRAG: 1 }), { parts, constants: [900, 0.6, 1, 0.8, 40], model: [900, 0.6, 1, 0.8, 40], parameters: { GRAVITY: 900, AIR_DRAG: 1 } });
  const [x, y, vx, vy] = changed({ speed: 10, rate: 30 }).parts.start;
  assert.deepEqual([x, y, Math.round(vx * 1e9), Math.round(vy * 1e9), changed({ rate: 30 }).parts.length], [1, 2, 6e9, -8e9, [1, 300]]);
  assert.deepEqual([[0.4, 360, 1, 0.4], [0, 4007, 10, 4006.9], [10, 360, 1, 59.6]].map(([low, high, step, place]) => whatIf.valueOf({ low, high, step }, place)), [0.4, 4007, 60]);
  // Without the paper's step there are no constants to change, and of a trace the mean rate is shown.
  assert.deepEqual(whatIf.slidersOf({ parameters: null }, { ...parts, clock: { kind: 2, values: [0.25, 0.75] } }).map(({ key, own }) => [key, own]).slice(0, 2), [['rate', 2], ['speed', 5]]);
  assert.deepEqual(whatIf.changedRun({ parameters: null, model: null }, parts, sliders.slice(0, 3), own), { parts, constants: [], model: null, parameters: undefined });
  assert.deepEqual(whatIf.slidersOf({ parameters: null }, { ...parts, clock: { kind: 1, values: [0] } }).map(({ key }) => key), ['speed', 'angle']);
  // A rate at which a run of a slow clock would have more steps than a page can play is not offered.
  const ends = (steps, rate) => (({ low, high }) => [low, high])(whatIf.slidersOf({ parameters: null, steps }, { ...parts, clock: { kind: 0, values: [rate] } })[0]);
  assert.deepEqual([ends(0, 60), ends(24_000, 20), ends(1000, 2 ** -20), ends(40_000, 0.5)], [[10, 360], [10, 200], [2 ** -20, 240 * 2 ** -20], [0.5, 3]]);
});

test('where a run lands is said beside the file’s', () => {
  const run = (x, error, ...walls) => ({ rows: { step: [0, 1, 2], t: [0, 0.5, 1], x: [0, x, 2 * x], y: [0, 4, 8] }, contacts: { step: [1, 2].slice(0, walls.length), wall: walls }, run: { errors: error && { truncation_px: error } } });
  assert.equal(whatIf.landingText(run(30, 2.5, 2, 8), run(33, 1, 8)), 'Lands at x 60 px after 1 s, the file’s run at x 33 px after 0.5 s. Ends at x 60, y 8 px, 6 px from where the file’s run ends. Truncation error 2.5 px, of the file’s run 1 px.');
  assert.equal(whatIf.landingText(run(30, null), run(30, 1, 8)), 'Never lands. Ends at x 60, y 8 px, 0 px from where the file’s run ends.');
});

test('a moment stays in the run, and reports each change once', () => {
  const moment = new Moment(rows), seen = [];
  moment.listen(({ index }) => seen.push(index));
  for (const index of [0, 1.4, 1, 99, 4, -3]) moment.show(index);
  moment.replace({ ...rows, step: [0, 2], t: [0, 0.5] });
  assert.deepEqual(seen, [1, 4, 0, 1]);
  assert.deepEqual(moment.body(), { step: 2, t: 0.5, x: 3, y: 10, vx: 6, vy: 10, contact: 0 });
});

test('numbers are written as the program writes them', () => {
  const cases = readFileSync(new URL('../../sim/result/numbers.txt', import.meta.url), 'utf8').trim().split('\n').map(line => line.split(/\s+/));
  assert.ok(cases.length > 10);
  for (const [value, digits, text] of cases) assert.equal(numbers.rounded(Number(value), Number(digits)), text.replaceAll('-', '−'));
  assert.deepEqual([[1234.5, 1], [-0.04, 1], [-2e9, 3], [Infinity, 2]].map(each => numbers.fixed(...each)), ['1,234.5', '0.0', '−2.000e9', '–']);
  assert.deepEqual([[1, 'row'], [1000, 'row']].map(each => numbers.count(...each)), ['1 row', '1,000 rows']);
  assert.deepEqual([-0, 0, 0.1, 1e21].map(numbers.exact), ['-0.0', '0', '0.1', '1e+21']);
});

// Of a tile: label, value, note, and whether it is good or bad.
const tiles = all => all.map(({ label, value, note, state }) => `${label}: ${value}; ${note}${state && `; ${state}`}`);
const ended = (since, contacts, bounces = contacts) => ({ contacts: { left: 0, right: 0, top: 0, ground: 0, ...contacts }, bounces: { left: 0, right: 0, top: 0, ground: 0, ...bounces }, final: { x_px: 1.5, y_px: 2.25 }, at_rest_since_s: since });
const verdict = ({ run, ...rest } = {}) => verdictOf({ file: {}, outcome: 'none', ...rest,
  run: { golden: null, expect: [], row_count: 2, steps: 8, errors: null, result: ended(null, { left: 1, right: 2, top: 3 }), ...run } });

test('the verdict says what was replayed, how far it agrees, and what the golden file and the expectations say', () => {
  const replayed = (rest, run) => tiles(verdict({ ...rest, run }).verdicts)[0];
  assert.equal(replayed({}), 'Replayed in this browser: not replayed; the scenario cannot be played here');
  assert.equal(replayed({ file: null, reason: 'too long' }), 'What you flung, replayed: not replayed; too long');
  const agrees = { outcome: 'agrees', milliseconds: 1.234, check: { compared: 7 } };
  assert.equal(replayed(agrees), 'Replayed in this browser: same bits; 7 rows of 9 and the state hash, 1.2 ms; good');
  assert.equal(replayed({ ...agrees, file: null }), 'What you flung, replayed: same bits; 2 rows of 9 and the state hash, 1.2 ms; good');
  assert.equal(replayed(agrees, { blocks: {} }), 'Replayed in this browser: same bits; 2 rows by block hash and the state hash, 1.2 ms; good');
  for (const [firstDifference, where] of [[null, 'the state hash differs; no stored row does'], [0, 'first at step 0'], [5, 'first at step 5']])
    assert.equal(replayed({ outcome: 'differs', check: { compared: 7, firstDifference } }), `Replayed in this browser: differs; ${where}; bad`);
  const golden = { agrees: false, class: 'contact', shape: 'other rows', first_divergence: { step: 3, field: 'vx' }, max_px: 0.12345, contacts_moved: 1 };
  const differs = 'contact; other rows; from step 3 in vx; at most 0.123 px apart; 1 contact differs';
  const same = { agrees: true, rows_compared: 1 };
  const [holds, breaks] = [{ holds: true, text: 'a' }, { holds: false, text: 'b' }];
  const judged = run => tiles(verdict({ run }).verdicts).slice(1);
  assert.deepEqual(judged({}), ['Golden file: not compared; report --against GOLDEN.h5 compares', 'Expectations: none; the scenario has no expect']);
  assert.deepEqual(judged({ golden: same, expect: [holds] }), ['Golden file: agrees; 1 row, bit for bit; good', 'Expectations: 1 of 1 hold; expect of the scenario; good']);
  assert.deepEqual(judged({ golden, expect: [holds, breaks, holds] }), [`Golden file: differs; ${differs}; bad`, 'Expectations: 2 of 3 hold; b; bad']);
  assert.equal(verdict({ file: null }).verdicts.length, 1);
  assert.deepEqual(verdict({ run: { golden } }).causes, [`Differs from the golden file: ${differs}`]);
  assert.deepEqual(verdict({ run: { golden, non_finite: 'x is NaN' } }).causes, ['x is NaN; the run ended there', `Differs from the golden file: ${differs}`]);
  assert.deepEqual(verdict({ run: { golden: same } }).causes, []);
});

test('the figures of a run have their units, the largest cause first', () => {
  const figures = rest => tiles(verdict(rest).figures);
  const place = 'x 1.5, y 2.25 px', drift = 'Energy drift: 1.25 %; largest of';
  assert.deepEqual(figures(), ['Bounces: 6; left 1, right 2, top 3', `Ends: not settled; ${place}`]);
  assert.deepEqual(figures({ run: { result: ended(0) } }), ['Bounces: 0; it met no wall', `Comes to rest: after 0 s; ${place}`]);
  assert.deepEqual(figures({ run: { result: ended(5, { ground: 4 }, { ground: 3 }), non_finite: 'x is NaN' } }), ['Bounces: 3; ground 3, 1 resting contact', 'Ends: not finite; x is NaN; bad']);
  const run = { errors: { implementation_px: 1e-9, truncation_px: 2.5, model_px: 3.5, energy_drift_rel: 0.0125 } };
  assert.deepEqual(figures({ run, causes }).slice(2), ['Implementation error: 1e−9 px; from the exact solution of its step',
    'Truncation error: 2.5 px; from the ODE at this frame rate', 'Model error: 3.5 px; from the ODE with the drag of 60 Hz',
    `${drift} an arc; in all drag −20, late bounce +7, lift +4, gravity +2 px`]);
  assert.equal(figures({ run, causes: { step: [0], gravity: [0], drag: [-2], lift: [9], bounce: [1000] } })[5], `${drift} an arc; in all late bounce +1,000 px`);
  assert.equal(figures({ run })[5], `${drift} a flight arc`);
  assert.deepEqual(figures({ run: { errors: { implementation_px: null, truncation_px: null, model_px: null, energy_drift_rel: null } } }).slice(2), ['Implementation error', 'Truncation error', 'Model error', 'Energy drift'].map(label => `${label}: –; no flight arc`));
});

test('contacts have the speeds of their wall and the errors of their arc; a hand’s way is one line, and each size is written out', () => {
  const contacts = { step: [4, 4, 6, 7], wall: [1, 8, 4, 2], last_step: [4, 9, 6, 7], t: [1, 1, 2, 3], vx_before: [-5, 50, 51, 8], vx_after: [3, 52, 53, -6],
    vy_before: [60, 7, -9, 61], vy_after: [62, -4, 2, 63], overshoot: [0.1, 0.2, 0.3, 0.4] };
  const met = { step: [4, 7], wall: [8, 2], time_error: [0.002, 0.003], effective_restitution: [0.5, 0.75] };
  const { heads, rows: lines, all } = lists.contactsOf({ contacts, contactErrors: met, check: { contacts: { left: 1, right: 1, top: 1, ground: 400 } } });
  assert.deepEqual(heads, ['Step', 'Wall', 't, s', 'Before, px/s', 'After, px/s', 'Overshoot, px', 'Late by, ms', 'Restitution']);
  assert.deepEqual(lines.map(({ step, last, wall, name, numbers: values }) => [step, last, wall, name, ...values]), [[4, '', 1, 'left', 1, -5, 3, 0.1, null, null],
    [4, 'to 9', 8, 'ground', 1, 7, -4, 0.2, 2, 0.5], [6, '', 4, 'top', 2, -9, 2, 0.3, null, null], [7, '', 2, 'right', 3, 8, -6, 0.4, 3, 0.75]]);
  assert.equal(all, 403);
  for (const many of [0, lists.shownMax - 1, lists.shownMax, lists.shownMax + 1]) {
    const each = Object.fromEntries(Object.keys(contacts).map(key => [key, count(many)]));
    assert.deepEqual(lists.contactsOf({ contacts: each, check: { contacts: {} } }).rows.map(({ step }) => step), count(Math.min(many, lists.shownMax)));
  }
  assert.deepEqual(lists.contactsOf({ run: { result: { contacts: {} } } }).rows, []);
  const place = frame => ({ kind: 'place', frame });
  assert.deepEqual(lists.inputsOf([place(1), place(2), place(3), place(5), { kind: 'release', frame: 6 }, place(7), ...inputs]).map(({ frame, text }) => `${frame} ${text}`),
    ['1 place', '5 place', '6 release', '7 place', '1 grab', '4 resize, window 200 × 130 px, sprite 20 × 30 px', '6 resize, window 210 × 140 px', '7 resize, sprite 21 × 31 px']);
});

test('what was exercised, and how it was made, is said under its own name', () => {
  assert.deepEqual(lists.coverageOf({ result: { exercised: ['drag', 'top'], never_touched: ['left'], not_computed: [] }, margin: 'm' }),
    [['Exercised', 'drag, top'], ['Never touched', 'left'], ['Not computed', 'nothing'], ['Margin', 'm']]);
  const run = { file: '/folder/a.h5', row_count: 1, physics: 'paper', state_hash: '01', provenance: { built_by: 'g++' } };
  const origin = check => lists.originOf({ command: 'report a.h5', program: 'hyrax-sim 1' }, run, check).map(parts => parts.join(' | '));
  assert.deepEqual(origin({ stateHash: '02' }), ['command | report a.h5 | true', 'report | hyrax-sim 1', 'file | a.h5, 1 row', 'physics | paper',
    'state hash of the file | 01 | true', 'of this browser | 02 | true', 'built by | g++']);
  assert.equal(origin(null)[5], 'of this browser | – | true');
});

test('an expectation and a list that was cut are written as sentences', () => {
  assert.deepEqual([true, false].map(holds => Object.values(lists.expectationOf({ holds, text: 'x' })).join(' ')), ['good holds x', 'bad does not hold x']);
  assert.deepEqual([[0, 0], [500, 500], [500, 501], [1500, 12000]].map(([shown, all]) => numbers.firstOf(shown, all, ' rows')),
    ['', '', 'The first 500 of 501 rows.', 'The first 1,500 of 12,000 rows.']);
});

test('the pages have each element that their scripts use, under its heading', () => {
  const runs = textOf('runs.html').replace('{{STAGE}}', textOf('stage.html')), html = runs + textOf('sweeps.html');
  const scripts = readdirSync(page).filter(name => name.endsWith('.js')).map(textOf).join('');
  const ids = [...new Set([...scripts.matchAll(/(?:element|on)\('([\w-]+)'/g)].map(([, id]) => id))];
  assert.ok(ids.length > 30);
  const missing = ids.filter(id => !html.includes(`id="${id}"`) && !scripts.includes(`id: '${id}'`));
  assert.deepEqual(missing, ['runs']); // The sheet, which hyrax-sim writes.
  assert.deepEqual([...runs.matchAll(/ id="([\w-]+)"[^>]*>([A-Z][^<]*)</g)].map(([, id, text]) => `${id}: ${text.trim()}`), ['all-runs: All runs', 'verdict-heading: Verdict', 'stage-heading: Replay', 'mode-replay: Replay', 'mode-fling: Fling it yourself', 'save-scenario: Save scenario', 'file-run: Back to the file’s run',
    'again: Again', 'slow: A bounce in slow motion', 'restart: Start over', 'download-scenario: Download scenario', 'charts-heading: Charts', 'contacts-heading: Contacts', 'inputs-heading: Inputs', 'model-heading: Modelled and left out', 'made-heading: How it was made']);
});

test('what is good is green and what is bad is red, and each tint is its colour', () => {
  const css = ['base.css', 'page.css', 'results.css'].map(textOf).join('').replaceAll(/\/\*.*?\*\//gs, ''), rules = [...css.matchAll(/([^{};]+)\{([^{}]*)\}/g)].map(([, selector, body]) => [selector.trim(), body]);
  const colors = (is, isNot) => rules.filter(([selector]) => is.test(selector) && !isNot.test(selector)).flatMap(([, body]) => [...body.matchAll(/var\(--([\w-]+)\)/g)].map(([, name]) => name));
  assert.deepEqual([colors(/good/, /bad/), colors(/bad/, /good/)].map(all => [...new Set(all)].join(' ')), ['good-tint card green', 'bad bad-tint card vermilion']);
  for (const [selector, body] of rules) if (selector.startsWith('.tint-')) assert.equal(body.trim(), `color: var(--${selector.slice(6)});`);
  const tints = ['series.js', 'fling.js'].flatMap(name => [...textOf(name).matchAll(/'(blue|orange|green|purple|vermilion|ink|path|sky-blue|faint|ramp-\d)'/g)].map(([, tint]) => tint));
  assert.ok(tints.length > 5);
  assert.deepEqual(tints.filter(tint => !css.includes(`.tint-${tint} `)), []);
});

// In CIELAB, as most people see it, and as one without green or red cones does: Machado, Oliveira and Fernandes, 2009.
const eyes = { all: [1, 0, 0, 0, 1, 0, 0, 0, 1], 'no green': [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881], 'no red': [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998] };
const times = (matrix, [r, g, b]) => [0, 3, 6].map(at => matrix[at] * r + matrix[at + 1] * g + matrix[at + 2] * b);
const linear = hex => [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16) / 255).map(part => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
function labOf(hex, eye) {
  const [x, y, z] = times([0.4339, 0.3763, 0.1899, 0.2126, 0.7152, 0.0722, 0.0177, 0.1095, 0.8729], times(eyes[eye], linear(hex)).map(part => Math.min(1, Math.max(0, part)))).map(part => (part > 0.008856 ? Math.cbrt(part) : 7.787 * part + 16 / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const distance = (a, b, eye) => Math.hypot(...labOf(a, eye).map((part, i) => part - labOf(b, eye)[i]));
const paletteOf = css => Object.fromEntries([...css.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map(([, name, color]) => [name, color]));

test('colours that meet differ to every eye and are read on their paper, light and dark', () => {
  const [light, dark] = textOf('look.css').split('@media').map(paletteOf), hues = ['ink', 'vermilion', 'orange', 'blue', 'green', 'purple', 'sky-blue', 'lavender'], ramp = count(6).map(i => `ramp-${i + 1}`);
  const closest = (palette, names, eye) => Math.min(...names.flatMap((name, i) => names.slice(0, i).map(other => distance(palette[name], palette[other], eye))));
  for (const palette of [light, { ...light, ...dark }]) {
    assert.ok(closest(palette, hues, 'all') > 18);
    for (const eye of Object.keys(eyes)) for (const names of [hues, [...ramp, 'ink', 'path']]) assert.ok(closest(palette, names, eye) >= 10, `${eye} ${names}: ${closest(palette, names, eye)}`);
    const levels = ramp.map(name => labOf(palette[name], 'all')[0]), shine = hex => times([0.2126, 0.7152, 0.0722, 0, 0, 0, 0, 0, 0], linear(hex))[0] + 0.05;
    assert.deepEqual(levels, levels.toSorted?.((a, b) => a - b) ?? [...levels].sort((a, b) => a - b));
    for (const name of [...hues, ...ramp, 'quiet', 'good', 'bad']) for (const paper of ['card', 'paper']) {
      const [low, high] = [palette[name], palette[paper]].map(shine).sort((a, b) => a - b);
      assert.ok(high / low >= 4.5, `${name} on ${paper}`);
    }
  }
  const before = { vermilion: '#c14f00', orange: '#a06900' };
  assert.ok(Math.abs(closest(before, ['vermilion', 'orange'], 'no green') - 2.3) < 0.1);
});

test('the picture that is shown has letters of 11 px at least', () => {
  const drawn = textOf('../figure_svg.cpp'), widths = name => Number(new RegExp(`add\\("${name}", (\\d+)`).exec(drawn)[1]);
  for (const name of ['medium', 'wide']) {
    const [, least] = new RegExp(`min-width: (\\d+)px\\) \\{ \\.picture > \\.${name} `).exec(textOf('results.css'));
    assert.ok((12 * least) / widths(name) >= 11 && least <= widths(name), name);
  }
});
