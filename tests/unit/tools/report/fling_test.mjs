// The playground: what the hand and the display give the core, and what it shows beside.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Element, element, frame, load, saved, textOf, windowEvents } from './stand_in.mjs';

const { Playground } = await load('fling');

const keyed = [...textOf('runs.html').matchAll(/id="([\w-]+)" data-key="(\w)"( class="primary")?( disabled)?>(.*?) <kbd>(\w)</g)].map(([, id, key, , disabled, ...parts]) => [id, key, Boolean(disabled), ...parts]);
for (const [id, key] of keyed) element(id).dataset.key = key;
const record = [100, 80, 10, 20, 1, 2, 3, 4, 1, 0, 0, 2, 1, 0.016, 0, 0];
const flown = rate => (rate === 144 ? { t: [], x: [], y: [] } : { t: [0, 1, 2], x: [rate, rate + 3, rate + 9], y: [0, 4, 8] });

/** A playground of 100 x 80 px; each call of the core and the view is a line of `said`. */
function opened(state = {}) {
  const said = [], say = (name, result) => (...values) => (said.push([name, ...values.map(value => (typeof value === 'object' ? JSON.stringify(value) : value))].join(' ')), result?.(...values));
  let frames = 0;
  const core = { useConstants: say('constants'), measureBy() {}, liveStart: say('start'), liveGrab: say('grab'), liveDrag: say('drag'), liveRelease: say('release', () => ({ x: 41, y: 31, vx: 300, vy: -400 })), liveVelocity: say('velocity', () => ({ vx: 6, vy: 8 })),
    liveFrame: say('frame', dt => ({ t: ++frames / 10, x: 40 + frames, y: 30, vx: 1, vy: 2, contact: 0, frames, ...state })), liveScenario: () => ({ record, stateHash: 'ab' }),
    flight: say('flight', (_, rate) => flown(rate)), load: say('load', () => 1), playTo: say('play'), finish: () => ({ stateHash: 'ab', contacts: {}, bounces: {}, steps: 1 }), rows: () => ({ step: [0], t: [0], x: [1], y: [2] }), contacts: () => ({}),
    errors: () => ({}), contactErrors: () => ({}), causes: () => ({}) };
  const canvas = new Element('canvas');
  const view = { painter: { canvas, scale: 4, pointOf: ({ clientX, clientY }) => [clientX, clientY] }, sizes: [{ step: 0, window: [100, 80], sprite: [10, 20] }], player: { pause() {}, play: say('loop') }, moment: { body: () => ({ x: 5, y: 5, vx: 0, vy: 0 }) },
    run: { name: 'first', constants: [500], parameters: { values: [9, 8], given: { GRAVITY: 9 } } }, paint: () => {}, show: result => said.push(`show ${result.outcome}`) };
  const playground = new Playground(core, view);
  assert.equal(said.shift(), 'constants [9,8]'); // Of the run that it is flung beside.
  const hand = (type, clientX, clientY, timeStamp, more) => canvas.fire(type, { clientX, clientY, timeStamp, ...more });
  const told = () => said.splice(0);
  return { playground, view, core, hand, told };
}
const flights = (start, rates = [24, 60, 144, 240, 0]) => rates.map(rate => `flight ${JSON.stringify(start)} ${rate} 20`);
const body = { x: 41, y: 31, vx: 300, vy: -400 }, size = { step: 0, window: [100, 80], sprite: [10, 20] };
const keys = () => element('flights').children.map(({ textContent }) => textContent);

test('it begins in the middle at the top, and plays the frames of the display', () => {
  frame(0);
  const { told, playground } = opened();
  assert.deepEqual(told(), [`start ${JSON.stringify({ step: 0, t: 0, contact: 0, frames: 0, x: 45, y: 0, vx: 0, vy: 0, ...size })}`]);
  const played = [1000, 1016, 1016, 1266, 1517, 1527].map(time => (frame(time), told().filter(line => line.startsWith('frame')).join()));
  assert.deepEqual(played, ['', 'frame 0.016', '', 'frame 0.25', '', 'frame 0.01']); // None is longer than 0.25 s.
  assert.deepEqual(playground.trail, { step: [0, 0, 0, 0], x: [45, 41, 42, 43], y: [0, 30, 30, 30] });
  assert.deepEqual([playground.isLive, playground.isHeld, playground.look({ t: 9 })], [true, false, { trail: playground.trail }]);
  const isLive = () => 'live' in document.documentElement.dataset, live = isLive();
  playground.end();
  assert.deepEqual([live, isLive()], [true, false]);
});

