// Charts over the time of a run, with one cursor and one zoom.
import uPlot from 'uplot';
import { firstAtLeast, lastAtMost } from './data.js';
import { element, make, save } from './document.js';
import { fixed, grouped, rounded } from './numbers.js';
import { color, paintWall } from './painter.js';
import { chartsOf, csvOf, envelopeOf, logAxis, overviewRowsMin, rangeOfSeries, rangeText, thousands, valueAt } from './series.js';

const rowsOfAPixel = 4; // Of more, a curve is the area between its smallest and its largest values.

// As uPlot wants a path: a curve, or its envelope where rows are dense.
function curve(plot, at, first, last, series) {
  const [times] = plot.data, values = plot.data[at], { left, width } = plot.bbox, { min, max } = plot.scales.x;
  if (last - first < rowsOfAPixel * width) return { ...(series.steps ? uPlot.paths.stepped({ align: -1 }) : uPlot.paths.linear())(plot, at, first, last), fill: null };
  const parts = envelopeOf(times, values, first, last, min, max, width).map(({ column, low, high }) => [left + column, plot.valToPos(high, 'y', true), plot.valToPos(low, 'y', true)]);
  const fill = new Path2D(), stroke = new Path2D();
  for (const [x, top, foot] of parts) fill.rect(x, top, 1, foot - top);
  for (const edge of [1, 2]) parts.forEach((part, i) => stroke[i && part[0] - parts[i - 1][0] < 2 ? 'lineTo' : 'moveTo'](part[0], part[edge]));
  return { stroke, fill, clip: null, band: null, gaps: null, flags: 1 };
}

export class Charts {
  #plots = [];
  #isZooming = false;
  #first = null; // What of the time charts show when they are drawn first.

