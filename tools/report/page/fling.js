// The playground: the reader grabs the hyrax and flings it, at the display's own frame times. Each throw is a run of its
// own, and flies beside the same throw at other frame rates and without frames.
import { lastAtMost } from './data.js';
import { element, make, report, root, save } from './document.js';
import { fixed, rounded } from './numbers.js';
import { partsOf, scenarioText } from './record.js';
import { constantsOf, placeAt, playedHere, sizesAt } from './replay.js';

const longestFrame_s = 0.25; // A longer pause, as in a hidden tab, belongs to no frame.
const stillFramesMax = 90;
const framesMax = 200_000;
const flight_s = 20;
const flights = [['24 Hz', 24, 'ramp-1'], ['60 Hz', 60, 'ramp-3'], ['144 Hz', 144, 'ramp-4'], ['240 Hz', 240, 'ramp-6'], ['exact', 0, 'ink']]
  .map(([name, rate, tint]) => ({ name, rate, tint }));

export class Playground {
  #frame = 0;
  #isHeld = false;
  #ticks = 0;
  #keys = new AbortController();
  #thrown = null; // The state that was let go, and when.
  #flights = [];
  #slowContact = -1;

  /** `view` shows it: paint(), show(result) and its player. */
  constructor(core, view) {
    Object.assign(this, { core, view, painter: view.painter, size: sizesAt(view.sizes, 0) });
    core.useConstants(constantsOf(view.run));
    core.measureBy(view.run.model);
    const on = (place, event, listener) => place.addEventListener(event, listener, { signal: this.#keys.signal });
    for (const [name, listener] of [['pointerdown', this.#down], ['pointermove', this.#move], ['pointerup', this.#up], ['pointercancel', this.#up]])
      on(this.painter.canvas, name, listener.bind(this));
    const actions = { again: () => this.#again(), slow: () => this.#slowMotion(), restart: () => this.#restart(), 'download-scenario': () => this.#download() };
    for (const [id, action] of Object.entries(actions)) on(element(id), 'click', action);
    on(window, 'keydown', event => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === 'SELECT') return;
      const wanted = Object.keys(actions).find(id => element(id).dataset.key === event.key.toLowerCase() && !element(id).disabled);
      if (wanted) actions[wanted]();
    });
    this.#restart();
  }

  end() {
    this.#sleep();
    this.#keys.abort();
  }
  /** The hyrax moves by itself or by hand; else a moment of the last throw is shown. */
  get isLive() {
    return this.#frame !== 0;
  }
  get isHeld() {
    return this.#isHeld;
  }

  // Another run of the same hyrax.
  #begin(state) {
    this.view.player.pause();
    this.body = { step: 0, t: 0, contact: 0, frames: 0, ...state };
    this.core.liveStart({ ...this.body, ...this.size });
    this.trail = { step: [0], x: [state.x], y: [state.y] };
    this.#slowContact = -1;
    this.#wake();
  }
  #restart() {
    const { window, sprite } = this.size;
    this.#isHeld = false;
    this.#throwFrom(null);
    this.#begin({ x: (window[0] - sprite[0]) / 2, y: 0, vx: 0, vy: 0 });
  }
  #again() {
    const { state } = this.#thrown;
    this.#throwFrom(state);
    this.#begin(state);
  }

  // From now on it flies beside the same throw at other rates; null: beside none.
  #throwFrom(state, since = 0) {
    this.#thrown = state && { state, since };
    this.#flights = state ? flights.map(each => ({ ...each, rows: this.core.flight({ ...state, ...this.size }, each.rate, flight_s) }))
      .filter(({ rows }) => rows.t.length > 0) : [];
    element('flights').replaceChildren(...[...this.#flights, ...(state ? [{ name: 'yours', tint: 'path' }] : [])].map(({ name, tint }) =>
      make('li', {}, make('i', { class: `swatch tint-${tint} ${tint === 'ink' ? 'dashed' : ''}` }), `${name} `, make('output', {}))));
    element('fling-hint').textContent = state ? 'The same throw at other frame rates: distance from the exact fling.' : 'Drag the hyrax and let go.';
    element('again').disabled = element('slow').disabled = !state;
  }

