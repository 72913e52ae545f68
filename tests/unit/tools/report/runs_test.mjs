// The page of runs: which one it opens and at which moment, the address, lists that lead to steps, two runs, the playground.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import Plot, { base64, Element, count, element, frame, later, load, page, reopen, resize, saved, windowEvents } from './stand_in.mjs';

const { report } = await load('document');
Object.assign(report, { program: 'hyrax-sim 1', command: 'report a.h5', core: 'paper', core_fingerprint: 'ab' });
const [{ Core }, { rowFields }, { showRuns }] = await Promise.all(['core', 'data', 'runs'].map(load));

// One row of every ten, for 4 s.
const rows = { step: count(41).map(i => 10 * i), t: count(41).map(i => i / 10) };
Object.assign(rows, { dt: rows.t.map(() => 0.01), x: count(41).map(i => 2 * i), y: count(41).map(i => i), vx: rows.t.map(() => 20), vy: rows.t.map(() => 10), contact: rows.t.map(() => 0) });
const contacts = { step: [95, 200], wall: [2, 8], last_step: [95, 210], t: [0.95, 2], vx_before: [1, 2], vx_after: [3, 4], vy_before: [5, 6], vy_after: [7, 8], overshoot: [0.5, 0.25], x: [18, 40], y: [9, 20] };
const filed = changed => Object.fromEntries(rowFields.map(name => [name, base64({ ...rows, ...changed }[name])]));
const run = (name, more) => ({ name, title: `${name}: Title of ${name}`, description: '', file: `/folder/${name}.h5`, rows: filed(), record: base64([100, 80, 10, 20, 0, 0, 0, 0]), blocks: '', steps: 400, row_count: 41, state_hash: 'ab',
  physics: 'paper', provenance: {}, inputs: [], constants: [500], errors: null, golden: null, expect: [], margin: '2 px', non_finite: '',
  result: { contacts: { left: 0, right: 1, top: 0, ground: 1 }, bounces: { left: 0, right: 1, top: 0, ground: 1 }, final: { x_px: 80, y_px: 40 }, at_rest_since_s: null, exercised: ['drag'], never_touched: [], not_computed: [] }, ...more });
const checked = { every: 10, compared: 41, nonFinite: null, atRestSince: null, errors: null, firstDifference: null, isComplete: true, steps: 400, stateHash: 'ab', contacts: { left: 0, right: 1, top: 0, ground: 1 }, bounces: { left: 0, right: 1, top: 0, ground: 1 } };

let frames = 0;
const body = () => ({ t: 0, x: 45, y: 0, vx: 0, vy: 0, contact: 0, frames: ++frames });

function panelOf(index) {
  const panel = new Element('a');
  panel.setAttribute('href', `#run=${index}`);
  panel.append(new Element('span'));
  return panel;
}

/** Opens a page, with a sheet of panels in that order; `found` is what the core comes to, or null where it has no scenario. */
async function opened(runs, { panels = [], hash = '', found = () => ({}), core = {}, start, show = showRuns } = {}) {
  reopen();
  element('runs').append(...panels.map(index => panelOf(index)));
  frame(0);
  element('replay').parentElement = { clientWidth: 200 };
  element('speed').value = '1';
  location.hash = hash;
  Object.assign(report, { runs });
  let played = -1;
  Core.start = start ?? (async () => ({ requireSame() {}, useConstants() {}, measureBy() {}, load: () => (found(++played) ? 400 : -1), playTo: step => step, finish: () => ({ ...checked, ...found(played) }), rows: () => rows, contacts: () => contacts, errors: () => ({ step: [] }),
    contactErrors: () => ({ step: [95], wall: [2], time_error: [0.001], effective_restitution: [0.75] }), causes: () => ({ step: [] }), liveStart() {}, liveGrab() {}, liveVelocity: () => ({ vx: 3, vy: 4 }), liveFrame: body, liveScenario: () => ({ record: [], stateHash: 'ab' }), ...core }));
  await show();
}
const text = id => element(id).textContent;
const row = () => Number(element('time').value);
const rowShown = () => element('readouts').querySelector('[data-name=row]').textContent;
const data = () => document.documentElement.dataset;

