// Another run than the file's: frame rate, start and parameters have sliders; what follows is drawn beside the file's run.
import { lastAtMost } from './data.js';
import { element, make, report, root, save } from './document.js';
import { rounded } from './numbers.js';
import { atRate, inputsIn, listOf, partsOf, scenarioText } from './record.js';
import { constantsOf, playedHere } from './replay.js';
import { distancesFrom, shownAt } from './series.js';

/** Longer runs are not played again while a slider moves. */
export const stepsMax = 40_000;

// By the place of a constant in a file: what people call it, its unit, its range and its steps.
const constants = [['Gravity', 'px/s²', [0, 3600], 10], ['Bounce', '', [0, 1], 0.01], ['Drag', '', [0.9, 1], 0.0005], ['Ground friction', '', [0, 1], 0.01]];

/** {key, label, unit, own, low, high, step} each: what a reader may change of a run. */
export function slidersOf({ parameters, steps }, { start: [, , vx, vy], clock: { kind, values } }) {
  const speed = Math.hypot(vx, vy), rate = kind === 0 ? values[0] : kind === 1 ? 1 / values[0] : values.length / values.reduce((sum, dt) => sum + dt, 0);
  const rateMax = Math.min(360, (6 * stepsMax * rate) / Math.max(1, steps)); // A slow clock leaves room for many steps.
  const slider = (key, label, unit, own, [low, high], step) => ({ key, label, unit, own, low: Math.min(low, own), high: Math.max(high, own), step });
  return [
    ...(Number.isFinite(rate) ? [slider('rate', 'Frame rate', 'Hz', rate, [10, rateMax], 1)] : []),
    slider('speed', 'Start speed', 'px/s', speed, [0, Math.max(4000, 2 * speed)], 10),
    slider('angle', 'Start angle, 90 is up', '°', (Math.atan2(-vy, vx) * 180) / Math.PI, [-180, 180], 1),
    ...constants.flatMap(([label, unit, range, step], i) => (parameters?.names[i] ? [slider(parameters.names[i], label, unit, parameters.values[i], range, step)] : [])),
  ];
}

/** Of a slider that is moved there: whole steps, within its ends. */
export const valueOf = ({ low, high, step }, place) => Math.min(high, Math.max(low, Number((Math.round(place / step) * step).toPrecision(12))));

/** {parts, constants, model, parameters} of a run with these values in place of its own; constants are empty where the core's own serve. */
export function changedRun(run, parts, sliders, values) {
  const isChanged = key => sliders.some(each => each.key === key && values[key] !== each.own);
  let changed = parts;
  if (isChanged('speed') || isChanged('angle')) {
    const angle = (values.angle * Math.PI) / 180;
    changed = { ...changed, start: [...changed.start.slice(0, 2), values.speed * Math.cos(angle), -values.speed * Math.sin(angle)] };
  }
  if (isChanged('rate')) changed = atRate(changed, values.rate);
  const names = run.parameters?.names ?? [], others = names.filter(isChanged);
  if (others.length === 0) return { parts: changed, constants: constantsOf(run), model: run.model, parameters: run.parameters?.given };
  const with_ = numbers => numbers.map((number, i) => (others.includes(names[i]) ? values[names[i]] : number));
  return { parts: changed, constants: with_(run.parameters.values), model: run.model && with_(run.model), parameters: { ...run.parameters.given, ...Object.fromEntries(others.map(name => [name, values[name]])) } };
}