  #wake() {
    this.still = 0;
    if (this.#frame !== 0) return;
    this.last = null; // The time it stood still belongs to no frame.
    this.nextShow = 0;
    const next = now => {
      this.#frame = 0;
      this.#play(now);
      if (this.still < stillFramesMax && this.body.frames < framesMax) this.#frame = requestAnimationFrame(next);
      if (performance.now() >= this.nextShow || this.#frame === 0) this.#show();
      root.toggleAttribute('data-live', this.#frame !== 0);
      this.view.paint();
    };
    this.#frame = requestAnimationFrame(next);
  }
  #sleep() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    root.removeAttribute('data-live');
  }

  #play(now) {
    const dt = this.last === null ? 0 : (now - this.last) / 1000;
    this.last = now;
    if (dt > 0 && dt <= longestFrame_s) this.#playFrame(dt);
    if (this.#isHeld) Object.assign(this.body, this.core.liveVelocity(this.#ticksFrom(performance.now())));
  }
  #playFrame(dt) {
    const before = this.body;
    this.body = { ...this.core.liveFrame(dt), step: 0 };
    const isStill = this.body.x === before.x && this.body.y === before.y && !this.#isHeld;
    this.still = isStill ? this.still + 1 : 0;
    for (const [name, value] of [['step', 0], ['x', this.body.x], ['y', this.body.y]]) this.trail[name].push(value);
  }

  // What was flung so far as a run: some times a second, of which the hand needs all frames, and at most a fifth of the time.
  #show() {
    element('download-scenario').disabled = this.body.frames === 0;
    if (this.body.frames === 0) return;
    const begin = performance.now();
    const { record, stateHash } = this.core.liveScenario();
    this.view.show(playedHere(this.core, record, { stateHash, constants: this.view.run.constants }));
    const end = performance.now();
    this.nextShow = end + Math.max(this.#isHeld ? 200 : 50, 4 * (end - begin));
    element('fling-note').textContent = `${this.body.frames.toLocaleString('en')} frames, ${fixed(this.body.t, 1)} s`;
  }

  /** How a moment is painted. */
  look(body) {
    if (this.#isHeld) return { isHeld: true, trail: this.trail, label: `${rounded(Math.hypot(body.vx, body.vy), 3)} px/s` };
    const since = body.t - (this.#thrown?.since ?? 0);
    if (!this.#thrown || since < 0) return { trail: this.trail };
    const ghosts = this.#flights.map(({ rate, tint, rows }) => ({ rate, tint, at: placeAt(rows, since) }));
    const exact = ghosts.find(({ rate }) => rate === 0)?.at;
    const outputs = element('flights').querySelectorAll('output');
    [...ghosts.map(({ at }) => at), body].forEach(({ x, y }, i) => (outputs[i].textContent = exact ? `${fixed(Math.hypot(x - exact.x, y - exact.y), 1)} px` : '–'));
    return { trail: this.trail, flights: this.#flights, ghosts };
  }

  // The first bounce after the throw, a tenth as fast, again and again; the next time the next one.
  #slowMotion() {
    const { rows, contacts } = this.view.result;
    const bounces = contacts.t.filter(t => t > this.#thrown.since);
    if (bounces.length === 0) return;
    this.#sleep();
    const at = bounces[(this.#slowContact = (this.#slowContact + 1) % bounces.length)];
    this.view.player.play([Math.max(0, lastAtMost(rows.t, at - 0.15)), lastAtMost(rows.t, at + 0.15)], 0.1);
  }

  // A clock that does not go backwards, as the hand of hyrax.exe has it. It is set by events only: one may come
  // after a frame that is later than it.
  #ticksFrom(milliseconds) {
    return Math.max(this.#ticks, Math.round(milliseconds * 1000));
  }
  #hand(event) {
    this.#ticks = this.#ticksFrom(event.timeStamp);
    return [...this.painter.pointOf(event).map(Math.round), this.#ticks];
  }

  #down(event) {
    if (event.button !== 0 || this.#isHeld) return;
    const [x, y, ticks] = this.#hand(event);
    const { sprite } = this.size;
    const body = this.isLive ? this.body : this.view.moment.body();
    const reach = Math.max(sprite[0], sprite[1], 24 / this.painter.scale) * 0.25;
    if (x < body.x - reach || x > body.x + sprite[0] + reach || y < body.y - reach || y > body.y + sprite[1] + reach) return;
    event.preventDefault();
    this.painter.canvas.setPointerCapture(event.pointerId);
    this.#throwFrom(null);
    this.#begin({ x: body.x, y: body.y, vx: body.vx, vy: body.vy });
    this.#isHeld = true;
    this.core.liveGrab(x, y, ticks);
  }
  #move(event) {
    if (this.#isHeld) this.core.liveDrag(...this.#hand(event));
  }
  #up(event) {
    if (!this.#isHeld) return;
    this.#isHeld = false;
    this.#throwFrom(this.core.liveRelease(...this.#hand(event)), this.body.t);
    this.#wake();
  }

  #download() {
    const { record, stateHash } = this.core.liveScenario();
    const text = scenarioText(partsOf(record), { stateHash, name: 'fling', description: `Flung by hand in a report of ${this.view.run.name}, ${report.program}.`,
      parameters: this.view.run.parameters?.given });
    save('fling.json', 'application/json', text);
    element('fling-note').replaceChildren('Replay it: ', make('code', {}, 'hyrax-sim run fling.json'));
  }
}
