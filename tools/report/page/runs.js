// Puts the page together: replays the runs, shows one, follows the reader.
import { Charts } from './charts.js';
import { Core } from './core.js';
import { contactsIn, doubles, firstAtLeast, lastAtMost, rangeOf, rowsOf } from './data.js';
import { element, make, report, root, save } from './document.js';
import { Playground } from './fling.js';
import { contactsOf, coverageOf, expectationOf, inputsOf, originOf, shownMax } from './lists.js';
import { Moment } from './moment.js';
import { count, firstOf, fixed, rounded } from './numbers.js';
import { followLook, Painter, wallStyle } from './painter.js';
import { Player, showReadouts } from './player.js';
import { partsOf } from './record.js';
import { pause, placeAt, replay, sizesAt, sizesOf } from './replay.js';
import { distancesFrom, overviewRowsMin, shownAt } from './series.js';
import { verdictOf } from './verdict.js';
import { WhatIf } from './what_if.js';

const worst = { agrees: 0, none: 1, differs: 2 };

function showHead(run) {
  document.title = `${run.name} · hyrax-sim report`;
  element('name').textContent = run.name;
  element('title').textContent = run.title.slice(run.title.indexOf(':') + 2);
  element('description').textContent = run.description;
  element('description').hidden = run.description === '';
}

function showVerdict(result) {
  const { causes, verdicts, figures } = verdictOf(result);
  const tiles = (kind, all) => make('div', { class: `tiles ${kind}` }, ...all.map(({ label, value, note, state }) => make('div', { class: `tile ${state}` },
    make('p', { class: 'label' }, label), make('p', { class: 'value' }, value), make('p', { class: 'note' }, note))));
  element('verdict').replaceChildren(...causes.map(text => make('p', { class: 'cause' }, text)), tiles('verdicts', verdicts), tiles('figures', figures));
}

const entry = (term, text) => [make('dt', {}, term), make('dd', {}, text)];

function contactRow({ step, last, wall, name, numbers }, seek) {
  const link = make('button', { type: 'button', class: 'link', onclick: () => seek(step) }, String(step));
  return make('tr', {}, make('td', {}, link, ' ', make('span', { class: 'quiet' }, last)),
    make('td', {}, make('span', { class: 'wall', style: wallStyle(wall) }), name),
    ...numbers.map(value => make('td', { class: 'number' }, rounded(value))));
}

function showContacts(result, seek) {
  const place = element('contacts');
  const { rows, heads, all } = contactsOf(result);
  if (rows.length === 0) return place.replaceChildren(make('p', { class: 'quiet' }, all === 0 ? 'None.' : `${all}, which this page does not have without its replay.`));
  place.replaceChildren(make('table', {}, make('thead', {}, make('tr', {}, ...heads.map(head => make('th', { scope: 'col' }, head)))),
    make('tbody', {}, ...rows.map(row => contactRow(row, seek)))));
  const cut = firstOf(rows.length, all);
  if (cut) place.append(make('p', { class: 'quiet' }, cut));
}

function showInputs({ run: { inputs } }, seek) {
  const lines = inputsOf(inputs), shown = lines.slice(0, shownMax), cut = firstOf(shown.length, lines.length);
  element('inputs').hidden = lines.length === 0;
  element('inputs-list').replaceChildren(...shown.map(({ frame, text }) => make('li', {},
    make('button', { type: 'button', class: 'link', onclick: () => seek(frame) }, `step ${frame}`), ` ${text}`)),
  ...(cut ? [make('li', { class: 'quiet' }, cut)] : []));
}

function showCoverage(run) {
  element('coverage').replaceChildren(...coverageOf(run).flatMap(([term, text]) => entry(term, text)));
  element('expectations').replaceChildren(...run.expect.map(expectationOf).map(({ state, word, text }) =>
    make('p', { class: `expectation ${state}` }, make('b', {}, word), ' ', text)));
}

function showOrigin({ run, check }) {
  const place = element('made');
  place.replaceChildren(...originOf(report, run, check).flatMap(([term, text, isCode]) => entry(term, isCode ? make('code', {}, text) : text)));
  if (run.scenario_text)
    place.append(...entry('scenario', make('button', { type: 'button', class: 'link',
      onclick: () => save(`${run.name}.json`, 'application/json', run.scenario_text) }, `Save ${run.name}.json`)));
}

