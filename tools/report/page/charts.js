// Charts over the time of a run, with one cursor and one zoom.
import uPlot from 'uplot';
import { element, firstAtLeast, lastAtMost, make, save } from './data.js';
import { exact, fixed, grouped, rounded } from './numbers.js';
import { color, wallColors } from './painter.js';
import { sizesAt } from './replay.js';
import { tableOf } from './tables.js';

const overviewRowsMin = 50_000;
const gravityOf = run => run.constants[0];

// Specific energy, zero at rest on the floor: (vx^2 + vy^2) / 2 + g (bottom - y).
function energyOf({ run, rows }, sizes) {
  return rows.x.map((_, i) => {
    const { window, sprite } = sizesAt(sizes, rows.step[i]);
    return (rows.vx[i] ** 2 + rows.vy[i] ** 2) / 2 + gravityOf(run) * (window[1] - sprite[1] - rows.y[i]);
  });
}

// Values that only some rows have, as a list over all rows; null draws a gap.
function spread(rows, steps, values, isShown = () => true) {
  const list = new Array(rows.step.length).fill(null);
  let row = 0;
  for (let i = 0; i < steps.length; ++i) {
    while (row < list.length && rows.step[row] < steps[i]) ++row;
    if (row < list.length && rows.step[row] === steps[i] && isShown(values[i])) list[row] = values[i];
  }
  return list;
}

// Points between which the line goes straight on, for a series with `known.isJoined`.
function joined(rows, steps, values) {
  const list = new Array(rows.step.length).fill(undefined);
  for (let i = 0; i < steps.length; ++i) {
    const row = firstAtLeast(rows.step, steps[i]);
    if (row < list.length && rows.step[row] === steps[i]) list[row] = values[i];
  }
  return list;
}

// What the charts show: title, unit, series. A series is {name, color, values, dash, points, steps}; of one
// with `known` only these rows have a value; between those of one that is joined it changes evenly.
function chartsOf(result, sizes) {
  const { rows, errors, other } = result;
  const overlay = (name, tint, values) => (other ? [{ name, color: tint, dash: true, values: spread(rows, other.rows.step, values) }] : []);
  const positive = value => value > 0;
  const errorSeries = (name, tint, key) => ({ name, color: tint, values: spread(rows, errors.step, errors[key], positive) });
  const label = other?.label;
  const charts = [
    { id: 'position', title: 'Position', unit: 'px', decimals: 1, series: [
      { name: 'x', color: 'blue', values: rows.x }, { name: 'y', color: 'orange', values: rows.y },
      ...overlay(`x, ${label}`, 'blue', other?.rows.x), ...overlay(`y, ${label}`, 'orange', other?.rows.y)] },
    { id: 'velocity', title: 'Velocity', unit: 'px/s', decimals: 1, series: [
      { name: 'vx', color: 'blue', values: rows.vx }, { name: 'vy', color: 'orange', values: rows.vy },
      ...overlay(`vx, ${label}`, 'blue', other?.rows.vx), ...overlay(`vy, ${label}`, 'orange', other?.rows.vy)] },
    ...(result.run.constants ? [{ id: 'energy', title: 'Energy', unit: 'px²/s²', decimals: 0, series: [{ name: 'run', color: 'green', values: energyOf(result, sizes) }] }] : []),
    { id: 'dt', title: 'Frame time', unit: 'ms', decimals: 3, range: fromZero, series: [
      { name: 'dt', color: 'blue', steps: true, values: Array.from(rows.dt, (dt, i) => (rows.step[i] === 0 ? null : 1000 * dt)) }] },
  ];
  if (errors?.step.length) {
    // With the drag of 60 Hz both are the same, as in drift_figures.cpp.
    const areOne = errors.model.every((px, i) => Math.abs(px - errors.truncation[i]) <= 1e-9 * px);
    charts.splice(charts.length - 1, 0, { id: 'errors', title: 'Errors', unit: 'px', isLog: true, series: [
      ...(areOne ? [errorSeries('model and truncation', 'blue', 'truncation')] : [errorSeries('model', 'orange', 'model'), errorSeries('truncation', 'blue', 'truncation')]),
      errorSeries('implementation', 'green', 'implementation')] }, ...driftCharts(result));
  }
  return [...overview(result), ...distanceChart(result), ...charts];
}

