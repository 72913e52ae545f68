// The page's core: the C++ of hyrax-sim as WebAssembly. Lists pass through its memory.
import { gunzipSync } from 'fflate';
import { bytes, rowFields, walls } from './data.js';
import { element, root } from './document.js';

export class Core {
  /** Without threads of the browser where it allows that, so that a page is ready when its scripts have run. */
  static async start() {
    const binary = gunzipSync(bytes(element('core').textContent));
    let instance;
    try {
      instance = new WebAssembly.Instance(new WebAssembly.Module(binary));
    } catch {
      ({ instance } = await WebAssembly.instantiate(binary, {})); // Older browsers compile 4 KB at once.
    }
    instance.exports.__wasm_call_ctors();
    return new Core(instance.exports);
  }

  constructor(calls) {
    Object.assign(this, { calls, isMeasuring: true });
  }

  // Memory may have moved after any call that allocates: views are made anew.
  #give(values) {
    const at = this.calls.input_room(values.length);
    new Float64Array(this.calls.memory.buffer, at, values.length).set(values);
    return values.length;
  }
  #output() {
    return new Float64Array(this.calls.memory.buffer, this.calls.output(), this.calls.output_count()).slice();
  }
  #named(...names) {
    const values = this.#output();
    return Object.fromEntries(names.map((name, i) => [name, values[i]]));
  }
  #text() {
    const text = new Uint8Array(this.calls.memory.buffer, this.calls.text(), this.calls.text_length());
    return String.fromCharCode(...text);
  }

  /** Plays by the step of a text from now on. Whether it can. */
  useStep(text) {
    return this.calls.use_step(this.#give(new TextEncoder().encode(text))) === 1;
  }
  /** Plays the paper's step with these constants from now on; with none, the core itself. */
  useConstants = constants => this.calls.use_constants(this.#give(constants));
  /** @param constants of the model by which runs are measured; null: they are not. */
  measureBy(constants) {
    this.isMeasuring = constants !== null;
    this.calls.measure_by(this.#give(constants ?? []));
  }

  /** 32 hex digits; a program with the same core has the same. */
  fingerprint() {
    this.calls.fingerprint();
    return this.#text();
  }

  /** A page replays what the program that wrote it plays, or says on top that it does not. */
  requireSame(wanted, program) {
    const found = this.fingerprint();
    if (found === wanted) return;
    root.dataset.core = 'differs';
    element('other-core').textContent = `This page replays another core than that of the program that wrote it: its picture and charts do not belong to its tables. ` +
      `Fingerprint of the page's core: ${found}; of ${program}'s: ${wanted}. To write the page again: tools/run SCENARIO --report FILE.html`;
    element('other-core').hidden = false;
  }

  /** The scenario of a record, to be held to a file's rows and block digests. Returns its steps; -1: no scenario. */
  load(record, rows = { step: [] }, blocks = []) {
    const flat = new Float64Array(rows.step.length * rowFields.length);
    rowFields.forEach((field, column) => rows[field]?.forEach((value, row) => (flat[row * rowFields.length + column] = value)));
    this.calls.expect_rows(this.#give(flat));
    this.calls.expect_blocks(this.#give(blocks));
    return this.calls.load(this.#give(record));
  }
  /** Plays on, up to row `step`; returns the row reached. */
  playTo = step => this.calls.play_to(step);
  finish() {
    this.calls.finish();
    const [steps, every, firstDifference, compared, complete, nonFinite, atRestSince, implementation_px, truncation_px, model_px, energy_drift_rel, ...counts] =
      Array.from(this.#output(), value => (Number.isNaN(value) ? null : value));
    const [contacts, bounces] = [0, 4].map(first => Object.fromEntries(walls.map((wall, at) => [wall, counts[first + at]])));
    return { steps, every, compared, firstDifference, isComplete: complete === 1, nonFinite, stateHash: this.#text(), atRestSince, contacts, bounces,
      errors: { implementation_px, truncation_px, model_px, energy_drift_rel } };
  }

  #columns(call) {
    const columns = {};
    for (let column = 0; call(column); ++column) columns[this.#text()] = this.#output();
    return columns;
  }
  rows = () => this.#columns(this.calls.row_column);
  contacts = () => this.#columns(this.calls.contact_column);
  errors = () => this.#columns(this.calls.error_column);
  /** Of the contacts that end an arc. */
  contactErrors = () => this.#columns(this.calls.contact_error_column);
  /** Energy so far by cause, px of height, at the ends of arcs and at contacts. */
  causes = () => this.#columns(this.calls.cause_column);

  #giveStart({ x, y, vx, vy, window, sprite }) {
    this.#give([x, y, vx, vy, ...window, ...sprite]);
  }
  /** Another flight from a start, at a display rate or, of rate 0, the exact one: t, x and y of its rows, none if there is none. */
  flight(start, rate, duration_s) {
    this.#giveStart(start);
    this.calls.flight(rate, duration_s);
    const rows = this.#output();
    const column = index => Float64Array.from({ length: rows.length / 3 }, (_, row) => rows[3 * row + index]);
    return { t: column(0), x: column(1), y: column(2) };
  }

  // The playground.
  liveStart(start) {
    this.#giveStart(start);
    this.calls.live_start();
  }
  liveGrab = (x, y, ticks) => this.calls.live_grab(x, y, ticks);
  liveDrag = (x, y, ticks) => this.calls.live_drag(x, y, ticks);
  liveRelease(x, y, ticks) {
    this.calls.live_release(x, y, ticks);
    return this.#named('x', 'y', 'vx', 'vy');
  }
  /** What it would fly with if it were let go now. */
  liveVelocity(ticks) {
    this.calls.live_velocity(ticks);
    return this.#named('vx', 'vy');
  }
  liveFrame(dt) {
    this.calls.live_frame(dt);
    return this.#named('t', 'x', 'y', 'vx', 'vy', 'contact', 'frames');
  }
  liveScenario() {
    this.calls.live_scenario();
    return { record: this.#output(), stateHash: this.#text() };
  }
}
