// Draws any Figure of sim/result: plots by Observable Plot; grids and lists of texts as tables.
import * as Plot from '@observablehq/plot';
import { make } from './data.js';
import { rounded } from './numbers.js';

const svgSpace = 'http://www.w3.org/2000/svg';
const tone = name => `var(--${name.replaceAll('_', '-')})`;
const dashes = { solid: null, short_dashes: 'var(--short-dashes)', long_dashes: 'var(--long-dashes)', dots: 'var(--dots)' };
const finite = value => typeof value === 'number' && Number.isFinite(value);

// Points of a series that can be drawn on these axes; `zero_at` holds what is at most that large.
function pointsOf(series, plot) {
  const at = (axis, value) => (axis.is_logarithmic && finite(axis.zero_at) && finite(value) ? Math.max(value, axis.zero_at) : value);
  const seen = (axis, value) => finite(value) && (!axis.is_logarithmic || value > 0);
  return series.x.map((x, i) => ({ series, i, x: at(plot.x, x), y: at(plot.y, series.y[i]), y_low: series.y_low[i], x_low: series.x_low[i], x_high: series.x_high[i] }))
    .map(point => (seen(plot.x, point.x) && seen(plot.y, point.y) ? point : { ...point, y: NaN }));
}

const power = value => String(value).replace(/\d/g, digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]).replace('-', '⁻');

function axisText(axis, value) {
  if (axis.categories.length) return axis.categories[value] ?? '';
  const given = axis.ticks.find(each => each.at === value);
  if (given) return given.text;
  if (axis.is_logarithmic) {
    if (value === axis.zero_at) return axis.zero_text;
    const exponent = Math.log10(value);
    if (Math.abs(exponent - Math.round(exponent)) > 1e-9) return '';
    return exponent > -3.01 && exponent < 4.01 ? rounded(value) : `10${power(Math.round(exponent))}`;
  }
  if (value !== 0 && Math.abs(value) < 1e-3) return rounded(value, 2);
  return axis.decimals >= 0 ? value.toFixed(axis.decimals).replace('-', '−') : value.toLocaleString('en', { maximumSignificantDigits: 6 }).replace('-', '−');
}

function extent(plot, name) {
  const axis = plot[name];
  if (axis.categories.length) return [-0.5, axis.categories.length - 0.5];
  const values = plot.series.flatMap(series => pointsOf(series, plot)).filter(point => finite(point.y))
    .flatMap(point => (name === 'x' ? [point.x, point.x_low, point.x_high] : [point.y, point.y_low])).concat(plot.marks.filter(mark => mark.is_vertical === (name === 'x')).map(mark => mark.at))
    .filter(value => finite(value) && (!axis.is_logarithmic || value > 0));
  let low = Infinity, high = -Infinity;
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
  const isBars = name === 'x' && plot.series.some(series => series.look.form === 'bars');
  if (isBars && !axis.is_logarithmic) low = Math.min(low, 0);
  if (axis.is_logarithmic && finite(axis.zero_at)) low = Math.min(low, axis.zero_at);
  if (low > high) return [0, 1];
  const room = axis.is_logarithmic ? 0 : (high - low || Math.abs(high) || 1) * 0.04;
  const factor = axis.is_logarithmic ? (high / low || 1) ** 0.03 : 1;
  return [axis.low ?? (isBars && low === 0 ? 0 : (low - room) / factor), axis.high ?? (high + room) * factor];
}

function ticksOf(axis, [low, high], pixels) {
  if (axis.categories.length) return axis.categories.map((_, i) => i).filter(i => i >= low && i <= high);
  if (axis.ticks.length) return axis.ticks.map(each => each.at).filter(at => at >= low && at <= high);
  if (!axis.is_logarithmic) return undefined;
  const from = Math.ceil(Math.log10(low) - 1e-9), to = Math.floor(Math.log10(high) + 1e-9);
  if (to - from < 1) return undefined;
  const stride = Math.max(1, Math.ceil(((to - from + 1) * 42) / pixels));
  const list = Array.from({ length: Math.floor((to - from) / stride) + 1 }, (_, i) => 10 ** (from + i * stride)).filter(at => !finite(axis.zero_at) || at > axis.zero_at * 1.001);
  return finite(axis.zero_at) ? [axis.zero_at, ...list] : list;
}

// Where a value is on an axis of that length, in px.
function pixelAt(axis, [low, high], pixels, value) {
  const [from, to, at] = axis.is_logarithmic ? [low, high, value].map(Math.log) : [low, high, value];
  return (pixels * (at - from)) / (to - from || 1);
}

