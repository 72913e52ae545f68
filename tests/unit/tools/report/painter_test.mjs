// What the stage draws, by colour and place. The canvas has 4 px for each px of the window, on a display of 2 px to the point.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { count, element, load, windowEvents } from './stand_in.mjs';

const { color, followLook, Painter, wallColors } = await load('painter');

const canvas = element('replay');
canvas.parentElement = { clientWidth: 200 };
// In step 5 the window shrinks from 100 x 80 to 50 x 40, and the sprite turns from 10 x 20 to 20 x 10.
const sizes = [{ step: 0, window: [100, 80], sprite: [10, 20] }, { step: 5, window: [50, 40], sprite: [20, 10] }];
const rows = { step: [0, 2, 4, 6, 8], t: [0, 1, 2, 3, 4], x: [10, 15, 20, 10, 15], y: [0, 10, 20, 25, 30], vx: [5, 5, 5, -5, 5], vy: [10, 10, 10, 10, 10] };
const still = { step: 0, x: 30, y: 10, vx: 0, vy: 0 };

function drawn(scene, body = still, looks) {
  const painter = new Painter(canvas, () => {});
  painter.setScene({ sizes, inputs: [], ...scene });
  painter.paint(body, looks);
  return canvas.getContext().log;
}
/** Without the window and the hyrax. */
const layer = scene => drawn(scene).slice(1, -2);

test('the stage is as large as its place, and has the pixels and the points of the display', () => {
  const sized = ([width, height], room, all = 1000) => {
    canvas.parentElement.clientWidth = room;
    globalThis.innerHeight = all;
    const painter = new Painter(canvas, () => {});
    painter.setScene({ sizes: [{ step: 0, window: [10, 10], sprite: [1, 1] }, { step: 1, window: [width, height], sprite: [1, 1] }], inputs: [] });
    return [canvas.style.width, canvas.style.height, canvas.width, canvas.height, painter.scale];
  };
  assert.deepEqual(sized([100, 80], 200), ['200px', '160px', 400, 320, 4]);
  assert.deepEqual(sized([100, 100], 900), ['460px', '460px', 920, 920, 9.2]);
  assert.deepEqual(sized([100, 100], 900, 100), ['180px', '180px', 360, 360, 3.6]);
  assert.deepEqual(sized([100, 100], 900, 9000), ['600px', '600px', 1200, 1200, 12]);
  assert.deepEqual(sized([1000, 10], 200), ['200px', '40px', 400, 80, 0.4]);
  sized([100, 80], 200);
  const painter = new Painter(canvas, () => {});
  painter.setScene({ sizes, inputs: [] });
  assert.deepEqual(painter.pointOf({ clientX: 10 + 50, clientY: 20 + 25 }), [25, 20]);
});

test('a path goes through the middles of the sprite, with its sizes, and ends in a cross at the row before one that is not finite', () => {
  assert.deepEqual(layer({ rows }), ['stroke path 3: from 60,40 80,80 100,120 80,120 100,140']);
  const other = { ...rows, x: rows.x.map(x => x + 1), y: rows.y };
  assert.deepEqual(layer({ rows, other }), ['stroke bad 3 dashed: from 64,40 84,80 104,120 84,120 104,140', 'stroke path 3: from 60,40 80,80 100,120 80,120 100,140']);
  assert.deepEqual(layer({ rows: { ...rows, x: [10, 15, 60, 10, 15] } }), ['stroke path 3: from 60,40 80,80 from 260,120 from 80,120 100,140',
    'stroke path 3 dashed: from 80,80 260,120 from 260,120 80,120']);
  const slow = px => layer({ rows: { ...rows, x: [0, 1, 2, 3, 4].map(i => 10 + px * i), y: [0, 0, 0, 0, 0], vx: [0, 0, 0, 0, 0], vy: [0, 0, 0, 0, 0] } }).length;
  assert.deepEqual([slow(2), slow(2.25)], [1, 2]); // Up to 2 px need no speed.
  assert.deepEqual(layer({ rows: { ...rows, x: [10, 15, 15.1, 10, 15], y: [0, 10, 10.1, 20, 30] } }), ['stroke path 3: from 60,40 80,80 80,100 100,140']);
  const end = (x, bad) => layer({ rows: { ...rows, x: [10, 15, 20, x, x], vy: [10, 10, 10, 5, bad] } }).filter(line => line.includes('bad'));
  const cross = x => `stroke bad 6: from ${x - 14},134 ${x + 14},106 from ${x - 14},106 ${x + 14},134`;
  assert.deepEqual(end(10, NaN), [cross(80), 'text bad: not finite left 102.4,103.2']);
  assert.deepEqual(end(60, Infinity), [cross(280), 'text bad: not finite right 257.6,103.2']);
  assert.deepEqual(end(10, 5), []);
  assert.equal(layer({ rows, other: { ...rows, y: [0, 10, 20, 25, NaN] } }).length, 4);
});

