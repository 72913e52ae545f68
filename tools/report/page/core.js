// The page's core: the C++ of hyrax-sim as WebAssembly. Lists pass through its memory.
import { bytes, element, rowFields, unzipped } from './data.js';

export class Core {
  static async start() {
    const binary = await unzipped(bytes(element('core').textContent));
    const { instance } = await WebAssembly.instantiate(binary, {});
    instance.exports.__wasm_call_ctors();
    return new Core(instance.exports);
  }

  constructor(calls) {
    this.calls = calls;
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
  #text() {
    const text = new Uint8Array(this.calls.memory.buffer, this.calls.text(), this.calls.text_length());
    return String.fromCharCode(...text);
  }

  /** 32 hex digits; a program with the same core has the same. */
  fingerprint() {
    this.calls.fingerprint();
    return this.#text();
  }

  /** The scenario of a record, to be held to a file's rows and block digests. Returns its steps; -1: no scenario. */
  load(record, rows, blocks) {
    const flat = new Float64Array(rows.step.length * rowFields.length);
    rowFields.forEach((field, column) => rows[field].forEach((value, row) => (flat[row * rowFields.length + column] = value)));
    this.calls.expect_rows(this.#give(flat));
    this.calls.expect_blocks(this.#give(blocks));
    return this.calls.load(this.#give(record));
  }
  /** Plays on, up to row `step`; returns the row reached. */
  playTo(step) {
    return this.calls.play_to(step);
  }
  finish() {
    this.calls.finish();
    const [steps, every, difference, compared, complete, contacts, nonFinite] = this.#output();
    return { steps, every, compared, contacts, firstDifference: Number.isNaN(difference) ? null : difference,
      isComplete: complete === 1, nonFinite: Number.isNaN(nonFinite) ? null : nonFinite, stateHash: this.#text() };
  }

  #columns(call) {
    const columns = {};
    for (let column = 0; call(column); ++column) columns[this.#text()] = this.#output();
    return columns;
  }
  rows() {
    return this.#columns(this.calls.row_column);
  }
  contacts() {
    return this.#columns(this.calls.contact_column);
  }
  errors() {
    return this.#columns(this.calls.error_column);
  }
  /** Of the contacts that end an arc. */
  contactErrors() {
    return this.#columns(this.calls.contact_error_column);
  }
  /** Energy so far by cause, px of height, at the ends of arcs and at contacts. */
  causes() {
    return this.#columns(this.calls.cause_column);
  }

  // The playground.
  liveStart({ x, y, vx, vy, window, sprite }) {
    this.#give([x, y, vx, vy, ...window, ...sprite]);
    this.calls.live_start();
  }
  liveGrab(x, y, ticks) {
    this.calls.live_grab(x, y, ticks);
  }
  liveDrag(x, y, ticks) {
    this.calls.live_drag(x, y, ticks);
  }
  liveRelease(x, y, ticks) {
    this.calls.live_release(x, y, ticks);
  }
  liveFrame(dt) {
    this.calls.live_frame(dt);
    const [t, x, y, vx, vy, contact, frames] = this.#output();
    return { t, x, y, vx, vy, contact, frames };
  }
  liveScenario() {
    this.calls.live_scenario();
    return { record: this.#output(), stateHash: this.#text() };
  }
}