function showDetails(result, seek) {
  showContacts(result, seek);
  showInputs(result, seek);
  showCoverage(result.run);
  showOrigin(result);
}

// The golden file's rows, or those of the file where the replay differs from it.
function otherOf(result) {
  const { run, outcome, file } = result;
  if (run.golden?.rows) {
    const rows = rowsOf(run.golden);
    if (rows.step.length > 1) return { label: 'golden', name: 'golden file', rows: run.golden.is_by_time ? shownAt(result.rows, rows) : rows };
  }
  return outcome === 'differs' && file.step.length > 1 ? { label: 'file', name: 'file', rows: file } : null;
}

const divergenceOf = ({ check, run }) => check?.firstDifference ?? run.golden?.first_divergence?.step ?? null;

class View {
  constructor(core, painter, result, reopen) {
    const { run } = result, record = doubles(run.record);
    Object.assign(this, { core, painter, result, run });
    result.other = otherOf(result);
    if (result.other) result.other.distances = distancesFrom(result.other.rows, result.rows);
    result.divergence = divergenceOf(result);
    root.toggleAttribute('data-red', Boolean(result.other));
    this.sizes = sizesOf(record, run.inputs);
    this.moment = new Moment(result.rows);
    this.reopen = reopen;
  }

  /** Shows the run, a part at each step. */
  *draw() {
    const { result, run, core } = this;
    showHead(run);
    showVerdict(result);
    showDetails(result, step => this.player.seekStep(step));
    yield;
    this.#setScene(result, this.sizes);
    yield;
    this.charts = new Charts(result, this.sizes, this.moment, index => this.player.seek(index));
    yield* this.charts.draw();
    this.player = new Player(this.moment, result.contacts, run, () => this.charts.zoom(null));
    this.charts.followsMouse = () => !this.player.isPlaying && root.dataset.mode !== 'fling';
    this.moment.listen(() => this.#follow());
    const every = result.check?.every ?? 1;
    const decimated = every > 1 ? `Drawn from one row of every ${every.toLocaleString('en')}; the comparison covers all. ` : '';
    element('charts-note').textContent = result.rows.step.length > 5_000 ? `${decimated}Of many rows to a pixel, the smallest and the largest value are drawn.` : decimated;
    element('stage-note').textContent = result.reason ? `No replay: ${result.reason}. Without it there are no errors, no causes of drift and nothing to fling.`
      : `${result.other ? `Dashed: the ${result.other.name}.` : ''}${this.painter.pathEnd ? ` The path is that of the first ${fixed(this.painter.pathEnd, 0)} s.` : ''}`.trim();
    this.whatIf = new WhatIf(core, this, partsOf(doubles(run.record)), this.reopen);
    this.setMode('replay');
    this.openLink() || this.#openWorst();
    this.#magnify();
    this.paint();
  }

  #setScene({ rows, contacts, run, other }, sizes) {
    this.painter.setScene({ sizes, rows, contacts, inputs: run.inputs, other: other?.rows, tint: other?.tint });
  }

