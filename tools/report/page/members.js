// The members of a sweep over two of their numbers, in the colours of a third, with a panel for each value of a choice: cells
// that tile where both are grids, points elsewhere. A click replays a member beside its neighbours.
import uPlot from 'uplot';
import { itemsOf, numbersOf, panelsOf, recordOf, stops, viridis } from './cells.js';
import { Core } from './core.js';
import { doubles, firstAtLeast, rangeOf } from './data.js';
import { element, make, report, root, save } from './document.js';
import { grouped, rounded } from './numbers.js';
import { Moment } from './moment.js';
import { color, followLook, Painter } from './painter.js';
import { Player, showReadouts } from './player.js';
import { partsOf, scenarioText } from './record.js';
import { placeAt, playedHere, sizesOf } from './replay.js';

const panelsMax = 12;

class Explorer {
  constructor(sweep, place, play) {
    this.members = doubles(sweep.members);
    this.sweep = sweep;
    this.play = play;
    this.numbers = numbersOf(sweep, this.members);
    const inputs = this.numbers.filter(each => each.isInput), results = this.numbers.filter(each => !each.isInput), choices = inputs.filter(({ isChoice, values }) => isChoice && new Set(values).size <= panelsMax);
    const panel = inputs.length > 1 ? choices[0] : undefined, varied = inputs.filter(each => each !== panel), grids = varied.filter(each => each.isGrid);
    // Of inputs that are no grids the one of most values, in the colours of the next.
    const [most, next] = varied.map(each => [new Set(each.values).size, each]).sort(([a], [b]) => b - a).map(([, each]) => each);
    this.shown = { ...(grids.length > 1 ? { x: grids[0], y: grids[1], tint: results[0] } : { x: most, y: results[0], tint: next ?? results[1] ?? results[0] }), panel };
    const choice = (key, label, numbers = this.numbers) => make('label', {}, `${label} `, make('select', { id: `members-${key}`, onchange: event => this.#choose(key, event.target.value) },
      ...numbers.map(({ name, label }) => make('option', { value: name, selected: this.shown[key]?.name === name }, label))));
    const share = sweep.count === this.members.length ? `all ${grouped(sweep.count, 0)} members` : `${grouped(this.members.length, 0)} of ${grouped(sweep.count, 0)} members`;
    this.place = make('div');
    this.hover = make('p', { class: 'quiet', role: 'status' });
    this.chosen = make('input', { type: 'number', min: 0, max: this.members.at(-1), onchange: event => this.#pick(this.#rowOf(Number(event.target.value))) });
    this.bar = make('div', { class: 'bar' });
    place.append(make('div', { class: 'head' }, make('h2', {}, 'The members'), make('p', { class: 'note quiet' }, share)),
      make('div', { class: 'choices' }, choice('x', 'Across'), choice('y', 'Up'), choice('tint', 'Colour'), ...(choices.length ? [choice('panel', 'A panel each', [...choices, { name: '', label: 'none' }])] : []),
        make('label', {}, 'Member ', this.chosen)),
      this.bar, this.place, this.hover);
    this.#draw();
    const fit = () => this.panels.forEach(({ plot, place }) => plot.setSize({ width: place.clientWidth, height: plot.height }));
    new ResizeObserver(fit).observe(this.place);
    followLook(fit);
  }

  #rowOf(member) {
    return Math.min(firstAtLeast(this.members, member), this.members.length - 1);
  }
  #choose(key, name) {
    this.shown[key] = this.numbers.find(each => each.name === name);
    this.#draw();
  }

  #draw() {
    const { x, y, tint, panel } = this.shown;
    for (const { plot } of this.panels ?? []) plot.destroy();
    this.place.className = panel ? 'panels' : '';
    this.panels = panelsOf(panel, tint.values.length).map(each => ({ ...each, ...itemsOf(this.shown, each.rows), name: panel ? `${panel.label}: ${grouped(each.value, 6)}` : '' }));
    const items = this.panels.flatMap(({ items }) => items), [{ edges }] = this.panels;
    [this.low, this.high] = rangeOf(items.map(({ value }) => value));
    const padded = values => {
      const [low, high] = rangeOf(values), room = (high - low || 1) * 0.03;
      return [low - room, high + room];
    };
    const ranges = edges ? edges.map(each => [each[0], each.at(-1)]) : [padded(items.map(item => item.x)), padded(items.map(item => item.y))];
    const what = edges ? 'A cell is the mean of its members' : 'A point is a member';
    this.place.replaceChildren(...this.panels.map(each => make('div', {}, ...(panel ? [make('h3', {}, each.name)] : []), (each.place = make('div', { class: 'plot' })))));
    for (const each of this.panels) this.#drawPanel(each, ranges, what);
    this.bar.replaceChildren(make('span', {}, tint.label), make('span', {}, rounded(this.low)),
      make('i', { style: `background: linear-gradient(90deg, ${stops.map((_, i) => viridis(i / (stops.length - 1))).join(', ')})` }), make('span', {}, rounded(this.high)));
    this.hover.textContent = `${what}. Click one to replay it.`;
  }

