// The replay's controls: play, step, scrub, speed, keys.
import { firstAtLeast, lastAtMost } from './data.js';
import { element, make, root } from './document.js';
import { fixed } from './numbers.js';
import { color, paintWall } from './painter.js';

const readoutNames = [['t', 's', 3], ['row', '', 0], ['x', 'px', 2], ['y', 'px', 2], ['vx', 'px/s', 1], ['vy', 'px/s', 1]];

export function showReadouts(body) {
  const place = element('readouts');
  if (place.children.length === 0)
    place.append(...readoutNames.map(([name, unit]) => make('div', {}, make('dt', {}, name === 't' ? 'time' : name), make('dd', {}, make('output', { 'data-name': name }), unit ? ` ${unit}` : ''))));
  for (const [name, , decimals] of readoutNames)
    place.querySelector(`[data-name=${name}]`).textContent = fixed(body[name], decimals);
}

export class Player {
  #frame = 0;
  #keys = new AbortController();

  constructor(moment, contacts, run, resetZoom) {
    this.moment = moment;
    this.resetZoom = resetZoom;
    const slider = element('time');
    const on = (id, event, listener) => element(id).addEventListener(event, listener, { signal: this.#keys.signal });
    on('time', 'input', () => this.seek(Number(slider.value)));
    on('play', 'click', () => this.toggle());
    on('first', 'click', () => this.seek(0));
    on('back', 'click', () => this.seek(moment.index - 1));
    on('forward', 'click', () => this.seek(moment.index + 1));
    addEventListener('keydown', event => this.#key(event), { signal: this.#keys.signal });
    moment.listen(() => (slider.value = moment.index));
    this.follow(contacts, run);
  }

  /** The rows of the moment are others, with these contacts. */
  follow(contacts, run) {
    Object.assign(this, { contacts, run });
    element('time').max = this.moment.length - 1;
    element('time').value = this.moment.index;
    this.paintTicks();
  }

  /** Ends it: another run is shown. */
  end() {
    this.pause();
    this.#keys.abort();
  }

  get isPlaying() {
    return this.#frame !== 0;
  }
  seek(index) {
    this.pause();
    this.moment.show(index);
  }
  seekStep(step) {
    this.seek(firstAtLeast(this.moment.rows.step, step));
  }
  toggle() {
    if (this.isPlaying) this.pause();
    else this.play();
  }
  pause() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#show();
  }

  /**
   * @param loop indexes of the first and the last row that are shown again and again; null: up to the end.
   * @param speed of time; null: as chosen.
   */
  play(loop = null, speed = null) {
    cancelAnimationFrame(this.#frame);
    const { moment } = this;
    const times = moment.rows.t;
    const [first, end] = loop ?? [0, moment.length - 1];
    if (loop ? moment.index < first || moment.index > end : moment.index === end) moment.show(first);
    let t = moment.t, last = performance.now();
    const next = now => {
      t += (Math.max(0, now - last) / 1000) * (speed ?? Number(element('speed').value));
      last = now;
      moment.show(Math.min(end, lastAtMost(times, t)));
      if (t >= times[end] && !loop) return this.pause();
      if (t >= times[end]) t = times[first];
      this.#frame = requestAnimationFrame(next);
    };
    this.#frame = requestAnimationFrame(next);
    this.#show();
  }

  #show() {
    element('play').classList.toggle('playing', this.isPlaying);
    element('play').setAttribute('aria-label', this.isPlaying ? 'Pause' : 'Play');
  }

  #contact(direction) {
    const { step } = this.moment;
    const steps = this.contacts?.step ?? [];
    const wanted = direction > 0 ? steps.find(each => each > step) : steps.findLast(each => each < step);
    if (wanted !== undefined) this.seekStep(wanted);
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || root.dataset.mode === 'fling') return;
    const tag = event.target.tagName;
    if (event.target.id?.startsWith('what-if-') || tag === 'SELECT' || (tag === 'BUTTON' && event.key === ' ') || tag === 'SUMMARY') return;
    const stride = event.shiftKey ? 10 : 1;
    const actions = {
      ' ': () => this.toggle(),
      ArrowLeft: () => this.seek(this.moment.index - stride),
      ArrowRight: () => this.seek(this.moment.index + stride),
      Home: () => this.seek(0),
      End: () => this.seek(this.moment.length - 1),
      '[': () => this.#contact(-1),
      ']': () => this.#contact(1),
      0: () => this.resetZoom(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  /** A triangle for each contact, which points to its wall, a short tick for each input, a wide one where the run became non-finite: below the slider. */
  paintTicks() {
    const canvas = element('ticks');
    const ratio = devicePixelRatio || 1;
    const inset = 8; // Half the slider's thumb.
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    const context = canvas.getContext('2d');
    const last = this.moment.rows.step[this.moment.length - 1] || 1;
    const at = step => Math.round((inset + ((canvas.clientWidth - 2 * inset) * step) / last) * ratio);
    const tick = (step, height, width = 1.5) => context.fillRect(at(step), 0, Math.max(1, Math.round(width * ratio)), canvas.height * height);
    context.fillStyle = color('ink');
    for (const { frame } of this.run.inputs) tick(frame, 0.5);
    for (let i = 0; i < (this.contacts?.step.length ?? 0); ++i)
      paintWall(context, this.contacts.wall[i], at(this.contacts.step[i]), canvas.height / 2, 4 * ratio);
    context.fillStyle = color('bad');
    if (this.run.non_finite) tick(this.run.steps, 1, 5);
  }
}
