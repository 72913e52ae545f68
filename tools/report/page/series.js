// What the charts of a run show: series, axes and their numbers, as plain values.
import { firstAtLeast, lastAtMost, rangeOf } from './data.js';
import { exact, grouped, rounded } from './numbers.js';
import { sizesAt } from './replay.js';

export const overviewRowsMin = 50_000;
const gravityOf = run => run.constants[0];

// Specific energy, zero at rest on the floor: (vx^2 + vy^2) / 2 + g (bottom - y).
function energyOf({ run, rows }, sizes) {
  return rows.x.map((_, i) => {
    const { window, sprite } = sizesAt(sizes, rows.step[i]);
    return (rows.vx[i] ** 2 + rows.vy[i] ** 2) / 2 + gravityOf(run) * (window[1] - sprite[1] - rows.y[i]);
  });
}

// A series whose values are made when they are first asked for: of many rows that takes long.
function lazy(series, make) {
  const get = () => {
    const value = make();
    Object.defineProperty(series, 'values', { value });
    return value;
  };
  return Object.defineProperty(series, 'values', { get, enumerable: true, configurable: true });
}

// Values that only some rows have, in order of steps, as a list over all rows: null draws a gap, undefined a line that
// goes straight on, for a series with `known.isJoined`.
function spread(rows, steps, values, absent, isShown = () => true) {
  const list = new Array(rows.step.length).fill(absent);
  let row = 0;
  for (let i = 0; i < steps.length; ++i) {
    while (row < list.length && rows.step[row] < steps[i]) ++row;
    if (row < list.length && rows.step[row] === steps[i] && isShown(values[i])) list[row] = values[i];
  }
  return list;
}
const joined = (rows, steps, values) => spread(rows, steps, values, undefined);

/** What the charts show: title, unit, series, and rows if they have their own. A series is {name, color, values, dash, points, steps}; of one
// with `known` only these rows have a value; between those of one that is joined it changes evenly. `found` has the zeros, too, that a logarithmic
// axis leaves out of `values`. */
export function chartsOf(result, sizes) {
  const { rows, errors, other } = result;
  const overlay = (name, tint, values) => (other ? [{ name, color: tint, dash: true, values: spread(rows, other.rows.step, values, null) }] : []);
  const positive = value => value > 0;
  const errorSeries = (name, tint, key) => ({ name, color: tint, values: spread(rows, errors.step, errors[key], null, positive), found: spread(rows, errors.step, errors[key], null) });
  const label = other?.label;
  const charts = [
    { id: 'position', title: 'Position', unit: 'px', decimals: 1, series: [
      { name: 'x', color: 'blue', values: rows.x }, { name: 'y', color: 'orange', values: rows.y },
      ...overlay(`x, ${label}`, 'blue', other?.rows.x), ...overlay(`y, ${label}`, 'orange', other?.rows.y)] },
    { id: 'velocity', title: 'Velocity', unit: 'px/s', decimals: 1, series: [
      { name: 'vx', color: 'blue', values: rows.vx }, { name: 'vy', color: 'orange', values: rows.vy },
      ...overlay(`vx, ${label}`, 'blue', other?.rows.vx), ...overlay(`vy, ${label}`, 'orange', other?.rows.vy)] },
    ...(result.run.constants ? [{ id: 'energy', title: 'Energy', unit: 'px²/s²', decimals: 0, series: [lazy({ name: 'run', color: 'green' }, () => energyOf(result, sizes))] }] : []),
    { id: 'dt', title: 'Frame time', unit: 'ms', decimals: 3, range: fromZero, series: [
      lazy({ name: 'dt', color: 'blue', steps: true }, () => Array.from(rows.dt, (dt, i) => (rows.step[i] === 0 ? null : 1000 * dt)))] },
  ];
  if (errors?.step.length) {
    // With the drag of 60 Hz both are the same.
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
  const steps = [], times = [], speeds = [], contacts = [];
  let at = 0;
  for (let from = 0; from < count; from += stride) {
    const to = Math.min(count, from + stride);
    const first = at;
    let most = 0;
    for (let i = from; i < to; ++i) most = Math.max(most, rows.vx[i] ** 2 + rows.vy[i] ** 2);
    while (at < (met?.step.length ?? 0) && met.step[at] <= rows.step[to - 1]) ++at;
    steps.push(rows.step[from]);
    times.push(rows.t[from]);
    speeds.push(Math.sqrt(most));
    contacts.push((at - first) / (rows.t[to - 1] - rows.t[Math.max(0, from - 1)] || 1));
  }
  const chart = (id, title, unit, name, tint, values) => ({ id, title, unit, decimals: 1, isOverview: true, range: fromZero, rows: { step: [...steps, rows.step[count - 1]], t: [...times, rows.t[count - 1]] }, series: [
    { name, color: tint, values: [...values, values.at(-1)], known: { steps, values, isJoined: true } }] });
  return [chart('overview-speed', 'Whole run: largest speed', 'px/s', 'speed', 'blue', speeds),
    chart('overview-contacts', 'Whole run: contacts', '1/s', 'contacts', 'vermilion', contacts)];
}

// How far apart two runs are, of which the other has its distance for each row.
function distanceChart({ other }) {
  if (!other) return [];
  return [{ id: 'distance', title: `Distance from the ${other.name}`, unit: 'px', isLog: true, series: [
    { name: 'distance', color: 'vermilion', values: other.distances.map(px => (px > 0 ? px : null)), found: other.distances }] }];
}

/** A run of another clock at the times of these rows, with their steps, to the end of the shorter run: between two rows
 * on the straight line between them, as in `diff`. */
export function shownAt({ step, t }, other) {
  const last = other.t.length - 1, count = lastAtMost(t, other.t[last]) + 1;
  const shown = { step: step.slice(0, count), t: t.slice(0, count), x: [], y: [], vx: [], vy: [] };
  for (const at of shown.t) {
    const row = lastAtMost(other.t, at), next = Math.min(row + 1, last);
    const part = next > row ? (at - other.t[row]) / (other.t[next] - other.t[row]) : 0;
    for (const name of ['x', 'y', 'vx', 'vy']) shown[name].push(other[name][row] + part * (other[name][next] - other[name][row]));
  }
  return shown;
}

/** Of each row its distance from the row of the same step of another run; null where that has none. */
export function distancesFrom(other, rows) {
  const [x, y] = [other.x, other.y].map(values => spread(rows, other.step, values, null));
  return x.map((at, i) => (at === null ? null : Math.hypot(at - rows.x[i], y[i] - rows.y[i])));
}

function driftCharts({ rows, causes, contactErrors: contacts }) {
  const cause = (name, tint, key) => ({ name, color: tint, dash: key === 'sum', values: joined(rows, causes.step, causes[key]), known: { steps: causes.step, values: causes[key], isJoined: true } });
  const charts = [{ id: 'drift', title: 'Energy drift by cause', unit: 'px of height', decimals: 2, series: [
    cause('gravity', 'blue', 'gravity'), cause('drag', 'green', 'drag'), cause('lift', 'vermilion', 'lift'), cause('late bounce', 'purple', 'bounce'), cause('all', 'ink', 'sum')] }];
  if (contacts.step.length === 0) return charts;
  const point = (name, tint, key, scale) => {
    const values = contacts[key].map(value => value * scale);
    return { name, color: tint, points: true, values: spread(rows, contacts.step, values, null, Number.isFinite), known: { steps: contacts.step, values } };
  };
  return [...charts,
    { id: 'contact-time', title: 'Contact time error', unit: 'ms', decimals: 3, range: aroundZero, series: [point('late by', 'vermilion', 'time_error', 1000)] },
    { id: 'contact-restitution', title: 'Effective restitution', unit: '', decimals: 4, range: padded, series: [point('speed after / at the true impact', 'purple', 'effective_restitution', 1)] }];
}

/** Of values at rising times, with `columns` parts of a span of time: the smallest and the largest of each part that has any, as {column, low, high}. */
export function envelopeOf(times, values, first, last, from, to, columns) {
  const parts = [], scale = columns / (to - from);
  for (let i = first; i <= last; ++i) {
    const value = values[i], column = Math.min(Math.max(Math.floor((times[i] - from) * scale), 0), columns - 1);
    if (value === null || value === undefined || Number.isNaN(value)) continue;
    const part = parts.at(-1);
    if (part?.column !== column) parts.push({ column, low: value, high: value });
    else if (value < part.low) part.low = value;
    else if (value > part.high) part.high = value;
  }
  return parts;
}

const exponent = value => String(value).replace(/\d/g, digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]).replace('-', '⁻');