test('a contact is a stroke along its wall in its colour, an input a ring at its row with its name, a hand’s way dots at the row after', () => {
  const met = (step, wall, x, y) => layer({ rows, contacts: { step: [step], wall: [wall], x: [x], y: [y] } }).slice(1);
  // 3 px inside of a wall at 0, 400 and 320 px, or, in the smaller window, at 0, 200 and 160; from 0.3 to 0.7 of a side.
  for (const [step, wall, expected] of [[2, 1, 'sky-blue 6: from 3,144 3,176'], [2, 2, 'vermilion 6: from 397,144 397,176'], [2, 4, 'purple 6: from 132,3 148,3'],
    [2, 8, 'orange 6: from 132,317 148,317'], [6, 1, 'sky-blue 6: from 3,132 3,148'], [6, 2, 'vermilion 6: from 197,132 197,148'],
    [6, 4, 'purple 6: from 144,3 176,3'], [6, 8, 'orange 6: from 144,157 176,157']])
    assert.deepEqual(met(step, wall, 30, 30), [`stroke ${expected}`]);
  assert.deepEqual(wallColors, { 1: 'sky-blue', 2: 'vermilion', 4: 'purple', 8: 'orange' });
  const many = Array.from({ length: 501 }, () => 2);
  assert.equal(layer({ rows, contacts: { step: many, wall: many, x: many, y: many } }).length, 501);
  const of = (...inputs) => layer({ rows, inputs: inputs.map(([frame, kind]) => ({ frame, kind })) }).slice(1);
  assert.deepEqual(of([2, 'grab']), ['stroke ink 3: circle 80,80 r 8', 'text ink: grab left 96,68']);
  assert.deepEqual(of([2, 'place']), ['fill ink: circle 100,120 r 3']);
  assert.deepEqual(of([6, 'fling']), ['stroke ink 3: circle 80,120 r 8', 'text ink: fling left 96,108']);
  assert.deepEqual(of([2, 'grab'], [2, 'release'], [4, 'fling']).filter(line => line.startsWith('text')), ['text ink: grab left 96,68', 'text ink: fling left 116,108']);
  assert.deepEqual(of([9, 'grab']), []);
});

test('the hyrax looks where it goes, stands and hangs; an arrow shows the velocity, 0.12 s long and at most 90 points', () => {
  const of = (body, looks) => drawn({}, { ...still, ...body }, looks);
  const whole = 'fill screen: box 0,0 400,320', box = 'stroke box 2: box 120,40 40,80';
  assert.deepEqual(of({}), [whole, box, 'image fly: 120,60 40,40']);
  assert.deepEqual(of({ vx: -9 }), [whole, box, 'image fly: 160,60 -40,40']);
  assert.deepEqual(of({ y: 10, vy: 59 }, { isHeld: true })[2], 'image held: 120,60 40,40');
  assert.deepEqual(of({ step: 5 }), ['fill screen: box 0,0 200,160', 'stroke box 2: box 120,40 80,40', 'image fly: 140,40 40,40']);
  for (const [y, vy, pose] of [[58.9, 0, 'fly'], [59, 0, 'stand'], [60, -59, 'stand'], [60, 60, 'fly']]) assert.match(of({ y, vy })[2], new RegExp(`^image ${pose}:`));
  assert.match(of({ y: 60 }, { isHeld: true })[2], /held/);
  const arrow = (vx, vy) => drawn({}, { ...still, vx, vy }).slice(3);
  assert.deepEqual(arrow(0, 20), []);
  assert.deepEqual(arrow(0, 100), ['stroke ink 3: from 140,80 140,128', 'fill ink: from 140,140 132.8,128 147.2,128']);
  assert.deepEqual(arrow(-100, 0), ['stroke ink 3: from 140,80 92,80', 'fill ink: from 80,80 92,72.8 92,87.2']);
  assert.deepEqual(arrow(3000, 4000)[0], 'stroke ink 3: from 140,80 248,224');
});

test('a dashed path that goes over itself again is drawn there once', () => {
  // Down 40 px, up the same way, aside and down beside it: the window is 4 times as large on the canvas, cells are 8 px.
  const over = { t: [0, 1, 2, 3, 4], x: [0, 0, 0, 10, 10], y: [0, 40, 0, 0, 40], vx: [0, 99, 99, 99, 99], vy: [99, 99, 99, 99, 99], step: [0, 0, 0, 0, 0] };
  const [dashed, solid] = [drawn({ rows: over, other: over })].flat().filter(line => line.startsWith('stroke')).map(line => line.replace(/^.*: /, ''));
  assert.equal(solid, 'from 20,40 20,200 20,40 60,40 60,200');
  assert.equal(dashed, 'from 20,40 20,200 20,184 from 20,40 60,40 60,200');
});