  // Two runs: both sprites where they are farthest apart.
  #magnify() {
    const { result: { other, rows }, sizes } = this, [, most] = rangeOf(other?.distances ?? []);
    element('farthest').hidden = !(most > 0);
    if (!(most > 0)) return;
    const row = other.distances.indexOf(most), [here, there] = [placeAt(rows, rows.t[row]), placeAt(other.rows, rows.t[row])];
    const times = this.painter.magnify(element('magnifier'), here, there, sizesAt(sizes, rows.step[row]).sprite, other.tint ?? 'bad');
    element('farthest').hidden = times < 1; // Then they are seen on the stage.
    element('farthest-note').textContent = `Farthest: ${rounded(most, 3)} px at ${rounded(rows.t[row])} s, ${rounded(times, 2)} times as large; dashed: the ${other.name}.`;
  }

  // Two runs: the second around their largest distance, again and again until the reader does something. Runs that settle
  // apart come within 1 % of it while they still move.
  #openWorst() {
    const distances = this.result.other?.distances ?? [];
    const most = distances.reduce((most, px) => (px > most ? px : most), 0);
    const worst = distances.findIndex(px => px >= 0.99 * most);
    const { t } = this.result.rows;
    if (most === 0) return;
    this.player.seek(worst);
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches)
      this.player.play([firstAtLeast(t, t[worst] - 0.5), lastAtMost(t, t[worst] + 0.5)]);
  }

  paint() {
    const body = this.playground?.isLive ? this.playground.body : this.moment.body();
    const { other } = this.result;
    const ghosts = other && !this.playground ? [{ at: placeAt(other.rows, body.t), tint: other.tint ?? 'bad' }] : [];
    this.painter.paint(body, this.playground?.look(body) ?? { ghosts });
    showReadouts({ ...body, row: body.frames ?? body.step });
    element('time').setAttribute('aria-valuetext', `row ${body.step}, ${fixed(body.t, 3)} s`);
  }

  #follow() {
    if (this.playground) return this.playground.isLive || this.paint();
    this.paint();
    clearTimeout(this.writing);
    this.writing = setTimeout(() => history.replaceState(null, '', `#${report.runs.length > 1 ? `run=${report.runs.indexOf(this.run)}&` : ''}step=${this.moment.step}`), 250);
  }
  /** Opens the moment that the address names. */
  openLink() {
    const wanted = /[#&]step=(\d+)/.exec(location.hash);
    if (!wanted) return false;
    this.player.seek(Math.max(0, lastAtMost(this.moment.rows.step, Number(wanted[1]))));
    return true;
  }

  /** What is flung, so far; the verdict when it is let go, for other heights of tiles move the stage under the hand. */
  show(result) {
    this.#replace(result);
    if (!this.playground.isHeld) showVerdict(result);
    element('title').textContent = `${count(result.run.steps, 'frame')}, ${fixed(result.rows.t.at(-1), 1)} s, flung by hand`;
  }
  /** What follows from other values than the file's, at a row of it. */
  showChanged(result, record, index) {
    this.sizes = sizesOf(record, result.run.inputs);
    this.player.pause();
    this.#setScene(result, this.sizes);
    this.#replace(result, this.sizes, index);
    this.#magnify();
    showVerdict(result);
  }
  #replace(result, sizes, index) {
    this.result = result;
    this.charts.update(result, sizes);
    this.moment.replace(result.rows, index);
    this.player.follow(result.contacts, result.run);
    showContacts(result, step => this.player.seekStep(step));
  }

  setMode(mode) {
    root.dataset.mode = mode;
    const isFling = mode === 'fling';
    if (isFling) {
      this.whatIf.end();
      showHead({ name: 'Your fling', title: ': ', description: '' });
    }
    element('mode-replay').setAttribute('aria-pressed', !isFling);
    element('mode-fling').setAttribute('aria-pressed', isFling);
    element('replay-controls').hidden = isFling;
    element('what-if').classList.toggle('unseen', isFling);
    element('fling-controls').hidden = !isFling;
    this.player.pause();
    this.playground?.end();
    this.playground = isFling ? new Playground(this.core, this) : null;
    this.paint();
  }
  fit() {
    this.painter.fit();
    this.charts.fit();
    this.player.paintTicks();
    this.#magnify();
    this.paint();
  }
  repaint() {
    this.charts.repaint();
    this.fit();
  }
  end() {
    this.whatIf.end();
    this.setMode('replay');
    this.player.end();
    clearTimeout(this.writing);
  }
}

// The page's own core is the shipped one; of another it plays the step that it carries.
async function coreOfPage() {
  if (report.no_replay) return { reason: report.no_replay };
  const core = await Core.start().catch(() => null);
  if (!core) return { reason: 'this browser runs no WebAssembly' };
  if (!report.core_step) core.requireSame(report.core_fingerprint, report.program);
  else if (!core.useStep(report.core_step) || core.fingerprint() !== report.core_fingerprint)
    return { reason: `this browser calculates the step of the core ${report.core} otherwise than ${report.program}` };
  return { core };
}