test('of several runs it opens the first of the worst', async () => {
  const differs = { stateHash: 'cd', firstDifference: 30 };
  for (const [founds, name, outcome] of [[[{}], 'a', 'agrees'], [[{}, {}], 'a', 'agrees'], [[{}, differs, differs], 'b', 'differs'], [[differs, {}, null], 'a', 'differs'], [[{}, null, {}, null], 'b', 'none'], [[null, {}, differs], 'c', 'differs']]) {
    await opened(founds.map((_, i) => run('abcd'[i])), { found: at => founds[at] });
    assert.deepEqual([text('name'), document.title, data().replay, element('all-runs').hidden], [name, `${name} · hyrax-sim report`, outcome, true]);
    assert.deepEqual([data().stateHash, data().firstDifference], outcome === 'none' ? [undefined, undefined] : outcome === 'differs' ? ['cd', 30] : ['ab', undefined]);
  }
});

test('a sheet opens its first of the worst, marks those that differ here, and leads to each run', async () => {
  const differs = { stateHash: 'cd', firstDifference: 30 }, three = ['a', 'b', 'c'].map(name => run(name));
  const panels = () => element('runs').children.map(({ dataset, className = '', textContent }) => [dataset.replay, 'current' in dataset, className, textContent].join(' ').trim());
  await opened(three, { panels: [2, 0, 1] });
  assert.deepEqual([text('name'), element('all-runs').hidden, data().replay, panels()], ['c', false, 'agrees', ['agrees true', 'agrees false', 'agrees false']]);
  await opened(three, { panels: [2, 0, 1], found: at => (at === 1 ? differs : {}) });
  assert.deepEqual([text('name'), data().replay, panels()], ['a', 'differs', ['agrees false', 'differs true panel bad ✗ differs in this browser', 'agrees false']]);
  location.hash = '#run=1&step=120';
  windowEvents.fire('hashchange');
  await new Promise(setImmediate);
  assert.deepEqual([text('name'), text('title'), row(), data().replay, panels()[2]], ['b', 'Title of b', 12, 'differs', 'agrees true']);
  windowEvents.fire('keydown', { key: 'ArrowRight', target: element('replay') });
  later();
  assert.equal(location.hash, '#run=1&step=130');
  await opened(three, { panels: [2, 0, 1], hash: '#run=1' });
  assert.deepEqual([text('name'), row()], ['b', 0]);
  for (const hash of ['#run=3', '#runs']) {
    await opened(three, { panels: [2, 0, 1], hash });
    assert.equal(text('name'), 'c', hash);
  }
});

test('the address has the step that is shown, and opens it', async () => {
  for (const [hash, shown] of [['', 0], ['#step=0', 0], ['#step=120', 12], ['#step=129', 12], ['#step=9999', 40], ['#other', 0]]) {
    await opened([run('a')], { hash });
    assert.deepEqual([row(), rowShown()], [shown, String(10 * shown)], hash);
  }
  await opened([run('a')]);
  later();
  windowEvents.fire('keydown', { key: 'ArrowRight', target: element('replay') });
  windowEvents.fire('keydown', { key: 'ArrowRight', target: element('replay') });
  assert.equal(location.hash, '');
  assert.deepEqual([later(), location.hash], [[250], '#step=20']);
  location.hash = '#step=35';
  windowEvents.fire('hashchange');
  await new Promise(setImmediate);
  assert.deepEqual([row(), element('time').attributes['aria-valuetext']], [3, 'row 30, 0.300 s']);
});