/** Whole decades, of which few are labelled. */
export function logAxis() {
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

export const thousands = value => (Math.abs(value) >= 1e5 ? `${rounded(value / 1e6, 3)} M` : grouped(value, 3));

const ranges = new WeakMap();
/** The smallest and the largest value of a series, found once. */
export function rangeOfSeries(series) {
  if (!ranges.has(series)) ranges.set(series, rangeOf(series.values));
  return ranges.get(series);
}

export function rangeText(series, unit) {
  const [low, high] = rangeOfSeries(series);
  return low === null ? 'no value' : `${rounded(low)} to ${rounded(high)} ${unit}`.trim();
}

/** A series at a row: of contacts the last one up to it, of causes the place on the line that is drawn. */
export function valueAt(rows, { values, found = values, known }, index) {
  if (!known) return found[index];
  const at = lastAtMost(known.steps, rows.step[index]);
  if (!known.isJoined || !(at + 1 < known.steps.length)) return known.values[at] ?? null;
  const time = i => rows.t[Math.min(firstAtLeast(rows.step, known.steps[i]), rows.t.length - 1)];
  const part = time(at + 1) > time(at) ? (rows.t[index] - time(at)) / (time(at + 1) - time(at)) : 1;
  return known.values[at] + part * (known.values[at + 1] - known.values[at]);
}

/** A chart's series, one line a row; empty where one has no value. */
export function csvOf({ unit, series }, rows) {
  const heads = ['step', 't_s', ...series.map(({ name }) => (unit ? `${name} (${unit})` : name))];
  const lines = [heads.map(head => `"${head.replaceAll('"', '""')}"`).join(',')];
  for (let i = 0; i < rows.step.length; ++i)
    lines.push([rows.step[i], exact(rows.t[i]), ...series.map(({ values, found = values }) => ((found[i] ?? null) === null || Number.isNaN(found[i]) ? '' : exact(found[i])))].join(','));
  return `${lines.join('\n')}\n`;
}
