// The moment that is shown: one row, the same in the replay, the charts and the address.

export class Moment {
  #listeners = [];
  index = 0;

  constructor(rows) {
    this.rows = rows;
  }
  get length() {
    return this.rows.step.length;
  }
  get step() {
    return this.rows.step[this.index];
  }
  get t() {
    return this.rows.t[this.index];
  }
  /** The row {step, t, x, y, vx, vy, contact}. */
  body() {
    return Object.fromEntries(['step', 't', 'x', 'y', 'vx', 'vy', 'contact'].map(name => [name, this.rows[name][this.index]]));
  }
  listen(listener) {
    this.#listeners.push(listener);
  }
  /** A row of others; the last, as of a run that goes on. */
  replace(rows, index = rows.step.length - 1) {
    this.rows = rows;
    this.index = -1;
    this.show(index);
  }
  show(index) {
    const next = Math.max(0, Math.min(this.length - 1, Math.round(index)));
    if (next === this.index) return;
    this.index = next;
    for (const listener of this.#listeners) listener(this);
  }
}