// Those of the texts {at, text} beside one another that have room.
function withRoom(texts, axis, domain, pixels) {
  let end = -Infinity;
  const places = texts.map(each => ({ each, half: each.text.length * 3.6 + 3, middle: pixelAt(axis, domain, pixels, each.at) }));
  return places.sort((a, b) => a.middle - b.middle).filter(({ half, middle }) => {
    if (middle - half < end) return false;
    end = middle + half;
    return true;
  }).map(({ each }) => each);
}

const scaleOf = (axis, domain, isY) => ({ type: axis.is_logarithmic ? 'log' : 'linear', domain, clamp: false, label: null,
  reverse: axis.is_reversed !== (isY && axis.categories.length > 0) });

// What a reader sees of one point: names and values with their units.
function tipText(point, plot) {
  const value = (axis, number) => (axis.categories.length ? (axis.categories[Math.round(number)] ?? '') : rounded(number, 5));
  const lines = [[point.series.name, point.series.point_names?.[point.i]].filter(Boolean).join(', '), `${plot.x.label || 'x'}: ${value(plot.x, point.series.x[point.i])}`, `${plot.y.label || 'y'}: ${value(plot.y, point.series.y[point.i])}`];
  if (finite(point.y_low)) lines.push(`from ${rounded(point.y_low, 5)}`);
  if (finite(point.x_low)) lines.push(`spread: ${rounded(point.x_low, 4)} .. ${rounded(point.x_high, 4)}`);
  return lines.filter(Boolean).join('\n');
}

function marksOfSeries(series, plot, domain) {
  const { look } = series;
  const points = pointsOf(series, plot);
  const color = tone(look.tone);
  const stroke = { stroke: color, strokeWidth: look.width * 0.72, strokeDasharray: dashes[look.dash], strokeLinejoin: 'round', strokeLinecap: 'round' };
  if (look.form === 'band')
    return [Plot.areaY(points, { x: 'x', y1: 'y_low', y2: 'y', fill: color, fillOpacity: ['hairline', 'shade', 'faint'].includes(look.tone) ? 0.9 : 0.35 })];
  if (look.form === 'bars')
    return [Plot.rect(points.filter(point => finite(point.y)), { x1: () => domain.x[0], x2: 'x', y1: point => point.y - 0.34, y2: point => point.y + 0.34, fill: color })];
  const marks = [];
  const radius = 1.2 + 4.2 * look.marker_size;
  if (series.x_low.length) marks.push(Plot.ruleY(points.filter(point => finite(point.y)), { x1: 'x_low', x2: 'x_high', y: 'y', stroke: color, strokeWidth: 1.2 }));
  if (look.form !== 'points') marks.push(Plot.line(points, { x: 'x', y: 'y', ...stroke }));
  if (look.form !== 'line') {
    const isRing = look.marker === 'ring';
    marks.push(Plot.dot(points.filter(point => finite(point.y)), { x: 'x', y: 'y', r: radius, symbol: look.marker === 'square' ? 'square' : 'circle',
      fill: isRing ? 'none' : color, fillOpacity: points.length > 400 ? 0.45 : 1, stroke: isRing ? color : 'none', strokeWidth: 1.6 }));
  }
  return marks;
}

// Texts keep off one another: each tries the sides of its point, and goes if there is no room (the tip still has it).
function placeTexts(svg, width, height) {
  const taken = [];
  const meets = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
  for (const text of svg.querySelectorAll('.beside text')) {
    const box = text.getBBox();
    const [, x, y] = /translate\(([-\d.e]+),([-\d.e]+)\)/.exec(text.getAttribute('transform') ?? '') ?? [];
    if (x === undefined) continue;
    const sides = [['start', 8, 0], ['end', -8, 0], ['middle', 0, -13], ['middle', 0, 13]];
    const free = sides.map(([anchor, dx, dy]) => {
      const left = Number(x) + dx - (anchor === 'start' ? 0 : anchor === 'end' ? box.width : box.width / 2);
      const top = Number(y) + dy - box.height / 2;
      return { anchor, dx, dy, left, top, right: left + box.width, bottom: top + box.height };
    }).find(place => place.left >= 0 && place.right <= width && place.top >= 0 && place.bottom <= height && !taken.some(other => meets(place, other)));
    if (!free) {
      text.remove();
      continue;
    }
    taken.push(free);
    text.setAttribute('text-anchor', free.anchor);
    text.setAttribute('transform', `translate(${Number(x) + free.dx},${Number(y) + free.dy})`);
  }
}