async function replayed({ core, reason }, run, share) {
  if (!core || run.no_replay)
    return { run, file: rowsOf(run), rows: rowsOf(run), contacts: contactsIn(run), outcome: 'none', reason: reason ?? run.no_replay };
  return replay(core, run, share);
}

// A run of a sheet says where this browser computes other bits.
function markPanel(panel, outcome) {
  if (!panel) return;
  panel.dataset.replay = outcome;
  if (outcome !== 'differs') return;
  panel.className = 'panel bad';
  panel.querySelector('span').textContent = '✗ differs in this browser';
}

export async function showRuns() {
  root.dataset.replay = 'running';
  showHead(report.runs[0]);
  // Until then a long run has the picture of pages without JavaScript.
  const isLong = report.runs[0].row_count >= overviewRowsMin, still = isLong ? new DOMParser().parseFromString(document.querySelector('noscript').textContent, 'text/html').querySelectorAll('body > svg, body > svg + style') : [];
  element('verdict').replaceChildren(make('p', { class: 'progress', role: 'status' }, 'Replaying …'), ...still);
  if (isLong) await pause();
  const player = await coreOfPage(), { core } = player, panels = [...element('runs')?.querySelectorAll('a') ?? []];
  const panelOf = index => panels.find(panel => panel.getAttribute('href') === `#run=${index}`);
  const played = (index, progress) => replayed(player, report.runs[index], progress);
  let kept = null, view = null, opened = null; // Of several runs only one is kept with its rows.
  const order = panels.length ? panels.map(panel => Number(/\d+/.exec(panel.getAttribute('href'))[0])) : report.runs.keys();
  for (const index of order) {
    const result = await played(index, share => (element('verdict').firstChild.textContent = `Replaying ${report.runs[index].name}: ${Math.floor(100 * share)} %`));
    markPanel(panelOf(index), result.outcome);
    if (!kept || worst[result.outcome] > worst[kept.result.outcome]) kept = { index, result };
  }
  const worstResult = kept.result;
  const painter = new Painter(element('replay'), () => view?.paint());
  const open = async index => {
    view?.end();
    view = null;
    if (kept.index !== index) kept = { index, result: await played(index, () => {}) };
    const itsCore = kept.result.run.no_replay ? null : core;
    panels.forEach(panel => panel.toggleAttribute('aria-current', panel === panelOf(index)));
    opened = index;
    const next = new View(itsCore, painter, kept.result, () => open(index)), isLong = kept.result.rows.step.length >= overviewRowsMin;
    for (const _ of next.draw()) if (isLong) await pause();
    view = next;
    element('mode-fling').disabled = !itsCore;
  };
  const wanted = () => report.runs[/^#run=(\d+)/.exec(location.hash)?.[1]] && Number(/\d+/.exec(location.hash)[0]);
  element('all-runs').hidden = panels.length === 0;
  element('mode-replay').addEventListener('click', () => root.dataset.mode === 'fling' && open(opened));
  element('mode-fling').addEventListener('click', () => view?.setMode('fling'));
  let opening = open(wanted() ?? kept.index); // One after another: they share the core.
  const toRun = () => wanted() !== undefined && element('name').scrollIntoView();
  addEventListener('hashchange', () => (opening = opening.catch(() => {}).then(async () => {
    if (wanted() === undefined || wanted() === opened) view?.openLink();
    else await open(wanted());
    toRun();
  })));
  await opening;
  toRun();
  const columns = document.querySelector('.columns'), room = () => `${columns.clientWidth} ${innerHeight}`;
  let fitted = room();
  new ResizeObserver(() => fitted !== (fitted = room()) && view?.fit()).observe(columns);
  followLook(() => view?.repaint());

  if (worstResult.check) root.dataset.stateHash = worstResult.check.stateHash;
  const { check } = worstResult;
  if (worstResult.outcome === 'differs' && check.firstDifference !== null) root.dataset.firstDifference = check.firstDifference;
  root.dataset.replay = worstResult.outcome;
  root.dataset.ready = '';
  requestAnimationFrame(() => setTimeout(() => performance.mark('ready'))); // Painted.
}