test('both sprites are magnified, whole or by their corners, with a rule from one to the other', () => {
  const painter = new Painter(canvas, () => {}), glass = document.createElement('canvas');
  painter.setScene({ sizes, inputs: [] });
  glass.clientWidth = 200;
  glass.clientHeight = 100; // 400 x 200 px.
  const of = (dx, dy) => [painter.magnify(glass, { x: 5, y: 6 }, { x: 5 + dx, y: 6 + dy }, [10, 20], 'bad'), ...glass.getContext().log];
  // 1 px: 3 px are 200 px high, both corners as far from the middle.
  const [times, ...lines] = of(0.6, 0.8), short = text => text.replace(/\d+\.\d+/g, at => Math.round(at));
  assert.equal(Math.round(times * painter.scale), 67);
  assert.deepEqual(lines.map(short), ['stroke path 6: box 180,73 667,1333', 'stroke bad 4 dashed: box 220,127 667,1333', 'stroke ink 3: from 180,73 220,127', 'stroke ink 3: from 174,78 186,69', 'stroke ink 3: from 214,131 226,122']);
  // 30 px: both are on it.
  const boxes = of(0, 30).filter(line => String(line).includes('box')).map(line => line.match(/box ([\d.]+),([\d.]+) ([\d.]+),([\d.]+)/).slice(1).map(Number));
  for (const [x, y, width, height] of boxes) assert.ok(x > 0 && y > 0 && x + width < 400 && y + height < 200, boxes.join(' '));
});

test('others fly beside it: their paths below it, they as pale as ghosts', () => {
  const flights = [{ rows: { t: [0, 1], x: [0, 10], y: [0, 10] }, tint: 'green' }, { rows: { t: [0, 1], x: [10, 20], y: [0, 10] }, tint: 'ink' }];
  const trail = { step: [0, 0], x: [0, 30], y: [0, 10] };
  assert.deepEqual(drawn({ rows }, still, { flights, trail, ghosts: [{ at: { x: 1, y: 2, vx: -1 }, tint: 'green' }] }).slice(1), [
    'stroke green 2: from 20,40 60,80', 'stroke ink 2 dashed: from 60,40 100,80', 'stroke path 3: from 20,40 140,80',
    'stroke green 2 of 0.4: box 4,8 40,80', 'image fly of 0.4: 44,28 -40,40', 'stroke box 2: box 120,40 40,80', 'image fly: 120,60 40,40']);
  // Of rates the name stands above the end, each in its own line, within the canvas.
  const named = flights.map((each, i) => ({ ...each, name: ['24 Hz', 'exact'][i] }));
  assert.deepEqual(drawn({ rows }, still, { flights: named }).filter(line => line.startsWith('text')), ['text green: 24 Hz center 60,40', 'text ink: exact center 100,14']);
  const painter = new Painter(canvas, () => {}), of = list => (painter.paint(still, { flights: list }), canvas.getContext().log.filter(line => line.startsWith('stroke green')).length);
  painter.setScene({ sizes, inputs: [] });
  assert.deepEqual([of(flights), of([]), of(flights.slice(1)), of(flights)], [1, 0, 0, 1]);
  document.documentElement.dataset.paper = '';
  assert.equal(of(flights), 0); // It is drawn again in the colours of paper.
});

test('a label is above the sprite, below it at the top, and inside the window', () => {
  const at = (x, y) => drawn({}, { ...still, x, y }, { label: '4 px' }).at(-1); // 40 px wide.
  assert.equal(at(30, 11), 'text ink: 4 px center 140,32');
  assert.equal(at(30, 10), 'text ink: 4 px center 140,160');
  assert.equal(at(-10, 20), 'text ink: 4 px center 20,68');
  assert.equal(at(99, 20), 'text ink: 4 px center 380,68');
});

test('on paper colours are the light ones', () => {
  const seen = [];
  followLook(() => seen.push(color('ink')));
  windowEvents.fire('beforeprint');
  windowEvents.fire('afterprint');
  assert.deepEqual(seen, ['light ink', 'ink']);
});

test('a very long path is drawn in parts that join, up to a time', () => {
  const zigzag = length => ({ step: count(length), t: count(length), x: count(length).map(i => 30 * (i % 2)), y: count(length).map(() => 0), vx: count(length).map(() => 30), vy: count(length).map(() => 0) });
  for (const [length, parts, end] of [[8_000, 17, null], [8_001, 17, 7_999], [20_000, 17, 7_999]]) {
    const painter = new Painter(canvas, () => {});
    painter.setScene({ sizes: sizes.slice(0, 1), inputs: [], rows: zigzag(length) });
    painter.paint(still);
    const strokes = canvas.getContext().log.filter(line => line.startsWith('stroke path'));
    assert.equal(painter.pathEnd, end, length);
    assert.equal(strokes.length, parts, length);
    const [one, next] = strokes.map(line => line.split(' '));
    assert.equal(one.at(-1), next[next.indexOf('from') + 1]);
  }
});