/** Where a run first meets the ground (8) and where it ends, and how far that is from the file's, as sentences. */
export function landingText(result, file) {
  const [here, there] = [result, file].map(({ contacts }) => contacts?.step[Array.from(contacts.wall).indexOf(8)]), ends = ({ rows }) => [rows.x.at(-1), rows.y.at(-1)];
  const [x, y] = ends(result), [fileX, fileY] = ends(file), error = result.run.errors?.truncation_px ?? null;
  const place = ({ rows }, step) => (row => `x ${rounded(rows.x[row], 5)} px after ${rounded(rows.t[row], 4)} s`)(lastAtMost(rows.step, step));
  return [here ? `Lands at ${place(result, here)}${there ? `, the file’s run at ${place(file, there)}` : ''}.` : 'Never lands.',
    `Ends at x ${rounded(x, 5)}, y ${rounded(y, 5)} px, ${rounded(Math.hypot(x - fileX, y - fileY), 3)} px from where the file’s run ends.`,
    ...(error === null ? [] : [`Truncation error ${rounded(error, 3)} px${file.run.errors ? `, of the file’s run ${rounded(file.run.errors.truncation_px, 3)} px` : ''}.`])].join(' ');
}

export class WhatIf {
  #frame = 0;

  /** `view` shows what comes out: showChanged(result, record, index); `reopen` goes back to the file's run. */
  constructor(core, view, parts, reopen) {
    const { run, result } = view, isPossible = Boolean(core) && result.check !== undefined && run.steps <= stepsMax;
    Object.assign(this, { core, view, file: result, parts, sliders: isPossible ? slidersOf(run, parts) : [] });
    this.values = Object.fromEntries(this.sliders.map(({ key, own }) => [key, own]));
    this.shown = { ...changedRun(run, parts, this.sliders, this.values), stateHash: result.check?.stateHash };
    element('what-if').hidden = !isPossible;
    element('what-if-sliders').replaceChildren(...this.sliders.map(each => this.#made(each)));
    element('what-if-note').textContent = '';
    element('save-scenario').onclick = () => this.#save();
    element('file-run').onclick = reopen;
  }

  end() {
    cancelAnimationFrame(this.#frame);
    this.#mark(false);
  }
  #mark(is) {
    root.toggleAttribute('data-what-if', is);
    element('not-the-file').hidden = !is;
    element('file-run').disabled = !is;
  }

  // A slider stands at the file's own value until it is moved, then at whole steps.
  #made(slider) {
    const { key, label, unit, own, low, high } = slider;
    const text = value => `${rounded(value, 5)}${unit === '°' ? '' : ' '}${unit}`.trim(), shown = make('output', {}, text(own));
    return make('label', {}, make('span', {}, label), make('input', { type: 'range', id: `what-if-${key}`, min: low, max: high, step: 'any', value: own, oninput: ({ target }) => {
      this.values[key] = valueOf(slider, Number(target.value));
      shown.textContent = text(this.values[key]);
      this.#frame ||= requestAnimationFrame(() => this.#play());
    } }), shown);
  }

  #play() {
    this.#frame = 0;
    const { core, file, view } = this, { run } = file, { parts, constants, model, parameters } = changedRun(run, this.parts, this.sliders, this.values);
    core.useConstants(constants);
    core.measureBy(model);
    const inputs = parts.clock === this.parts.clock ? run.inputs : inputsIn(parts);
    const result = playedHere(core, listOf(parts), { constants: run.constants && (constants.length ? constants : run.constants), inputs });
    const rows = shownAt(result.rows, file.rows);
    Object.assign(result, { isWhatIf: true, other: { label: 'file', name: 'file’s run', tint: 'quiet', rows, distances: distancesFrom(rows, result.rows) } });
    this.shown = { parts, parameters, stateHash: result.check.stateHash };
    this.#mark(true);
    element('what-if-note').textContent = landingText(result, file);
    view.showChanged(result, listOf(parts), Math.max(0, lastAtMost(result.rows.t, view.moment.t)));
  }

  #save() {
    const { parts, parameters, stateHash } = this.shown, name = `${this.file.run.name.slice(0, 55)}-changed`;
    save(`${name}.json`, 'application/json', scenarioText(parts, { stateHash, name, parameters, description: `Changed in a report of ${this.file.run.name}, ${report.program}.` }));
  }
}
