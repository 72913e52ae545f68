// The playground: the reader grabs the hyrax and flings it, at the display's own frame times.
import { element, make, report, save } from './data.js';
import { fixed } from './numbers.js';
import { scenarioText } from './record.js';
import { sizesAt } from './replay.js';

const longestFrame_s = 0.25; // A longer pause, as in a hidden tab, belongs to no frame.
const stillFramesMax = 90;
const framesMax = 200_000;
const trailRows = 4000;

export class Playground {
  #frame = 0;
  #isHeld = false;
  #ticks = 0;

  constructor(core, painter, run, sizes, show) {
    Object.assign(this, { core, painter, run, show });
    this.size = sizesAt(sizes, 0);
    const canvas = painter.canvas;
    this.listeners = [['pointerdown', this.#down], ['pointermove', this.#move], ['pointerup', this.#up], ['pointercancel', this.#up]]
      .map(([name, listener]) => [name, listener.bind(this)]);
    for (const [name, listener] of this.listeners) canvas.addEventListener(name, listener);
    element('restart').onclick = () => this.restart();
    element('download-scenario').onclick = () => this.#download();
    this.restart();
  }

  end() {
    this.#sleep();
    for (const [name, listener] of this.listeners) this.painter.canvas.removeEventListener(name, listener);
  }

  restart() {
    const { window, sprite } = this.size;
    this.#isHeld = false;
    this.body = { step: 0, t: 0, x: (window[0] - sprite[0]) / 2, y: 0, vx: 0, vy: 0, contact: 0, frames: 0 };
    this.core.liveStart({ ...this.body, window, sprite });
    this.trail = { step: [], x: [], y: [] };
    this.#wake();
  }

  #wake() {
    this.still = 0;
    if (this.#frame !== 0) return;
    this.last = null; // The time it stood still belongs to no frame.
    const next = now => {
      this.#frame = 0;
      this.#play(now);
      if (this.still < stillFramesMax && this.body.frames < framesMax) this.#frame = requestAnimationFrame(next);
      this.#paint();
    };
    this.#frame = requestAnimationFrame(next);
  }
  #sleep() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  #play(now) {
    const dt = this.last === null ? 0 : (now - this.last) / 1000;
    this.last = now;
    if (!(dt > 0) || dt > longestFrame_s) return;
    const before = this.body;
    this.body = { ...this.core.liveFrame(dt), step: 0 };
    const isStill = this.body.x === before.x && this.body.y === before.y && !this.#isHeld;
    this.still = isStill ? this.still + 1 : 0;
    const { trail } = this;
    trail.step.push(0);
    trail.x.push(this.body.x);
    trail.y.push(this.body.y);
    if (trail.x.length > trailRows) for (const column of Object.values(trail)) column.splice(0, trailRows / 4);
  }

  #paint() {
    const { body } = this;
    this.painter.paint(body, { isHeld: this.#isHeld, trail: this.trail });
    element('download-scenario').disabled = body.frames === 0;
    element('fling-note').textContent = body.frames === 0 ? '' : `${body.frames.toLocaleString('en')} frames, ${fixed(body.t, 1)} s`;
    this.show(body);
  }

  // Whole pixels, and a clock that does not go backwards, as the hand of hyrax.exe has them.
  #hand(event) {
    const [x, y] = this.painter.pointOf(event).map(Math.round);
    this.#ticks = Math.max(this.#ticks, Math.round(event.timeStamp * 1000));
    return [x, y, this.#ticks];
  }

  #down(event) {
    if (event.button !== 0 || this.#isHeld || this.body.frames >= framesMax) return;
    const [x, y, ticks] = this.#hand(event);
    const { sprite } = this.size;
    const reach = Math.max(sprite[0], sprite[1], 24 / this.painter.scale) * 0.25;
    if (x < this.body.x - reach || x > this.body.x + sprite[0] + reach || y < this.body.y - reach || y > this.body.y + sprite[1] + reach) return;
    event.preventDefault();
    this.painter.canvas.setPointerCapture(event.pointerId);
    this.#isHeld = true;
    this.core.liveGrab(x, y, ticks);
    this.#wake();
  }
  #move(event) {
    if (this.#isHeld) this.core.liveDrag(...this.#hand(event));
  }
  #up(event) {
    if (!this.#isHeld) return;
    this.core.liveRelease(...this.#hand(event));
    this.#isHeld = false;
    this.#wake();
  }

  #download() {
    const { record, stateHash } = this.core.liveScenario();
    const text = scenarioText(record, stateHash, 'fling', `Flung by hand in a report of ${this.run.name}, ${report.program}.`);
    save('fling.json', 'application/json', text);
    element('fling-note').replaceChildren('Replay it: ', make('code', {}, 'hyrax-sim run fling.json'));
  }
}