// Of a run of very many rows the whole: the largest speed and the contacts of each of some hundred parts. A range of it
// is what the other charts show.
function overview({ rows, contacts: met }) {
  const count = rows.step.length, stride = Math.ceil(count / 400);
  if (count < overviewRowsMin) return [];
  const steps = [], speeds = [], contacts = [];
  let at = 0;
  for (let from = 0; from < count; from += stride) {
    const to = Math.min(count, from + stride);
    const first = at;
    let most = 0;
    for (let i = from; i < to; ++i) most = Math.max(most, Math.hypot(rows.vx[i], rows.vy[i]));
    while (at < (met?.step.length ?? 0) && met.step[at] <= rows.step[to - 1]) ++at;
    steps.push(rows.step[from]);
    speeds.push(most);
    contacts.push((at - first) / (rows.t[to - 1] - rows.t[from] || 1));
  }
  const chart = (id, title, unit, name, tint, values) => ({ id, title, unit, decimals: 1, isOverview: true, range: fromZero, series: [
    { name, color: tint, values: joined(rows, steps, values), known: { steps, values, isJoined: true } }] });
  return [chart('overview-speed', 'Whole run: largest speed', 'px/s', 'speed', 'blue', speeds),
    chart('overview-contacts', 'Whole run: contacts', '1/s', 'contacts', 'vermilion', contacts)];
}

// How far apart two runs are, of which the other has its distance for each row.
function distanceChart({ other }) {
  if (!other) return [];
  return [{ id: 'distance', title: `Distance from the ${other.name}`, unit: 'px', isLog: true, series: [
    { name: 'distance', color: 'vermilion', values: other.distances.map(px => (px > 0 ? px : null)) }] }];
}

/** Of each row its distance from the row of the same step of another run; null where that has none. */
export function distancesFrom(other, rows) {
  const [x, y] = [other.x, other.y].map(values => spread(rows, other.step, values));
  return x.map((at, i) => (at === null ? null : Math.hypot(at - rows.x[i], y[i] - rows.y[i])));
}

function driftCharts({ rows, causes, contactErrors: contacts }) {
  const cause = (name, tint, key) => ({ name, color: tint, dash: key === 'sum', values: joined(rows, causes.step, causes[key]), known: { steps: causes.step, values: causes[key], isJoined: true } });
  const charts = [{ id: 'drift', title: 'Energy drift by cause', unit: 'px of height', decimals: 2, series: [
    cause('gravity', 'blue', 'gravity'), cause('drag', 'green', 'drag'), cause('lift', 'vermilion', 'lift'), cause('late bounce', 'purple', 'bounce'), cause('all', 'ink', 'sum')] }];
  if (contacts.step.length === 0) return charts;
  const point = (name, tint, key, scale) => {
    const values = contacts[key].map(value => value * scale);
    return { name, color: tint, points: true, values: spread(rows, contacts.step, values, Number.isFinite), known: { steps: contacts.step, values } };
  };
  return [...charts,
    { id: 'contact-time', title: 'Contact time error', unit: 'ms', decimals: 3, range: aroundZero, series: [point('late by', 'vermilion', 'time_error', 1000)] },
    { id: 'contact-restitution', title: 'Effective restitution', unit: '', decimals: 4, range: padded, series: [point('speed after / before', 'purple', 'effective_restitution', 1)] }];
}

const exponent = value => String(value).replace(/\d/g, digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]).replace('-', '⁻');

// Whole decades, of which few are labelled.
function logAxis() {
  return {
    range: (_, low, high) => {
      const from = Math.floor(Math.log10(low > 0 ? low : 1e-12)), to = Math.ceil(Math.log10(high > 0 ? high : 1));
      return [10 ** from, 10 ** Math.max(to, from + 1)];
    },
    splits: (plot, _, low, high) => {
      const from = Math.round(Math.log10(low)), to = Math.round(Math.log10(high));
      const stride = Math.max(1, Math.ceil((to - from) / 4));
      return Array.from({ length: Math.floor((to - from) / stride) + 1 }, (_, i) => 10 ** (from + i * stride));
    },
    values: (_, splits) => splits.map(value => `10${exponent(Math.round(Math.log10(value)))}`),
  };
}

