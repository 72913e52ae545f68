// Charts: what they say of a moment, where its marks are, and what a pointer does on them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import Plot, { element, load, saved } from './stand_in.mjs';

const [{ Charts }, { Moment }, series] = await Promise.all(['charts', 'moment', 'series'].map(load));

const rows = { step: [0, 2, 4, 6, 8], t: [0, 1, 2, 3, 4], dt: [0, 0.5, 0.5, 0.5, 0.5], x: [0, 3, 6, 9, 12], y: [0, 10, 20, 30, 40], vx: [6, 6, 6, 6, -8], vy: [8, 10, 20, NaN, 0] };
const sizes = [{ step: 0, window: [100, 80], sprite: [10, 20] }];
const result = { rows, contacts: { step: [3, 8], wall: [4, 8] }, run: { name: 'fling', constants: [500], result: { at_rest_since_s: null } } };
const other = { label: 'golden', name: 'golden file', rows, distances: [0, 0, 1, 2, 3] };

function charted(more) {
  Plot.all = [];
  const moment = new Moment({ ...result, ...more }.rows), sought = [];
  const charts = new Charts({ ...result, ...more }, sizes, moment, row => sought.push(row));
  assert.ok([...charts.draw()].length === Plot.all.length && Plot.all.length > 0, 'one a step');
  const range = () => { const { min, max } = Plot.all.at(-1).scales.x; return [min, max]; };
  return { charts, moment, sought, range, plots: Plot.all };
}
const figures = id => element(id).children.map(({ id: of, textContent }) => `${of}: ${textContent}`);
const marks = ({ over }) => over.children.map(({ attributes, hidden, style }) => `${attributes.class} ${hidden ? 'hidden' : style.transform}`);

test('the values, and their marks, are those of the moment', () => {
  const { moment, plots } = charted({ divergence: 6 });
  moment.show(3);
  assert.deepEqual(figures('charts'), ['chart-position: Position, pxx 9.0y 30.0CSV', 'chart-velocity: Velocity, px/svx 6.0vy –CSV', 'chart-energy: Energy, px²/s²run –CSV']);
  assert.deepEqual(figures('more-charts'), ['chart-dt: Frame time, msdt 500.000CSV']);
  for (const plot of plots) assert.deepEqual(marks(plot), ['playhead translateX(150px)', 'divergence translateX(150px)']);
  assert.deepEqual([plots[0].over.children[1].attributes.title, element('charts').querySelector('button').attributes['aria-label']], ['first difference at step 6', 'Save Position as CSV']);
  assert.deepEqual(element('charts').querySelectorAll('i').map(({ attributes }) => attributes.class.replace(/ +/, ' ')), ['swatch tint-blue', 'swatch tint-orange', 'swatch tint-blue', 'swatch tint-orange', 'swatch tint-green']);
  assert.equal(plots[0].root.attributes['aria-label'], 'Position over time. x: 0 to 12 px; y: 0 to 40 px.');
  const table = element('charts-table').querySelectorAll('tr').map(row => row.children.map(({ textContent }) => textContent).join('|'));
  assert.deepEqual([table[0], table[1], table.at(-1)], ['chart|series|unit|smallest|largest|at the end', 'Position|x|px|0|12|12', 'Frame time|dt|ms|500|500|500']);
});

test('a pointer shows the last row up to it; a mouse only at rest', () => {
  const { plots: [{ over }], sought, charts } = charted();
  const at = (type, row, more) => (over.fire(type, { clientX: 10 + 50 * row, ...more }), sought.splice(0));
  const mouse = { pointerType: 'mouse' }, finger = { pointerType: 'touch', isPrimary: true };
  assert.deepEqual([at('click', 2), at('click', 2.9), at('click', -1), at('click', 9)], [[2], [2], [0], [4]]);
  assert.deepEqual([at('pointermove', 2, mouse), at('pointermove', 2, { ...mouse, buttons: 1 }), at('pointerdown', 2, mouse)], [[2], [], []]);
  assert.deepEqual([at('pointermove', 1, finger), at('pointermove', 1, { pointerType: 'touch' }), at('pointerdown', 1, finger)], [[1], [], [1]]);
  charts.followsMouse = () => false;
  assert.deepEqual([at('pointermove', 2, mouse), at('pointermove', 2, finger)], [[], [2]]);
});

test('they open on the part that moves, and one zoom is that of all', () => {
  const opened = since => charted({ run: { ...result.run, result: { at_rest_since_s: since } } }).range();
  assert.deepEqual([null, 0, 2, 2.5, 2.8, 3].map(opened), [[0, 4], [0, 4], [0, 2.16], [0, 2.7], [0, 4], [0, 4]]);
  const { charts, plots, moment } = charted();
  moment.show(1);
  plots[1].setScale('x', { min: 2, max: 4 });
  assert.deepEqual(plots.map(({ scales: { x } }) => [x.min, x.max]), plots.map(() => [2, 4]));
  assert.deepEqual(marks(plots[0]), ['playhead hidden']);
  plots[2].over.fire('dblclick');
  assert.deepEqual(plots.map(({ scales: { x } }) => [x.min, x.max]), plots.map(() => [0, 4]));
  charts.zoom([1, 3]);
  assert.deepEqual(marks(plots[3]), ['playhead translateX(0px)']);
});