// Drag to zoom, double-click for all of it.
function listen(place, view, draw) {
  let from = null, brush = null;
  const at = event => {
    const box = view.svg.getBoundingClientRect();
    const ratio = view.width / box.width;
    return [(event.clientX - box.left) * ratio, (event.clientY - box.top) * ratio, box, ratio];
  };
  place.addEventListener('pointerdown', event => {
    if (event.pointerType !== 'mouse' || event.button !== 0 || event.target.closest('button')) return;
    from = at(event);
    event.preventDefault();
  });
  place.addEventListener('pointermove', event => {
    if (!from) return;
    const to = at(event), ratio = to[3];
    if (!brush && Math.hypot(to[0] - from[0], to[1] - from[1]) < 6) return;
    if (!brush) place.append((brush = make('div', { class: 'brush' })));
    Object.assign(brush.style, { left: `${Math.min(from[0], to[0]) / ratio}px`, top: `${Math.min(from[1], to[1]) / ratio}px`,
      width: `${Math.abs(to[0] - from[0]) / ratio}px`, height: `${Math.abs(to[1] - from[1]) / ratio}px` });
  });
  addEventListener('pointerup', event => {
    if (!from) return;
    const to = at(event);
    if (brush) {
      const range = (name, a, b) => [view.svg.scale(name).invert(Math.min(a, b)), view.svg.scale(name).invert(Math.max(a, b))].sort((p, q) => p - q);
      view.zoom = { x: range('x', from[0], to[0]), y: range('y', from[1], to[1]) };
      brush.remove();
      draw();
    }
    from = brush = null;
  });
  place.addEventListener('dblclick', () => {
    view.zoom = null;
    draw();
  });
}

function drawPlot(plot, place, view, label) {
  const all = { x: extent(plot, 'x'), y: extent(plot, 'y') };
  const domain = view.zoom ?? all;
  const width = Math.max(220, place.clientWidth);
  const labels = plot.y.categories.map(text => text.length * 6.6);
  const marginLeft = Math.min(width * 0.42, Math.max(52, 18 + Math.max(0, ...labels)));
  const isCategorical = plot.y.categories.length > 0;
  let height = isCategorical ? 74 + plot.y.categories.length * 26 : view.isBeside ? 310 : Math.min(420, Math.max(260, width * 0.52));
  if (plot.has_equal_scales) height = Math.min(600, Math.max(160, 70 + ((width - marginLeft - 16) * Math.abs(all.y[1] - all.y[0])) / (Math.abs(all.x[1] - all.x[0]) || 1)));
  const xTicks = ticksOf(plot.x, domain.x, width - marginLeft);
  const shownTicks = xTicks && new Set(withRoom(xTicks.map(at => ({ at, text: axisText(plot.x, at) })), plot.x, domain.x, width - marginLeft - 16).map(({ at }) => at));
  const isMarked = new Set(withRoom(plot.marks.filter(mark => mark.is_vertical && mark.text && finite(mark.at)), plot.x, domain.x, width - marginLeft - 16));
  const topDots = plot.top_dots.length > 0;
  const points = plot.series.flatMap(series => pointsOf(series, plot)).filter(point => finite(point.y));
  const marginTop = 32 + (topDots ? 10 : 0) + (plot.marks.some(mark => mark.is_vertical && mark.text) ? 12 : 0);
  const marks = [
    ...(plot.spans.length ? [Plot.rect(plot.spans, { x1: '0', x2: '1', y1: () => domain.y[0], y2: () => domain.y[1], fill: 'var(--rule)', fillOpacity: 0.5, clip: true })] : []),
    Plot.gridX({ ticks: xTicks ?? Math.max(2, Math.floor((width - marginLeft) / 70)), stroke: 'var(--rule)', strokeOpacity: 1 }),
    ...(isCategorical ? [] : [Plot.gridY({ ticks: ticksOf(plot.y, domain.y, height - 76), stroke: 'var(--rule)', strokeOpacity: 1 })]),
    Plot.axisX({ ticks: xTicks ?? Math.max(2, Math.floor((width - marginLeft) / 70)), text: value => (shownTicks && !shownTicks.has(value) ? '' : axisText(plot.x, value)), tickSize: 0, tickPadding: 8, fill: 'var(--quiet)', label: plot.x.label || null, labelArrow: 'none', labelAnchor: 'right' }),
    Plot.axisY({ ticks: ticksOf(plot.y, domain.y, height - 76), text: value => axisText(plot.y, value), tickSize: 0, tickPadding: 8, fill: 'var(--quiet)', label: plot.y.label || null, labelArrow: 'none', labelAnchor: 'top' }),
    ...plot.series.flatMap(series => marksOfSeries(series, plot, domain)).map(mark => Object.assign(mark, { clip: view.zoom ? 'frame' : mark.clip })),
    ...plot.marks.filter(mark => finite(mark.at)).flatMap(mark => [
      (mark.is_vertical ? Plot.ruleX : Plot.ruleY)([mark.at], { stroke: tone(mark.tone), strokeDasharray: '4 3', strokeWidth: 1.2, strokeOpacity: 0.75 }),
      ...(mark.text && (!mark.is_vertical || isMarked.has(mark)) ? [Plot.text([mark], { [mark.is_vertical ? 'x' : 'y']: 'at', frameAnchor: mark.is_vertical ? 'top' : 'right', text: 'text', fill: tone(mark.tone),
        dy: -5, lineAnchor: 'bottom', textAnchor: mark.is_vertical ? 'middle' : 'end', stroke: 'var(--card)', strokeWidth: 4 })] : [])]),
    ...(topDots ? [Plot.dot(plot.top_dots, { x: 'x', frameAnchor: 'top', dy: -8, r: 3, fill: dot => tone(dot.tone) })] : []),
    ...(plot.texts.length ? [Plot.text(plot.texts.filter(each => finite(each.x) && finite(each.y) && (!plot.x.is_logarithmic || each.x > 0) && (!plot.y.is_logarithmic || each.y > 0)),
      { x: 'x', y: 'y', text: 'text', fill: each => tone(each.tone), stroke: 'var(--card)', strokeWidth: 4, className: 'beside' })].map(mark => Object.assign(mark, { ariaLabel: 'beside' })) : []),
    Plot.tip(points, Plot.pointer({ x: 'x', y: 'y', title: point => tipText(point, plot), fill: 'var(--card)', stroke: 'var(--quiet)', textPadding: 10, lineHeight: 1.35, maxRadius: 30 })),
  ];
  const svg = Plot.plot({ width, height, marginLeft, marginRight: 16, marginTop, marginBottom: 46, style: { fontSize: '12.5px', color: 'var(--ink)' },
    x: scaleOf(plot.x, domain.x, false), y: scaleOf(plot.y, domain.y, true), color: { type: 'identity' }, marks, ariaLabel: label });
  svg.setAttribute('role', 'img');
  svg.querySelectorAll('[aria-label=beside]').forEach(group => group.setAttribute('class', 'beside'));
  svg.querySelectorAll('g[aria-label]').forEach(group => group.removeAttribute('aria-label')); // One name is enough for a picture.
  Object.assign(view, { svg, width });
  place.replaceChildren(svg, ...(view.zoom ? [make('button', { type: 'button', class: 'unzoom', onclick: () => view.reset() }, 'Show all')] : []));
  placeTexts(svg, width, height);
}