test('each list of a run is at its place, and leads to its step', async () => {
  await opened([run('a', { description: 'What it is', inputs: [{ kind: 'grab', frame: 52 }], expect: [{ holds: false, text: 'x' }], provenance: { built_by: 'g++' }, scenario_text: '{}' })]);
  for (const [id, expected] of [['title', 'Title of a'], ['description', 'What it is'], ['charts-note', 'Drawn from one row of every 10; the comparison covers all. '], ['stage-note', ''], ['inputs-list', 'step 52 grab'],
    ['coverage', 'ExerciseddragNever touchednothingNot computednothingMargin2 px'], ['expectations', 'does not hold x'],
    ['made', 'commandreport a.h5reporthyrax-sim 1filea.h5, 41 rowsphysicspaperstate hash of the fileabof this browserabbuilt byg++scenarioSave a.json'],
    ['contacts', 'StepWallt, sBefore, px/sAfter, px/sOvershoot, pxLate by, msRestitution95 right0.95130.510.75200 to 210ground2680.25––']]) assert.equal(text(id), expected, id);
  assert.match(text('verdict'), /Bounces2right 1, ground 1/);
  assert.deepEqual([element('description').hidden, element('inputs').hidden], [false, false]);
  assert.deepEqual(element('contacts').querySelectorAll('span').filter(each => each.classes.includes('wall')).map(({ attributes }) => attributes.style), ['color: var(--vermilion); clip-path: polygon(100% 50%, 0% 100%, 0% 0%)', 'color: var(--orange); clip-path: polygon(50% 100%, 0% 0%, 100% 0%)']);
  const buttons = ['contacts', 'inputs-list', 'made'].flatMap(id => element(id).querySelectorAll('button'));
  assert.deepEqual(buttons.map(button => (button.fire('click'), row())), [10, 20, 6, 6]);
  assert.deepEqual(saved.splice(0).slice(-1), [['a.json', '{}']]);
  await opened([run('a')]);
  assert.deepEqual([element('description').hidden, element('inputs').hidden, element('farthest').hidden], [true, true, true]);
});

test('beside another run it opens on the second around their largest distance', async t => {
  const far = filed({ x: rows.x.map((x, i) => x + (i < 16 ? i : i === 16 ? 98 : i === 20 ? 99.5 : i === 30 ? 100 : 0)) });
  const golden = { agrees: false, class: 'values', first_divergence: { step: 10, field: 'x' }, rows: far };
  await opened([run('a', { golden })]);
  assert.deepEqual([row(), text('stage-note'), 'red' in data(), element('play').attributes['aria-label']], [20, 'Dashed: the golden file.', true, 'Pause']);
  assert.deepEqual([450, 650, 660].map(time => (frame(time), row())), [24, 25, 15]); // From 1.5 s to 2.5 s.
  const log = element('replay').getContext().log;
  assert.match(log.find(line => line.includes('bad 3 dashed')), /^stroke bad 3 dashed: from 20,40 /);
  assert.match(log.filter(line => line.includes('of 0.4'))[0], /^stroke bad 2 of 0\.4: box 180,60 40,80$/); // x 30 + 15, y 15.
  assert.ok(element('charts').children[0].id === 'chart-distance');
  assert.deepEqual([element('farthest').hidden, text('farthest-note').replace(/, [\d.,]+ times/, '')], [true, 'Farthest: 100 px at 3 s as large; dashed: the golden file.']);
  // A replay that differs is beside the rows of the file; a link says which moment is shown.
  for (const [more, options, note] of [[{ rows: far }, { found: () => ({ stateHash: 'cd', firstDifference: 10 }), hash: '#step=50' }, 'Dashed: the file.'], [{ golden: { agrees: true, rows_compared: 41 } }, { hash: '#step=50' }, '']]) {
    await opened([run('a', more)], options);
    assert.deepEqual([text('stage-note'), row(), element('play').attributes['aria-label']], [note, 5, 'Play']);
  }
  await opened([run('a', { golden: { ...golden, rows: filed({ x: rows.x.map((x, i) => x + (i === 7 ? 2 : 0)) }) } })]);
  assert.match(`${element('farthest').hidden} ${text('farthest-note')}`, /^false Farthest: 2 px at 0\.7 s, [\d.]+ times as large; dashed: the golden file\.$/);
  const { matchMedia } = globalThis;
  t.after(() => (globalThis.matchMedia = matchMedia));
  globalThis.matchMedia = query => ({ ...matchMedia(), matches: query === '(prefers-reduced-motion: reduce)' });
  await opened([run('a', { golden })]);
  assert.deepEqual([row(), element('play').attributes['aria-label']], [20, 'Play']);
});

test('the charts mark where the replay differs first, or else the run from the golden file', async () => {
  const golden = { agrees: false, class: 'values', first_divergence: { step: 200, field: 'x' } };
  for (const [found, more, px] of [[{}, {}, null], [{}, { golden }, 100], [{ firstDifference: 100 }, { golden }, 50], [{ firstDifference: 0 }, { golden }, 0], [null, { golden }, 100]]) {
    await opened([run('a', more)], { found: () => found });
    const [, mark] = Plot.all.at(-1).over.children;
    assert.equal(mark?.style.transform ?? null, px === null ? null : `translateX(${px}px)`);
  }
});

