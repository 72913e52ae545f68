// The members of a sweep over two of their numbers, in the colours of a third: cells that tile where both are grids,
// points elsewhere. A click replays a member beside its neighbours.
import uPlot from 'uplot';
import { itemsOf, numbersOf, recordOf, stops, viridis } from './cells.js';
import { Core } from './core.js';
import { doubles, firstAtLeast, rangeOf } from './data.js';
import { element, make, report, root, save } from './document.js';
import { grouped, rounded } from './numbers.js';
import { Moment } from './moment.js';
import { color, followLook, Painter } from './painter.js';
import { Player, showReadouts } from './player.js';
import { partsOf, scenarioText } from './record.js';
import { placeAt, playedHere, sizesOf } from './replay.js';

class Explorer {
  constructor(sweep, place, play) {
    this.members = doubles(sweep.members);
    this.sweep = sweep;
    this.play = play;
    this.numbers = numbersOf(sweep, this.members);
    const inputs = this.numbers.filter(each => each.isInput), results = this.numbers.filter(each => !each.isInput);
    const grids = inputs.filter(each => each.isGrid);
    // Of inputs that are no grids the one of most values, in the colours of the next.
    const [most, next] = inputs.map(each => [new Set(each.values).size, each]).sort(([a], [b]) => b - a).map(([, each]) => each);
    this.shown = grids.length > 1 ? { x: grids[0], y: grids[1], tint: results[0] } : { x: most, y: results[0], tint: next ?? results[1] ?? results[0] };
    const choice = (key, label) => make('label', {}, `${label} `, make('select', { id: `members-${key}`, onchange: event => this.#choose(key, event.target.value) },
      ...this.numbers.map(({ name, label }) => make('option', { value: name, selected: this.shown[key].name === name }, label))));
    const share = sweep.count === this.members.length ? `all ${grouped(sweep.count, 0)} members` : `${grouped(this.members.length, 0)} of ${grouped(sweep.count, 0)} members`;
    this.place = make('div', { class: 'plot' });
    this.hover = make('p', { class: 'quiet', role: 'status' });
    this.bar = make('div', { class: 'bar' });
    place.append(make('div', { class: 'head' }, make('h2', {}, 'The members'), make('p', { class: 'note quiet' }, share)),
      make('div', { class: 'choices' }, choice('x', 'Across'), choice('y', 'Up'), choice('tint', 'Colour'),
        make('label', {}, 'Member ', make('input', { type: 'number', id: 'member-number', min: 0, max: this.members.at(-1), onchange: event => this.#pick(this.#rowOf(Number(event.target.value))) }))),
      this.bar, this.place, this.hover);
    this.#draw();
    const fit = () => this.plot.setSize({ width: this.place.clientWidth, height: this.plot.height });
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
    const { x, y, tint } = this.shown;
    Object.assign(this, itemsOf(this.shown));
    [this.low, this.high] = rangeOf(this.items.map(({ value }) => value));
    const padded = values => {
      const [low, high] = rangeOf(values), room = (high - low || 1) * 0.03;
      return [low - room, high + room];
    };
    const [rangeX, rangeY] = this.edges ? this.edges.map(edges => [edges[0], edges.at(-1)]) : [padded(this.items.map(item => item.x)), padded(this.items.map(item => item.y))];
    const axis = { stroke: () => color('quiet'), font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif', ticks: { show: false }, grid: { show: !this.edges, stroke: () => color('rule'), width: 1 },
      values: (_, splits) => splits.map(value => grouped(value, 6)) };
    this.plot?.destroy();
    this.plot = new uPlot({
      width: this.place.clientWidth || 600, height: 420, padding: [12, 24, 0, 0], legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { show: false } },
      scales: { x: { time: false, range: rangeX }, y: { range: rangeY } },
      axes: [{ ...axis, label: x.label, labelSize: 22, size: 34 }, { ...axis, label: y.label, labelSize: 24, size: 62 }],
      series: [{}, { show: false }],
      hooks: { draw: [plot => this.#paint(plot)] },
    }, [rangeX, [null, null]], this.place);
    const what = this.edges ? 'A cell is the mean of its members' : 'A point is a member';
    this.plot.root.setAttribute('role', 'img');
    this.plot.root.setAttribute('aria-label', `${tint.label} over ${x.label} and ${y.label}. ${what}; from ${rounded(this.low)} to ${rounded(this.high)}.`);
    this.plot.over.addEventListener('pointermove', event => this.#show(this.#itemAt(event)));
    this.plot.over.addEventListener('click', event => this.#pick(this.#itemAt(event)?.row));
    this.bar.replaceChildren(make('span', {}, tint.label), make('span', {}, rounded(this.low)),
      make('i', { style: `background: linear-gradient(90deg, ${stops.map((_, i) => viridis(i / (stops.length - 1))).join(', ')})` }), make('span', {}, rounded(this.high)));
    this.hover.textContent = `${what}. Click one to replay it.`;
  }

  #paint({ ctx, bbox, valToPos }) {
    const tintOf = value => (Number.isFinite(value) ? viridis((value - this.low) / (this.high - this.low || 1)) : color('rule'));
    // A cell, or a disc of that radius around a point.
    const outline = (item, radius) => {
      ctx.beginPath();
      if (!this.edges) return ctx.arc(valToPos(item.x, 'x', true), valToPos(item.y, 'y', true), radius * devicePixelRatio, 0, 2 * Math.PI);
      const [left, right] = [0, 1].map(side => Math.round(valToPos(this.edges[0][item.column + side], 'x', true)));
      const [bottom, top] = [0, 1].map(side => Math.round(valToPos(this.edges[1][item.line + side], 'y', true)));
      return ctx.rect(left, top, right - left, bottom - top);
    };
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const item of this.items) {
      ctx.fillStyle = tintOf(item.value);
      outline(item, this.items.length > 800 ? 2.2 : 3.5);
      ctx.fill();
    }
    const chosen = this.items.find(({ row }) => row === this.row);
    if (chosen) {
      ctx.strokeStyle = color('ink');
      ctx.lineWidth = 2.5 * devicePixelRatio;
      outline(chosen, 7);
      ctx.stroke();
    }
    ctx.restore();
  }

  #nearest(x, y, wanted = 1) {
    const { plot } = this;
    const distance = item => Math.hypot(plot.valToPos(item.x, 'x') - x, plot.valToPos(item.y, 'y') - y);
    return this.items.map(item => ({ item, away: distance(item) })).sort((a, b) => a.away - b.away).slice(0, wanted).map(({ item }) => item);
  }
  #itemAt(event) {
    const box = this.plot.over.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    if (!this.edges) return this.#nearest(x, y)[0];
    const [column, line] = [['x', x], ['y', y]].map(([name, at], i) => firstAtLeast(this.edges[i], this.plot.posToVal(at, name)) - 1);
    return this.items.find(item => item.column === column && item.line === line);
  }
  #show(item) {
    if (!item) return;
    const { x, y, tint } = this.shown;
    this.hover.textContent = `${x.label} ${rounded(item.x, 6)}; ${y.label} ${rounded(item.y, 6)}; ${tint.label} ${rounded(item.value, 6)}; ` +
      (item.count > 1 ? `mean of ${grouped(item.count, 0)} members` : `member ${grouped(this.members[item.row], 0)}`);
  }

  // Cells that share a side, or the nearest points.
  #neighbours(item) {
    if (!this.edges) return this.#nearest(this.plot.valToPos(item.x, 'x'), this.plot.valToPos(item.y, 'y'), 5).filter(each => each !== item);
    return this.items.filter(({ column, line }) => Math.abs(column - item.column) + Math.abs(line - item.line) === 1);
  }
  #pick(row) {
    if (row === undefined) return;
    this.row = row;
    const item = this.items.find(each => each.row === row) ?? { row, x: this.shown.x.values[row], y: this.shown.y.values[row] };
    this.plot.redraw();
    this.play(this, row, this.#neighbours(item).map(each => each.row));
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
    place.scrollIntoView({ block: 'nearest' });
    const member = explorer.members[row];
    element('member-heading').textContent = `Member ${grouped(member, 0)}`;
    element('member-number').value = member;
    const inputs = Object.entries(result.texts).map(([name, text]) => `${name} ${text}`).join(', ');
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
  }
  paint() {
    const body = this.moment.body();
    this.painter.paint(body, { flights: this.neighbours, ghosts: this.neighbours.map(({ rows, tint }) => ({ tint, at: placeAt(rows, body.t) })) });
    showReadouts({ ...body, row: body.step });
  }
}

let stage = null;

// Adds to a sweep's result its members.
async function showMembers(sweep, article) {
  if (!stage) {
    const core = await Core.start();
    core.requireSame(sweep.core_fingerprint, report.program);
    stage = new Stage(core);
  }
  const place = make('section', { class: 'figure', 'aria-label': 'The members' });
  const figure = article.querySelector('.figure');
  if (figure) figure.before(place);
  else article.append(place);
  new Explorer(sweep, place, (...which) => stage.show(...which));
}

/** Adds to the results of the page what they have of members. */
export async function showSweeps() {
  const articles = document.querySelectorAll('.result');
  for (const [at, sweep] of report.sweeps.entries())
    if (sweep?.results.length) await showMembers(sweep, articles[at]);
  Object.assign(root.dataset, { replay: 'none', ready: '' });
}