  constructor(result, sizes, moment, seek) {
    Object.assign(this, { result, sizes, moment, seek });
  }
  /** Draws them, one a step. */
  *draw() {
    this.#first = this.#motion();
    yield* this.#build(chartsOf(this.result, this.sizes));
    this.zoom(this.#first);
    this.#first = null;
    this.moment.listen(() => this.show());
  }

  /** The result of a run that goes on, or of a changed one: then what is seen of the time stays. */
  update(result, sizes = this.sizes) {
    const { min, max } = this.#plots[0].plot.scales.x, isWhole = !result.isWhatIf;
    Object.assign(this, { result, sizes });
    const charts = chartsOf(result, sizes), kindOf = ({ id, series }) => `${id} ${series.map(({ name }) => name)}`;
    if (charts.length !== this.#plots.length || charts.some((chart, i) => kindOf(chart) !== kindOf(this.#plots[i].chart))) [...this.#build(charts)];
    this.#isZooming = true;
    charts.forEach((chart, i) => {
      this.#plots[i].chart = chart;
      this.#plots[i].plot.setData([(chart.rows ?? result.rows).t, ...chart.series.map(({ values }) => this.#drawn(values))]);
    });
    this.zoom(isWhole ? null : [min, max]);
  }

  *#build(charts) {
    const isBeside = chart => chart.isOverview || ['distance', 'position', 'velocity', 'energy', 'errors'].includes(chart.id);
    for (const id of ['charts', 'more-charts']) element(id).replaceChildren();
    this.#plots = [];
    for (const [i, chart] of charts.entries()) {
      this.#plots.push(this.#draw(chart, element(isBeside(chart) ? 'charts' : 'more-charts'), chart.isOverview || !isBeside(chart) || !isBeside(charts[i + 1])));
      yield;
    }
    this.#showTable(charts);
  }

  #draw(chart, place, isLast) {
    const { t } = chart.rows ?? this.result.rows;
    const legend = chart.series.map(series => make('span', { class: 'key' }, make('i', { class: `swatch ${series.dash ? 'dashed' : ''} tint-${series.color}` }),
      `${series.name} `, make('output', {}, '')));
    const figure = make('figure', { class: 'chart', id: `chart-${chart.id}` },
      make('figcaption', {}, make('span', { class: 'chart-title' }, chart.title, make('span', { class: 'quiet' }, chart.unit ? `, ${chart.unit}` : '')), make('span', { class: 'keys' }, ...legend),
        make('button', { type: 'button', class: 'link', 'aria-label': `Save ${chart.title} as CSV`, onclick: () => this.#saveCsv(chart.id) }, 'CSV')));
    place.append(figure);
    const plot = new uPlot(this.#options(chart, figure, isLast), [t, ...chart.series.map(({ values }) => this.#drawn(values))], figure);
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
      scales: { x: { time: false, range: (_, low, high) => (!chart.isOverview && this.#first) || [low, high] }, y: chart.isLog ? { distr: 3, log: 10, range: log.range } : chart.range ? { range: chart.range } : {} },
      axes: [
        { ...axis, show: isLast, size: 28, values: (_, splits) => splits.map(value => `${grouped(value, 6)} s`) },
        { ...axis, size: 64, gap: 6, space: 26, ...(log ? { splits: log.splits, values: log.values, filter: (_, splits) => splits } : { values: (_, splits) => splits.map(thousands) }) },
      ],
      series: [{}, ...chart.series.map(series => ({ label: series.name, stroke: () => color(series.color), fill: () => `color-mix(in srgb, ${color(series.color)} 35%, transparent)`, width: 1.5, pxAlign: 0, spanGaps: series.known?.isJoined === true,
        dash: series.dash ? [5, 4] : undefined, points: series.points ? { show: true, size: 7, fill: () => color(series.color), width: 0 } : { show: false },
        paths: series.points ? () => null : (plot, at, first, last) => curve(plot, at, first, last, series) }))],
      hooks: chart.isOverview ? { setSelect: [({ select: { left, width }, posToVal }) => width > 0 && this.zoom([posToVal(left, 'x'), posToVal(left + width, 'x')])] } :
        { setScale: [(plot, scale) => scale === 'x' && this.#zoomed(plot)], draw: chart.id === 'distance' ? [plot => this.#markContacts(plot)] : [] },
    };
  }

  // On the time axis, by their walls.
  #markContacts({ ctx, bbox, valToPos }) {
    const { contacts, rows } = this.result;
    for (let i = 0; i < Math.min(contacts?.step.length ?? 0, 500); ++i) {
      const at = valToPos(rows.t[firstAtLeast(rows.step, contacts.step[i])], 'x', true);
      if (!(at >= bbox.left && at <= bbox.left + bbox.width)) continue;
      paintWall(ctx, contacts.wall[i], at, bbox.top + bbox.height - 5 * devicePixelRatio, 4 * devicePixelRatio);
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
  #motion() {
    const { rows, run } = this.result;
    const end = rows.t[rows.t.length - 1];
    if (rows.step.length >= overviewRowsMin && end > 10) return [0, 10];
    const since = run.result.at_rest_since_s;
    return since !== null && since > 0 && since < 0.7 * end ? [0, since * 1.08] : null;
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
        const value = valueAt(this.result.rows, series, index);
        outputs[i].textContent = value === null || Number.isNaN(value) ? '–' : chart.decimals === undefined ? rounded(value, 4) : fixed(value, chart.decimals);
      });
    }
  }

  // What the pictures say, as numbers.
  #showTable(charts) {
    const heads = ['chart', 'series', 'unit', 'smallest', 'largest', 'at the end'];
    const lines = charts.flatMap(({ title, unit, series }) => series.map(each => [title, each.name, unit,
      ...[...rangeOfSeries(each), valueAt(this.result.rows, each, this.result.rows.step.length - 1)].map(value => rounded(value, 6))]));
    const row = (tag, texts) => make('tr', {}, ...texts.map((text, i) => make(tag, { class: i < 3 ? 'text' : 'number' }, text)));
    const table = element('charts-table');
    table.replaceChildren(table.firstElementChild, make('div', { class: 'table', tabindex: '0', role: 'group', 'aria-label': 'The charts as a table' },
      make('table', {}, make('thead', {}, row('th', heads)), make('tbody', {}, ...lines.map(line => row('td', line))))));
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
    save(`${run.name}-${chart.id}.csv`, 'text/csv', csvOf(chart, chart.rows ?? rows));
  }
}