test('what is not all shown, or is not replayed, is said', async t => {
  const many = count(201), long = Object.fromEntries(Object.entries(rows).map(([name, values]) => [name, count(5001).map(i => values[i % 41])])), reports = [];
  const core = { requireSame: (...which) => reports.push(which.join()), load: () => (reports.push(text('verdict')), 400), rows: () => ({ ...long, step: count(5001) }),
    finish: () => ({ ...checked, every: 1, contacts: { left: 0, right: 1500, top: 0, ground: 0 } }), contacts: () => Object.fromEntries(Object.keys(contacts).map(name => [name, name === 'wall' ? many.map(() => 8) : many])) };
  await opened([run('a', { inputs: many.map(frame => ({ kind: 'stop', frame })) })], { core });
  assert.deepEqual([reports, text('charts-note')], [['ab,hyrax-sim 1', 'Replaying …'], 'Of many rows to a pixel, the smallest and the largest value are drawn.']);
  assert.deepEqual(['contacts', 'inputs-list'].map(id => element(id).querySelectorAll('.quiet').at(-1).textContent), ['The first 200 of 1,500.', 'The first 200 of 201.']);
  await opened([run('a'), run('b')], { core: { load: core.load } });
  assert.equal(reports.at(-1), 'Replaying a: 100 %');
  t.after(() => Object.assign(report, { core: 'paper', no_replay: null, core_step: null }));
  report.no_replay = 'the step of the core moon is not complete';
  report.core = 'moon';
  const own = await import(new URL('runs.js?own', page));
  await opened([run('a')], { show: own.showRuns });
  assert.deepEqual([data().replay, element('mode-fling').disabled], ['none', true]);
  assert.match(text('verdict'), /not replayedthe step of the core moon is not complete/);
  assert.equal(text('stage-note'), 'No replay: the step of the core moon is not complete. Without it there are no errors, no causes of drift and nothing to fling.');
  // It has the contacts of the file.
  await opened([run('a', { contacts: Object.fromEntries(Object.entries(contacts).map(([name, values]) => [name, base64(values)])) })], { show: own.showRuns });
  assert.match(text('contacts'), /^StepWall.*ground/);
  // A step that the page carries is played where it is calculated as in the program.
  Object.assign(report, { no_replay: null, core_step: 'step' });
  for (const [can, fingerprint, replay] of [[true, 'ab', 'agrees'], [true, 'cd', 'none'], [false, 'ab', 'none']]) {
    await opened([run('a')], { show: own.showRuns, core: { useStep: step => can && step === 'step', fingerprint: () => fingerprint } });
    assert.equal(data().replay, replay);
  }
  assert.match(text('stage-note'), /^No replay: this browser calculates the step of the core moon otherwise than hyrax-sim 1\./);
});