function plotOf(plot, figure, number, count) {
  const place = make('div', { class: 'plot' });
  place.style.flex = `${plot.share} 1 ${count > 1 ? '300px' : '100%'}`;
  if (!plot.series.some(series => series.x.length > 0)) {
    place.append(make('p', { class: 'empty' }, plot.when_empty));
    return place;
  }
  const label = `${figure.title}. ${figure.subtitle}. ${plot.y.label || 'y'} against ${plot.x.label || 'x'}${count > 1 ? `, ${number + 1} of ${count}` : ''}. Its data is below as a table.`;
  const view = { isBeside: count > 1, zoom: null, svg: null, width: 0, seen: 0, reset: () => ((view.zoom = null), draw()) };
  const draw = () => drawPlot(plot, place, view, label);
  listen(place, view, draw);
  new ResizeObserver(() => {
    if (place.clientWidth === view.seen || place.clientWidth === 0) return;
    view.seen = place.clientWidth;
    draw();
  }).observe(place);
  return place;
}

// Of a grid, whose cells are fills, so are the keys.
function legendOf(entries, isFills) {
  if (entries.length === 0) return [];
  if (isFills) return [make('ul', { class: 'legend' }, ...entries.map(({ text, look }) => make('li', {}, make('span', { class: `fill fill-${look.tone}` }), text)))];
  return [make('ul', { class: 'legend' }, ...entries.map(({ text, look }) => {
    const svg = document.createElementNS(svgSpace, 'svg');
    const add = (name, attributes) => {
      const shape = document.createElementNS(svgSpace, name);
      for (const [key, value] of Object.entries(attributes)) if (value !== null) shape.setAttribute(key, value);
      svg.append(shape);
    };
    svg.setAttribute('aria-hidden', 'true');
    const color = tone(look.tone);
    if (look.form === 'band' || look.form === 'bars') add('rect', { x: 2, y: 1, width: 18, height: 10, rx: 2, style: `fill:${color}` , 'fill-opacity': look.form === 'bars' ? 1 : 0.45 });
    if (look.form.startsWith('line')) add('path', { d: 'M0 6h22', style: `stroke:${color}`, 'stroke-width': 2, 'stroke-dasharray': dashes[look.dash] });
    if (look.form.endsWith('points')) add(look.marker === 'square' ? 'rect' : 'circle', { ...(look.marker === 'square' ? { x: 7, y: 2, width: 8, height: 8 } : { cx: 11, cy: 6, r: 4 }),
      style: look.marker === 'ring' ? `fill:none;stroke:${color};stroke-width:1.6` : `fill:${color}` });
    return make('li', {}, svg, text);
  }))];
}