test('charts follow twenty times a second, and leave a hand its frames', () => {
  const shows = isHeld => {
    const { playground, hand, told } = opened();
    if (isHeld) hand('pointerdown', 45, 0, 0);
    for (let i = 0; i <= 100; ++i) frame(6000 + 10 * i);
    playground.end();
    return told().filter(line => line === 'show agrees').length;
  };
  assert.deepEqual([shows(false), shows(true)], [20, 5]);
});

test('it sleeps after 90 frames at rest or 200,000, and not in the hand', () => {
  const frames = (state, isHeld) => {
    const { playground, hand } = opened({ x: 45, y: 0, ...state });
    if (isHeld) hand('pointerdown', 45, 0, 0);
    let played = 0;
    for (frame(5000); playground.isLive && played < 200; ++played) frame(5010 + 10 * played);
    playground.end();
    return played;
  };
  assert.deepEqual([frames({}), frames({}, true), frames({ x: NaN, frames: 199_999 }), frames({ frames: 200_000 })], [90, 200, 200, 1]);
});

test('a hand grabs what it reaches, leads it and throws it', () => {
  const { hand, told, playground } = opened();
  // The sprite is at 45 .. 55, 0 .. 20; a hand reaches a quarter of the longer side farther, or of 24 px of the canvas.
  for (const [x, y, more] of [[39, 10], [61, 10], [50, 26], [50, -6], [50, 10, { button: 2 }]]) hand('pointerdown', x, y, 1, more);
  hand('pointermove', 50, 10, 1);
  hand('pointerup', 50, 10, 1);
  assert.deepEqual(told().slice(1), []);
  hand('pointerdown', 60, 24.6, 1.5);
  assert.deepEqual(told(), [`start ${JSON.stringify({ step: 0, t: 0, contact: 0, frames: 0, x: 45, y: 0, vx: 0, vy: 0, ...size })}`, 'grab 60 25 1500']);
  hand('pointermove', 61.4, 26, 3);
  hand('pointermove', 62, 27, 2); // Its clock does not go backwards.
  hand('pointerdown', 50, 10, 4);
  assert.deepEqual(told(), ['drag 61 26 3000', 'drag 62 27 3000']);
  assert.equal(playground.isHeld, true);
  frame(2000);
  frame(2016);
  assert.deepEqual(told(), ['velocity 2000000', 'frame 0.016', 'velocity 2016000', 'load ' + JSON.stringify(record), 'play 1', 'show agrees']);
  assert.deepEqual(playground.look(playground.body), { isHeld: true, trail: playground.trail, label: '10 px/s' });
  hand('pointerup', 63, 28, 2020);
  assert.deepEqual(told(), ['release 63 28 2020000', ...flights({ ...body, ...size })]);
  hand('pointercancel', 63, 28, 2030);
  assert.deepEqual([told(), playground.isHeld], [[], false]);
  playground.end();
  hand('pointerdown', 50, 10, 3000);
  assert.deepEqual(told(), []);
  const far = opened();
  far.view.painter.scale = 0.5;
  for (const x of [32, 33]) far.hand('pointerdown', x, 10, 1);
  assert.equal(far.told().at(-1), 'grab 33 10 1000');
  far.playground.end();
});