test('what is changed is marked, drawn beside the file’s run and saved as it is seen', async () => {
  const core = { useConstants: (...which) => used.push(which.join()), measureBy() {}, load: list => (loaded = list, 400) }, used = [];
  let loaded = null;
  const record = [100, 80, 10, 20, 0, 0, 3, 4, 1, 1, 400, 0, 100, 0, 0], parameters = { names: ['GRAVITY', '', '', '', ''], values: [500, 0.5, 1, 1, 1], given: {} };
  await opened([run('a', { record: base64(record), parameters, model: [500, 0.5, 1, 1, 1], constants: parameters.values })], { core });
  const seen = () => [element('not-the-file').hidden, 'whatIf' in data() || 'what-if' in data(), element('file-run').disabled], slid = (key, value) => {
    const input = element(`what-if-${key}`);
    input.value = value;
    input.fire('input');
    frame(performance.now() + 20);
  };
  const saves = () => (element('save-scenario').onclick(), JSON.parse(saved.splice(0).at(-1)[1]));
  assert.deepEqual([...seen(), element('what-if').hidden, element('what-if-sliders').children.map(({ textContent }) => textContent)], [true, false, true, false, ['Frame rate100 Hz', 'Start speed5 px/s', 'Start angle, 90 is up−53.13°', 'Gravity500 px/s²']]);
  const whole = saves();
  assert.deepEqual([whole.name, whole.steps, whole.clock, whole.parameters, whole.expect], ['a-changed', 400, { rate_hz: 100 }, undefined, { state_hash: 'ab' }]);
  element('time').value = '20';
  element('time').fire('input');
  slid('GRAVITY', 903.7);
  slid('rate', 49.6);
  assert.deepEqual([...seen(), used.at(-1), loaded.slice(9, 13), row(), text('name')], [false, true, false, '900,0.5,1,1,1', [1, 200, 0, 50], 20, 'a']);
  assert.match(text('what-if-note'), /^Lands at x 40 px after 2 s, the file’s run at x 40 px after 2 s\. Ends at x 80, y 40 px, 0 px from where the file’s run ends\.$/);
  assert.match(text('verdict'), /^Not the file’s runchanged here/);
  assert.ok(element('replay').getContext().log.some(line => line.startsWith('stroke quiet 3 dashed')));
  const { parameters: given, clock, steps } = saves();
  assert.deepEqual([given, clock, steps, data().replay], [{ GRAVITY: 900 }, { rate_hz: 50 }, 200, 'agrees']);
  for (const key of ['ArrowRight', 'Home']) windowEvents.fire('keydown', { key, target: element('what-if-rate') });
  assert.equal(row(), 20); // These keys move the slider.
  element('file-run').onclick();
  assert.deepEqual([...seen(), text('what-if-note')], [true, false, true, '']);
  assert.match(text('verdict'), /^Replayed in this browser/);
  await opened([run('a', { steps: 40_001 })]);
  assert.equal(element('what-if').hidden, true);
});

test('a page of another width is drawn anew', async () => {
  await opened([run('a')]);
  element('replay').parentElement.clientWidth = element('ticks').clientWidth = element('.columns').clientWidth = 100;
  resize();
  assert.deepEqual(Plot.all.slice(-4).map(({ width }) => width), [200, 200, 200, 200]);
  assert.deepEqual([element('replay').width, element('replay').getContext().log[0], element('ticks').width, element('ticks').getContext().log.length], [200, 'fill screen: box 0,0 200,160', 200, 2]);
  element('ticks').clientWidth = element('.columns').clientWidth = 200;
});

test('the playground takes the stage, and gives it back', async () => {
  await opened([run('a')]);
  const controls = () => [data().mode, element('replay-controls').hidden, element('fling-controls').hidden, ...['mode-replay', 'mode-fling'].map(id => element(id).attributes['aria-pressed'])];
  assert.deepEqual(controls(), ['replay', false, true, 'true', 'false']);
  element('mode-fling').fire('click');
  assert.deepEqual(controls(), ['fling', true, false, 'false', 'true']);
  frame(100);
  frame(116);
  assert.deepEqual([rowShown(), element('readouts').querySelector('[data-name=x]').textContent], ['1', '45.00']);
  assert.match(text('verdict'), /same bits/);
  assert.deepEqual([text('name'), text('title'), element('description').hidden], ['Your fling', '400 frames, 4.0 s, flung by hand', true]);
  for (const id of ['verdict', 'contacts']) element(id).textContent = 'old';
  element('replay').fire('pointerdown', { clientX: 110, clientY: 25, timeStamp: 120 });
  for (const time of [330, 346, 600, 616]) frame(time);
  assert.deepEqual([text('verdict'), text('contacts').slice(0, 4)], ['old', 'Step']); // The verdict comes when it is let go.
  element('mode-replay').fire('click');
  assert.deepEqual([text('name'), ...controls()], ['a', 'replay', false, true, 'true', 'false']);
  frame(132);
  frame(148);
  assert.deepEqual([frames, rowShown()], [4, '0']);
  await opened([run('a')], { start: () => Promise.reject(new Error('no WebAssembly')) });
  assert.deepEqual([data().replay, element('mode-fling').disabled, text('contacts')], ['none', true, '2, which this page does not have without its replay.']);
  assert.match(text('verdict'), /this browser runs no WebAssembly/);
});