test('the overview of a long run selects what the others show', () => {
  const t = Float64Array.from({ length: 50_000 }, (_, i) => i / 100), long = Object.fromEntries(['t', 'dt', 'x', 'y', 'vx', 'vy'].map(name => [name, t]));
  const { plots: [speed, contacts, position], range } = charted({ rows: { ...long, step: t.map((_, i) => i) } });
  assert.deepEqual(range(), [0, 10]);
  for (const plot of [speed, contacts]) assert.deepEqual([plot.select.left, plot.select.width].map(px => px.toFixed(3)), ['0.000', (200 * 10 / 499.99).toFixed(3)]);
  speed.select = { left: 50, width: 100 };
  speed.options.hooks.setSelect[0](speed);
  assert.deepEqual([position.scales.x.min, position.scales.x.max].map(Math.round), [125, 375]);
});

test('where rows are dense, a curve is the area between its smallest and its largest values', () => {
  const t = Float64Array.from({ length: 50_000 }, (_, i) => i / 100), step = t.map((_, i) => i), wave = t.map((_, i) => (i % 2 ? 1 : i / 50_000));
  const { plots, charts } = charted({ rows: { step, t, dt: t, x: wave, y: t, vx: t, vy: t } }), [, , plot] = plots, path = (first, last) => plot.options.series[1].paths(plot, 1, first, last);
  assert.deepEqual([path(0, 1599).kind, path(0, 1600).kind, path(0, 1599).fill], ['', undefined, null], 'four rows to each of 400 px');
  charts.zoom(null);
  const { fill, stroke } = path(0, 49_999), parts = stroke.shape.join(' ').split('from').slice(1).map(line => line.trim().split(' ').map(place => place.split(',').map(Number)));
  assert.deepEqual([fill.shape.length, parts.length, parts.map(line => line.length)], [400, 2, [400, 400]]);
  assert.deepEqual([parts[0][0], parts[0][399], parts[1][0]], [[40, 20], [439, 20], [40, 220]], 'the largest of each is 1, and the smallest begins at 0');
  assert.ok(Math.abs(parts[1][200][1] - 120) < 1, 'half of the run: 0.5');
  const gap = series.envelopeOf([0, 1, 2, 3], [5, null, NaN, 7], 0, 3, 0, 4, 4);
  assert.deepEqual(gap, [{ column: 0, low: 5, high: 5 }, { column: 3, low: 7, high: 7 }]);
});

test('each chart has its axes, dashes and points', () => {
  const causes = { step: [0, 8] }, errors = { step: [0, 8], model: [0, 2], truncation: [0, 1], implementation: [0, 1] };
  for (const name of ['gravity', 'drag', 'lift', 'bounce', 'sum']) causes[name] = [0, 1];
  const { plots } = charted({ other, causes, errors, contactErrors: { step: [4], time_error: [1], effective_restitution: [2] } });
  const looks = plots.map(({ place, options: { series, axes, scales } }, at) => `${place.id.slice(6)}: ${series.slice(1).map((each, i) => [each.stroke(), each.dash && 'dashed', each.spanGaps && 'joined', each.points.show && `points of ${each.points.size}`,
    each.paths?.(plots[at], i + 1, 0, 4)?.kind].filter(Boolean).join(' ')).join(', ')}${scales.y.distr === 3 ? '; logarithmic' : ''}${axes[0].show ? '; with times' : ''}`);
  assert.deepEqual(looks, ['distance: vermilion; logarithmic', 'position: blue, orange, blue dashed, orange dashed', 'velocity: blue, orange, blue dashed, orange dashed', 'energy: green',
    'errors: orange, blue, green; logarithmic; with times', 'drift: blue joined, green joined, vermilion joined, purple joined, ink dashed joined; with times', 'contact-time: vermilion points of 7; with times',
    'contact-restitution: purple points of 7; with times', 'dt: blue steps -1; with times']);
  for (const { options: { axes, height } } of plots) assert.equal(height, axes[0].show ? 132 : 108);
  assert.deepEqual(plots[1].place.querySelectorAll('i').map(({ attributes }) => attributes.class.replace(/ +/, ' ')), ['swatch tint-blue', 'swatch tint-orange', 'swatch dashed tint-blue', 'swatch dashed tint-orange']);
  assert.deepEqual(plots[1].options.axes.map(({ values }) => values(null, [1, 250_000])), [['1 s', '250,000 s'], ['1', '0.25 M']]);
  assert.deepEqual(plots[1].data.map(values => values[4]), [4, 12, 40, 12, 40]);
  plots[0].redraw(); // Contacts of rows at 2 and 4 s on an axis from 40 to 440 px, at its foot of 220 px.
  assert.deepEqual(plots[0].ctx.log, ['fill purple: from 240,202 248,218 232,218', 'fill orange: from 440,218 432,202 448,202']);
});

test('a run that goes on keeps its charts; what is not finite is not drawn', () => {
  const { charts, plots, moment } = charted();
  const longer = Object.fromEntries(Object.entries(rows).map(([name, values]) => [name, [...values, 5]]));
  moment.replace(longer);
  charts.update({ ...result, rows: longer, run: { ...result.run, non_finite: 'vy is NaN' } });
  assert.deepEqual([Plot.all.length, plots[1].data[0].length, plots[1].data[2], plots[1].scales.x], [4, 6, [8, 10, 20, null, 0, 5], { min: 0, max: 5 }]);
  saved.length = 0;
  element('charts').querySelector('button').fire('click');
  assert.deepEqual(saved.map(([name, text]) => [name, text.split('\n').at(-2)]), [['fling-position.csv', '5,5,5,5']]);
});