  #drawPanel(panel, [rangeX, rangeY], what) {
    const { x, y, tint } = this.shown, axis = { stroke: () => color('quiet'), font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif', ticks: { show: false }, grid: { show: !panel.edges, stroke: () => color('rule'), width: 1 },
      values: (_, splits) => splits.map(value => grouped(value, 6)) };
    const plot = (panel.plot = new uPlot({
      width: panel.place.clientWidth || 600, height: panel.name ? 260 : 420, padding: [12, 24, 0, 0], legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { show: false } },
      scales: { x: { time: false, range: rangeX }, y: { range: rangeY } },
      axes: [{ ...axis, label: x.label, labelSize: 22, size: 34 }, { ...axis, label: y.label, labelSize: 24, size: 62 }],
      series: [{}, { show: false }],
      hooks: { draw: [plot => this.#paint(plot, panel)] },
    }, [rangeX, [null, null]], panel.place));
    plot.root.setAttribute('role', 'img');
    plot.root.setAttribute('aria-label', `${panel.name && `${panel.name}. `}${tint.label} over ${x.label} and ${y.label}. ${what}; from ${rounded(this.low)} to ${rounded(this.high)}.`);
    plot.over.addEventListener('pointermove', event => this.#show(this.#itemAt(event, panel), panel));
    plot.over.addEventListener('click', event => this.#pick(this.#itemAt(event, panel)?.row));
  }

  #paint({ ctx, bbox, valToPos }, { edges, items }) {
    const tintOf = value => (Number.isFinite(value) ? viridis((value - this.low) / (this.high - this.low || 1)) : color('rule'));
    // A cell, or a disc of that radius around a point.
    const outline = (item, radius) => {
      ctx.beginPath();
      if (!edges) return ctx.arc(valToPos(item.x, 'x', true), valToPos(item.y, 'y', true), radius * devicePixelRatio, 0, 2 * Math.PI);
      const [left, right] = [0, 1].map(side => Math.round(valToPos(edges[0][item.column + side], 'x', true)));
      const [bottom, top] = [0, 1].map(side => Math.round(valToPos(edges[1][item.line + side], 'y', true)));
      return ctx.rect(left, top, right - left, bottom - top);
    };
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const item of items) {
      ctx.fillStyle = tintOf(item.value);
      outline(item, items.length > 800 ? 2.2 : 3.5);
      ctx.fill();
    }
    const chosen = items.find(({ row }) => row === this.row);
    if (chosen) {
      ctx.strokeStyle = color('ink');
      ctx.lineWidth = 2.5 * devicePixelRatio;
      outline(chosen, 7);
      ctx.stroke();
    }
    ctx.restore();
  }

  #nearest(x, y, { plot, items }, wanted = 1) {
    const distance = item => Math.hypot(plot.valToPos(item.x, 'x') - x, plot.valToPos(item.y, 'y') - y);
    return items.map(item => ({ item, away: distance(item) })).sort((a, b) => a.away - b.away).slice(0, wanted).map(({ item }) => item);
  }
  #itemAt(event, panel) {
    const { plot, edges, items } = panel, box = plot.over.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    if (!edges) return this.#nearest(x, y, panel)[0];
    const [column, line] = [['x', x], ['y', y]].map(([name, at], i) => firstAtLeast(edges[i], plot.posToVal(at, name)) - 1);
    return items.find(item => item.column === column && item.line === line);
  }
  #show(item, { name }) {
    if (!item) return;
    const { x, y, tint } = this.shown;
    this.hover.textContent = `${name && `${name}; `}${x.label} ${rounded(item.x, 6)}; ${y.label} ${rounded(item.y, 6)}; ${tint.label} ${rounded(item.value, 6)}; ` +
      (item.count > 1 ? `mean of ${grouped(item.count, 0)} members` : `member ${grouped(this.members[item.row], 0)}`);
  }

  // Cells that share a side, or the nearest points, of the same panel.
  #neighbours(item, panel) {
    const { plot, edges, items } = panel;
    if (!edges) return this.#nearest(plot.valToPos(item.x, 'x'), plot.valToPos(item.y, 'y'), panel, 5).filter(each => each !== item);
    return items.filter(({ column, line }) => Math.abs(column - item.column) + Math.abs(line - item.line) === 1);
  }
  #pick(row) {
    if (row === undefined) return;
    this.row = row;
    const panel = this.panels.find(({ rows }) => rows.includes(row));
    const item = panel.items.find(each => each.row === row) ?? { row, x: this.shown.x.values[row], y: this.shown.y.values[row] };
    for (const { plot } of this.panels) plot.redraw();
    this.play(this, row, this.#neighbours(item, panel).map(each => each.row));
  }

  scenarioOf(row, stateHash) {
    const { record, constants } = recordOf(this.sweep, this.numbers, row), { names = [], given = {} } = this.sweep.parameters ?? {}, { name, description = '' } = JSON.parse(this.sweep.scenario);
    return scenarioText(partsOf(record), { stateHash, name, description, parameters: Object.fromEntries(Object.keys(given).map(each => [each, constants[names.indexOf(each)]])) });
  }
}