const aroundZero = (_, low, high) => [Math.min(0, 1.2 * (low ?? 0)), Math.max(0, 1.2 * (high ?? 0)) || 1];
const padded = (_, low, high) => (low === null || low === undefined ? [0, 1] : [low - 0.15 * (high - low || 0.1), high + 0.15 * (high - low || 0.1)]);
const fromZero = (_, low, high) => [Math.min(0, low ?? 0), high > 0 ? 1.15 * high : 1];

const thousands = value => (Math.abs(value) >= 1e5 ? `${rounded(value / 1e6, 3)} M` : value.toLocaleString('en').replace('-', '−'));

// Smallest and largest value that is known.
function rangeOf({ values }) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (value === null || value === undefined) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low > high ? [null, null] : [low, high];
}

function rangeText(series, unit) {
  const [low, high] = rangeOf(series);
  return low === null ? 'no value' : `${rounded(low)} to ${rounded(high)} ${unit}`.trim();
}

export class Charts {
  #plots = [];
  #isZooming = false;

  constructor(result, sizes, moment, seek) {
    Object.assign(this, { result, sizes, moment, seek });
    this.#build(chartsOf(result, sizes));
    this.zoomToMotion();
    moment.listen(() => this.show());
  }

  /** The result of a run that goes on. */
  update(result) {
    this.result = result;
    const charts = chartsOf(result, this.sizes);
    if (charts.length !== this.#plots.length || charts.some(({ id }, i) => id !== this.#plots[i].chart.id)) this.#build(charts);
    this.#isZooming = true;
    charts.forEach((chart, i) => {
      this.#plots[i].chart = chart;
      this.#plots[i].plot.setData([result.rows.t, ...chart.series.map(({ values }) => this.#drawn(values))]);
    });
    this.zoom(null);
  }

  #build(charts) {
    const isBeside = chart => chart.isOverview || ['distance', 'position', 'velocity', 'energy', 'errors'].includes(chart.id);
    for (const id of ['charts', 'more-charts']) element(id).replaceChildren();
    this.#plots = charts.map((chart, i) => this.#draw(chart, element(isBeside(chart) ? 'charts' : 'more-charts'),
      chart.isOverview || !isBeside(chart) || !isBeside(charts[i + 1])));
    this.#showTable(charts);
  }

  #draw(chart, place, isLast) {
    const { rows } = this.result;
    const legend = chart.series.map(series => make('span', { class: 'key' }, make('i', { class: `swatch ${series.dash ? 'dashed' : ''} tint-${series.color}` }),
      `${series.name} `, make('output', {}, '')));
    const figure = make('figure', { class: 'chart', id: `chart-${chart.id}` },
      make('figcaption', {}, make('span', { class: 'chart-title' }, chart.title, make('span', { class: 'quiet' }, chart.unit ? `, ${chart.unit}` : '')), make('span', { class: 'keys' }, ...legend),
        make('button', { type: 'button', class: 'link', 'aria-label': `Save ${chart.title} as CSV`, onclick: () => this.#saveCsv(chart.id) }, 'CSV')));
    place.append(figure);
    const plot = new uPlot(this.#options(chart, figure, isLast), [rows.t, ...chart.series.map(({ values }) => this.#drawn(values))], figure);
    const playhead = make('div', { class: 'playhead' });
    plot.over.append(playhead);
    const { divergence } = this.result;
    const marker = divergence === undefined || divergence === null ? null : make('div', { class: 'divergence', title: `first difference at step ${divergence}` });
    if (marker) plot.over.append(marker);
    plot.root.setAttribute('role', 'img');
    plot.root.setAttribute('aria-label', `${chart.title} over time. ${chart.series.map(series => `${series.name}: ${rangeText(series, chart.unit)}`).join('; ')}.`);
    this.#listen(plot);
    return { plot, chart, playhead, marker, outputs: legend.map(key => key.querySelector('output')), figure };
  }

  // Of a run that becomes non-finite without that value, which has no place on an axis.
  #drawn(values) {
    return this.result.run.non_finite ? Array.from(values, value => (Number.isNaN(value) || Math.abs(value) === Infinity ? null : value)) : values;
  }

  #options(chart, figure, isLast) {
    const log = chart.isLog ? logAxis() : null;
    const axis = { stroke: () => color('quiet'), font: '11px system-ui, sans-serif', ticks: { show: false },
      grid: { stroke: () => color('rule'), width: 1 } };
    return {
      width: figure.clientWidth || 300,
      height: isLast ? 132 : 108,
      padding: [8, 14, isLast ? 0 : 6, 0],
      legend: { show: false },
      cursor: { y: false, points: { show: false }, drag: { x: true, y: false, dist: 6, setScale: !chart.isOverview }, ...(chart.isOverview ? {} : { sync: { key: 'run', setSeries: false } }) },
      scales: { x: { time: false }, y: chart.isLog ? { distr: 3, log: 10, range: log.range } : chart.range ? { range: chart.range } : {} },
      axes: [
        { ...axis, show: isLast, size: 28, values: (_, splits) => splits.map(value => `${grouped(value, 6)} s`) },
        { ...axis, size: 64, gap: 6, space: 26, ...(log ? { splits: log.splits, values: log.values, filter: (_, splits) => splits } : { values: (_, splits) => splits.map(thousands) }) },
      ],
      series: [{}, ...chart.series.map(series => ({ label: series.name, stroke: () => color(series.color), width: series.width ?? 1.5, pxAlign: 0, spanGaps: series.known?.isJoined === true,
        dash: series.dash ? [5, 4] : undefined, points: series.points ? { show: true, size: 7, fill: () => color(series.color), width: 0 } : { show: false },
        paths: series.points ? () => null : series.steps ? uPlot.paths.stepped({ align: -1 }) : undefined }))],
      hooks: chart.isOverview ? { setSelect: [({ select: { left, width }, posToVal }) => width > 0 && this.zoom([posToVal(left, 'x'), posToVal(left + width, 'x')])] } :
        { setScale: [(plot, scale) => scale === 'x' && this.#zoomed(plot)], draw: chart.id === 'distance' ? [plot => this.#markContacts(plot)] : [] },
    };
  }

  // On the time axis, in the colours of the walls.
  #markContacts({ ctx, bbox, valToPos }) {
    const { contacts, rows } = this.result;
    for (let i = 0; i < Math.min(contacts?.step.length ?? 0, 500); ++i) {
      const at = valToPos(rows.t[firstAtLeast(rows.step, contacts.step[i])], 'x', true);
      if (!(at >= bbox.left && at <= bbox.left + bbox.width)) continue;
      ctx.fillStyle = color(wallColors[contacts.wall[i]]);
      ctx.fillRect(at - devicePixelRatio, bbox.top + bbox.height - 8 * devicePixelRatio, 2 * devicePixelRatio, 8 * devicePixelRatio);
    }
  }

  // A mouse that rests shows its row; a finger scrubs.
  #listen(plot) {
    const over = plot.over;
    const seek = event => {
      const t = plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x');
      this.seek(Math.max(0, lastAtMost(this.result.rows.t, t)));
    };
    over.addEventListener('pointermove', event => {
      if (event.pointerType === 'mouse' ? event.buttons === 0 && this.followsMouse() : event.isPrimary) seek(event);
    });
    over.addEventListener('pointerdown', event => event.pointerType !== 'mouse' && seek(event));
    over.addEventListener('click', seek);
    over.addEventListener('dblclick', () => this.zoom(null));
  }

  /** Set by the page: whether the mouse moves the moment, which it does not while playing. */
  followsMouse = () => true;

  #zoomed(source) {
    if (this.#isZooming) return;
    this.#isZooming = true;
    const { min, max } = source.scales.x;
    this.#setRange(min, max, source);
  }

  /** [from, to] in s; null: the whole run. */
  zoom(range) {
    const t = this.result.rows.t;
    const [min, max] = range ?? [t[0], t[t.length - 1] || 1];
    this.#isZooming = true;
    this.#setRange(min, max);
  }
  #setRange(min, max, source = null) {
    for (const { plot, chart } of this.#plots) {
      if (!chart.isOverview) plot !== source && plot.setScale('x', { min, max });
      else {
        const left = plot.valToPos(min, 'x');
        plot.setSelect({ left, width: plot.valToPos(max, 'x') - left, top: 0, height: plot.over.clientHeight }, false);
      }
    }
    this.#isZooming = false;
    this.show();
  }
  // A run that has long settled opens on the part that moves.
  zoomToMotion() {
    const { rows, run } = this.result;
    const end = rows.t[rows.t.length - 1];
    if (rows.step.length >= overviewRowsMin && end > 10) return this.zoom([0, 10]);
    const since = run.result.at_rest_since_s;
    this.zoom(since !== null && since > 0 && since < 0.7 * end ? [0, since * 1.08] : null);
  }

  show() {
    const { index, t } = this.moment;
    for (const { plot, chart, playhead, marker, outputs } of this.#plots) {
      const place = (mark, time) => {
        const left = plot.valToPos(time, 'x');
        mark.hidden = !(left >= -1 && left <= plot.over.clientWidth + 1);
        mark.style.transform = `translateX(${left}px)`;
      };
      place(playhead, t);
      if (marker) place(marker, this.result.rows.t[firstAtLeast(this.result.rows.step, this.result.divergence)] ?? NaN);
      chart.series.forEach((series, i) => {
        const value = this.#valueAt(series, index);
        outputs[i].textContent = value === null || Number.isNaN(value) ? '–' : chart.decimals === undefined ? rounded(value, 4) : fixed(value, chart.decimals);
      });
    }
  }

  // Of contacts the last one up to the moment, of causes the place on the line that is drawn.
  #valueAt({ values, known }, index) {
    if (!known) return values[index];
    const step = this.result.rows.step[index], at = lastAtMost(known.steps, step);
    if (!known.isJoined || !(at + 1 < known.steps.length)) return known.values[at] ?? null;
    const { rows } = this.result;
    const time = i => rows.t[Math.min(firstAtLeast(rows.step, known.steps[i]), rows.t.length - 1)];
    const part = time(at + 1) > time(at) ? (rows.t[index] - time(at)) / (time(at + 1) - time(at)) : 1;
    return known.values[at] + part * (known.values[at + 1] - known.values[at]);
  }

  // What the pictures say, as numbers.
  #showTable(charts) {
    const series = charts.flatMap(chart => chart.series.map(each => ({ chart, each, range: rangeOf(each) })));
    const column = (name, get) => ({ name, values: series.map(get) });
    const table = element('charts-table');
    table.replaceChildren(table.firstElementChild, tableOf({ name: 'charts', long_name: 'The charts as a table', row_count: series.length, columns: [
      column('chart', ({ chart }) => chart.title), column('series', ({ each }) => each.name), column('unit', ({ chart }) => chart.unit),
      column('smallest', ({ range }) => range[0]), column('largest', ({ range }) => range[1]),
      column('at the end', ({ each }) => this.#valueAt(each, this.result.rows.step.length - 1) ?? null)] }));
  }

  fit() {
    for (const { plot, figure } of this.#plots) plot.setSize({ width: figure.clientWidth, height: plot.height });
    this.show();
  }
  repaint() {
    for (const { plot } of this.#plots) plot.redraw(false);
  }

  #saveCsv(id) {
    const { chart } = this.#plots.find(each => each.chart.id === id);
    const { rows, run } = this.result;
    const lines = [['step', 't_s', ...chart.series.map(series => chart.unit ? `${series.name} (${chart.unit})` : series.name)].map(head => `"${head.replaceAll('"', '""')}"`).join(',')];
    for (let i = 0; i < rows.step.length; ++i)
      lines.push([rows.step[i], exact(rows.t[i]), ...chart.series.map(({ values }) => ((values[i] ?? null) === null || Number.isNaN(values[i]) ? '' : exact(values[i])))].join(','));
    save(`${run.name}-${chart.id}.csv`, 'text/csv', `${lines.join('\n')}\n`);
  }
}