function gridOf(grid) {
  const cells = new Map();
  for (const cell of grid.cells) cells.set(`${cell.row} ${cell.column}`, [...(cells.get(`${cell.row} ${cell.column}`) ?? []), cell]);
  const field = (row, column) => make('td', {}, ...(cells.get(`${row} ${column}`) ?? []).map(cell => {
    const fill = make('span', { class: `fill fill-${cell.tone}` }, cell.text);
    Object.assign(fill.style, { left: `${100 * cell.left}%`, right: `${100 * (1 - cell.right)}%` });
    return fill;
  }));
  return make('div', { class: 'grid', tabindex: '0', role: 'region', 'aria-label': 'Grid' }, make('table', {},
    make('thead', {}, make('tr', {}, make('td', {}), ...grid.columns.map(column => make('th', { scope: 'col', class: 'column' }, make('span', { class: `tone-${column.tone}` }, column.text))))),
    make('tbody', {}, ...grid.rows.map((name, row) => make('tr', {}, make('th', { scope: 'row', class: 'row' }, name), ...grid.columns.map((_, column) => field(row, column)))))));
}

function listingOf({ list_columns: columns, list_rows: rows }) {
  const kind = column => (column.is_right ? 'number' : '');
  return make('div', { class: 'listing', tabindex: '0', role: 'region', 'aria-label': 'List' }, make('table', {},
    ...(columns.some(column => column.title) ? [make('thead', {}, make('tr', {}, ...columns.map(column => (column.title ? make('th', { scope: 'col', class: kind(column) }, column.title) : make('td', {})))))] : []),
    make('tbody', {}, ...rows.map(row => make('tr', {}, ...row.map((field, i) => make('td', { class: kind(columns[i]) },
      field.fill === 'none' ? field.text : make('span', { class: `badge fill-${field.fill}` }, field.text), field.detail ? make('span', { class: 'detail' }, field.detail) : '')))))));
}

/** The figure's body and legend as an element. */
export function showFigure(figure) {
  const { body } = figure;
  const shown = body.plots ? make('div', { class: 'plots' }, ...body.plots.map((plot, i) => plotOf(plot, figure, i, body.plots.length))) : body.cells ? gridOf(body) : listingOf(body);
  return make('div', {}, ...legendOf(figure.legend, !body.plots), shown);
}

/** The figure's data as a table, as tables.js has it. */
export function csvOf({ title, body }) {
  const table = (names, rows) => ({ name: title, long_name: `Data of ${title}`, row_count: rows.length, columns: names.map((name, i) => ({ name, values: rows.map(row => row[i] ?? null) })) });
  if (body.cells) return table(['row', 'column', 'text', 'colour'], body.cells.map(cell => [body.rows[cell.row], body.columns[cell.column]?.text, cell.text, cell.tone]));
  if (body.list_rows) return table(body.list_columns.map((column, i) => column.title || `column ${i + 1}`), body.list_rows.map(row => row.map(({ text, detail }) => (detail ? `${text} (${detail})` : text))));
  const value = (axis, number) => axis.categories[number] ?? number;
  const names = body.plots.length > 1 ? ['plot', 'series'] : ['series'];
  const [first] = body.plots;
  const isOneAxes = body.plots.every(plot => plot.x.label === first?.x.label && plot.y.label === first?.y.label);
  const extra = ['y_low', 'x_low', 'x_high'].filter(name => body.plots.some(plot => plot.series.some(series => series[name].length)));
  const rows = body.plots.flatMap((plot, p) => plot.series.flatMap(series => series.x.map((x, i) =>
    [...(names.length > 1 ? [isOneAxes ? p + 1 : `${plot.y.label} against ${plot.x.label}`] : []), series.name, value(plot.x, x), value(plot.y, series.y[i]), ...extra.map(name => series[name][i])])));
  return table([...names, (isOneAxes && first?.x.label) || 'x', (isOneAxes && first?.y.label) || 'y', ...extra], rows);
}