class Stage {
  constructor(core) {
    this.core = core;
    this.painter = new Painter(element('replay'), () => this.moment && this.paint());
    const fit = () => this.moment && (this.painter.fit(), this.player.paintTicks(), this.paint());
    new ResizeObserver(fit).observe(element('member'));
    followLook(fit);
  }

  /** Plays a member of an explorer beside others, below the explorer's picture. */
  show(explorer, row, neighbours) {
    const played = each => {
      const { record, constants, texts } = recordOf(explorer.sweep, explorer.numbers, each);
      this.core.useConstants(constants);
      return { ...playedHere(this.core, record, { inputs: explorer.sweep.events }), record, texts };
    };
    const place = element('member'), result = played(row), { rows, contacts, check } = result;
    explorer.place.closest('.figure').after(place);
    place.hidden = false;
    const member = explorer.members[row];
    element('member-heading').textContent = `Member ${grouped(member, 0)}`;
    explorer.chosen.value = member;
    const inputs = Object.entries(result.texts).map(([name, text]) => `${explorer.numbers.find(each => each.name === name).label}: ${text}`).join('; ');
    element('member-note').textContent = `${inputs}. Ends at x ${rounded(rows.x.at(-1), 6)}, y ${rounded(rows.y.at(-1), 6)} px after ${grouped(check.steps, 0)} steps; contacts ` +
      `${Object.entries(check.contacts).filter(([, count]) => count).map(([wall, count]) => `${wall} ${count}`).join(', ') || 'none'}. Thin: ${neighbours.length} neighbours.`;
    element('download-member').onclick = () => save(`member-${member}.json`, 'application/json', explorer.scenarioOf(row, check.stateHash));
    this.neighbours = neighbours.map(each => ({ rows: played(each).rows, tint: 'faint' }));
    this.player?.end();
    this.moment = new Moment(rows);
    this.player = new Player(this.moment, contacts, result.run, () => {});
    this.moment.listen(() => this.paint());
    this.painter.setScene({ sizes: sizesOf(result.record, result.run.inputs), rows, contacts, inputs: result.run.inputs });
    this.player.paintTicks();
    this.player.play();
    this.paint();
    place.scrollIntoView({ block: 'nearest' }); // With the height of what is drawn.
  }
  paint() {
    const body = this.moment.body();
    this.painter.paint(body, { flights: this.neighbours, ghosts: this.neighbours.map(({ rows, tint }) => ({ tint, at: placeAt(rows, body.t) })) });
    showReadouts({ ...body, row: body.step });
  }
}

let stage = null;

// Adds to a sweep's result its members.
async function showMembers(sweep, article, label) {
  if (!stage) {
    const core = await Core.start();
    core.requireSame(sweep.core_fingerprint, report.program);
    stage = new Stage(core);
  }
  const place = make('section', { class: 'figure', 'aria-label': label });
  const figure = article.querySelector('.figure');
  if (figure) figure.before(place);
  else article.append(place);
  new Explorer(sweep, place, (...which) => stage.show(...which));
}

/** Adds to the results of the page what they have of members. */
export async function showSweeps() {
  const articles = document.querySelectorAll('.result');
  for (const [at, sweep] of report.sweeps.entries())
    if (sweep?.results.length) await showMembers(sweep, articles[at], report.sweeps.length > 1 ? `The members of result ${at + 1}` : 'The members');
  Object.assign(root.dataset, { replay: 'none', ready: '' });
}