test('a throw flies beside itself at other rates since it was let go', () => {
  const { hand, playground, told, view } = opened();
  const distances = () => element('flights').querySelectorAll('output').map(({ textContent }) => textContent);
  assert.deepEqual([keys(), element('again').disabled, element('slow').disabled, element('fling-hint').textContent], [[], true, true, 'Drag the hyrax and let go.']);
  hand('pointerdown', 50, 10, 1);
  frame(3000);
  for (let i = 1; i <= 10; ++i) frame(3000 + 16 * i); // Held for a second of the core's time.
  hand('pointerup', 50, 10, 3200);
  assert.deepEqual([keys().map(text => text.trim()), element('again').disabled, element('fling-hint').textContent], [['24 Hz', '60 Hz', '240 Hz', 'exact', 'yours'], false, 'The same throw at other frame rates: distance from the exact fling.']);
  assert.deepEqual(element('flights').querySelectorAll('i').map(({ attributes }) => attributes.class.trim()), ['swatch tint-ramp-1', 'swatch tint-ramp-3', 'swatch tint-ramp-6', 'swatch tint-ink dashed', 'swatch tint-path']);
  assert.deepEqual(playground.look({ t: 0.9 }), { trail: playground.trail });
  const look = playground.look({ t: 2.5, x: 6, y: 12 }); // 1.5 s after that: the rows of 1 s.
  assert.deepEqual(look.ghosts.map(({ rate, tint, at }) => [rate, tint, at.x, at.y]), [[24, 'ramp-1', 27, 4], [60, 'ramp-3', 63, 4], [240, 'ramp-6', 243, 4], [0, 'ink', 3, 4]]);
  assert.deepEqual(distances(), ['24.0 px', '60.0 px', '240.0 px', '0.0 px', '8.5 px']);
  assert.deepEqual(look.flights.map(({ tint, rows }) => [tint, rows.x[0]]), [['ramp-1', 24], ['ramp-3', 60], ['ramp-6', 240], ['ink', 0]]);
  // A bounce in slow motion: those after the throw in turn, 0.15 s before and after.
  view.result = { rows: { t: [0, 1, 1.3, 1.5, 1.6, 2, 2.1, 2.2, 2.3] }, contacts: { t: [0.5, 1, 1.5, 2.2] } };
  told();
  for (const key of ['s', 'S', 's']) windowEvents.fire('keydown', { key, target: element('replay') });
  assert.deepEqual(told(), ['loop [2,4] 0.1', 'loop [5,8] 0.1', 'loop [2,4] 0.1']);
  view.result.contacts.t = [0.5]; // Before the throw.
  for (const ctrlKey of [true, false]) windowEvents.fire('keydown', { key: 's', ctrlKey, target: element('replay') });
  windowEvents.fire('keydown', { key: 's', target: { tagName: 'SELECT' } });
  assert.deepEqual(told(), []);
  element('again').fire('click');
  assert.deepEqual(told(), [...flights({ ...body, ...size }), `start ${JSON.stringify({ step: 0, t: 0, contact: 0, frames: 0, ...body, ...size })}`]);
  assert.deepEqual(playground.look({ t: 1.5, x: 0, y: 0 }).ghosts[0].at.x, 27);
  windowEvents.fire('keydown', { key: 'r', target: element('replay') });
  assert.deepEqual([told().length, keys(), playground.body.x], [1, [], 45]);
  playground.end();
});

test('what was flung is saved as a scenario of its own', () => {
  const { playground } = opened();
  frame(4000);
  assert.equal(element('download-scenario').disabled, true);
  frame(4016);
  assert.deepEqual([element('download-scenario').disabled, element('fling-note').textContent], [false, '1 frames, 0.1 s']);
  saved.length = 0;
  element('download-scenario').fire('click');
  const [[name, text]] = saved, { clock, expect, description, parameters } = JSON.parse(text);
  assert.deepEqual([name, parameters, clock.dt_s, expect.state_hash, description.split(', ')[0]], ['fling.json', { GRAVITY: 9 }, [0.016], 'ab', 'Flung by hand in a report of first']);
  assert.equal(element('fling-note').textContent, 'Replay it: hyrax-sim run fling.json');
  playground.end();
});

test('keys and rates are those that the page and its README.md say', () => {
  assert.deepEqual(keyed, [['again', 'a', true, 'Again', 'A'], ['slow', 's', true, 'A bounce in slow motion', 'S'], ['restart', 'r', false, 'Start over', 'R'], ['download-scenario', 'd', true, 'Download scenario', 'D']]);
  assert.match(textOf('README.md').replaceAll(/\s+/g, ' '), /the same throw at 24, 60, 144 and 240 Hz and the exact fling.*`A` throws it again, `S` shows a bounce a tenth as fast, `R` starts over\. The download \(`D`\)/);
});
