// What the pages' modules use of a browser: elements, canvases that record what is drawn, a clock that tests move, and of
// uPlot the options it is given and a linear scale.
import { readFileSync } from 'node:fs';
import { register } from 'node:module';
import { beforeEach } from 'node:test';

const resolve = `export const resolve = (name, context, next) => (name === 'uplot' ? { url: '${import.meta.url}', shortCircuit: true } : next(name === 'fflate' ? 'node:zlib' : name, context));`;
register(`data:text/javascript,${encodeURIComponent(resolve)}`);

export const page = new URL('../../../../tools/report/page/', import.meta.url);
export const load = name => import(new URL(`${name}.js`, page));
export const textOf = file => readFileSync(new URL(file, page), 'utf8');
export const count = length => Array.from({ length }, (_, i) => i);
export const base64 = values => Buffer.from(Float64Array.from(values).buffer).toString('base64');

const short = number => Math.round(100 * number) / 100;
const points = (...places) => places.map(([x, y]) => `${short(x)},${short(y)}`).join(' ');

class Path {
  shape = [];
  at = [1, 1, 0, 0];
  place(x, y) {
    return [this.at[0] * x + this.at[2], this.at[1] * y + this.at[3]];
  }
  moveTo(...to) {
    this.shape.push('from', points(this.place(...to)));
  }
  lineTo(...to) {
    this.shape.push(points(this.place(...to)));
  }
  arc(x, y, radius) {
    this.shape.push(`circle ${points(this.place(x, y))} r ${short(radius)}`);
  }
  box(x, y, width, height) {
    return points(this.place(x, y), [this.at[0] * width, this.at[1] * height]);
  }
  rect(...box) {
    this.shape.push(`box ${this.box(...box)}`);
  }
}

// Its `log` is what can be seen: each line a shape, an image or a text, with its colour and place in px of the canvas.
class Context extends Path {
  log = [];
  #saved = [];
  state = { dash: [], strokeStyle: 'black', fillStyle: 'black', lineWidth: 1, textAlign: 'left', globalAlpha: 1 };
  constructor() {
    super();
    for (const name of Object.keys(this.state)) Object.defineProperty(this, name, { get: () => this.state[name], set: value => (this.state = { ...this.state, [name]: value }) });
  }
  #say(what, color, text) {
    this.log.push(`${what} ${color}${this.globalAlpha < 1 ? ` of ${this.globalAlpha}` : ''}: ${text}`);
  }
  #pen() {
    return `${this.strokeStyle} ${short(this.lineWidth)}${this.dash.length ? ' dashed' : ''}`;
  }
  save() {
    this.#saved.push([this.state, this.at]);
  }
  restore() {
    [this.state, this.at] = this.#saved.pop();
  }
  translate(x, y) {
    this.at = [this.at[0], this.at[1], ...this.place(x, y)];
  }
  scale(x, y) {
    this.at = [this.at[0] * x, this.at[1] * y, this.at[2], this.at[3]];
  }
  setLineDash(dash) {
    this.dash = dash;
  }
  beginPath() {
    this.shape = [];
  }
  clip() {}
  stroke({ shape } = this) {
    if (shape.length) this.#say('stroke', this.#pen(), shape.join(' '));
  }
  fill() {
    this.#say('fill', this.fillStyle, this.shape.join(' '));
  }
  fillRect(...box) {
    this.#say('fill', this.fillStyle, `box ${this.box(...box)}`);
  }
  strokeRect(...box) {
    this.#say('stroke', this.#pen(), `box ${this.box(...box)}`);
  }
  clearRect() {
    this.log = [];
  }
  measureText(text) {
    return { width: 10 * text.length };
  }
  fillText(text, ...place) {
    this.#say('text', this.fillStyle, `${text} ${this.textAlign} ${points(this.place(...place))}`);
  }
  strokeText() {}
  drawImage(image, x, y, width, height) {
    if (width === undefined) this.log.push(...image.getContext().log);
    else if (image.getContext) this.#say('image', image.getContext().log.join(), this.box(x, y, width, height));
    else this.log.push(/#(\w+)\{display:inline/.exec(decodeURIComponent(image.src))[1]);
  }
}

const known = new Map();

export class Element {
  childNodes = [];
  dataset = {};
  style = {};
  attributes = {};
  listeners = [];
  hidden = false;
  clientWidth = 200;
  clientHeight = 100;
  constructor(tag, id = '') {
    this.tagName = tag.toUpperCase();
    if (id) this.setAttribute('id', id);
    if (tag === 'canvas') this.width = this.height = 0;
  }
  get id() {
    return this.attributes.id ?? '';
  }
  get children() {
    return this.childNodes.filter(each => each instanceof Element);
  }
  get firstElementChild() {
    return this.children[0];
  }
  get firstChild() {
    return this.childNodes[0];
  }
  get textContent() {
    return this.childNodes.map(each => (each instanceof Element ? each.textContent : each)).join('');
  }
  set textContent(text) {
    this.replaceChildren(text);
  }
  replaceChildren(...children) {
    this.childNodes = [];
    this.append(...children);
  }
  append(...children) {
    for (const each of children) each instanceof Element ? (each.parentElement = this) && this.childNodes.push(each) : this.childNodes.push(String(each));
  }
  after(other) {
    this.next = other;
  }
  before(other) {
    this.previous = other;
  }
  setAttribute(name, value) {
    this.attributes[name] = String(value);
    if (name === 'id') known.set(value, this);
    if (name === 'value') this.value = String(value);
    if (name.startsWith('data-')) this.dataset[name.slice(5)] = String(value);
  }
  toggleAttribute(name, is) {
    if (is) this.dataset[name.slice(5)] = '';
    else delete this.dataset[name.slice(5)];
  }
  removeAttribute(name) {
    this.toggleAttribute(name, false);
  }
  getAttribute(name) {
    return this.attributes[name];
  }
  get classes() {
    return (this.attributes.class ?? '').split(' ').filter(Boolean);
  }
  get classList() {
    const toggle = (name, is) => (this.attributes.class = [...this.classes.filter(each => each !== name), ...(is ? [name] : [])].join(' '));
    return { toggle, remove: (...names) => names.forEach(name => toggle(name, false)) };
  }
  matches(selector) {
    const [, tag, name, key, value] = /^(\w*)(?:\.([\w-]+))?(?:\[([\w-]+)(?:=([\w-]+))?\])?$/.exec(selector);
    return (!tag || this.tagName === tag.toUpperCase()) && (!name || this.classes.includes(name)) && (!key || (value ? this.attributes[key] === value : key in this.attributes));
  }
  querySelectorAll(selector) {
    return this.children.flatMap(each => [...(each.matches(selector) ? [each] : []), ...each.querySelectorAll(selector)]);
  }
  querySelector(selector) {
    return this.querySelectorAll(selector)[0] ?? null;
  }
  closest(selector) {
    return this.matches(selector) ? this : this.parentElement?.closest(selector);
  }
  addEventListener(type, listener, { signal } = {}) {
    const entry = [type, listener];
    this.listeners.push(entry);
    signal?.addEventListener('abort', () => (this.listeners = this.listeners.filter(each => each !== entry)));
  }
  fire(type, event = {}) {
    const whole = { target: this, button: 0, buttons: 0, preventDefault() {}, ...event };
    for (const [each, listener] of [...this.listeners]) if (each === type) listener(whole);
  }
  click() {
    if ('download' in this.attributes) saved.push([this.attributes.download, this.attributes.href]);
    this.fire('click');
  }
  setPointerCapture() {}
  scrollIntoView(how) {
    this.inView = how;
  }
  getBoundingClientRect() {
    return { left: 10, top: 20, width: this.clientWidth, height: this.clientHeight };
  }
  // A canvas whose size is set is empty.
  #context = new Context();
  #size = {};
  get width() {
    return this.#size.width;
  }
  set width(width) {
    this.#size.width = width;
    this.#context = new Context();
  }
  get height() {
    return this.#size.height;
  }
  set height(height) {
    this.#size.height = height;
    this.#context = new Context();
  }
  getContext() {
    return this.#context;
  }
}

/** Made when it is first asked for, as the page's HTML has them all. */
export function element(id) {
  if (!known.has(id)) new Element(['replay', 'ticks'].includes(id) ? 'canvas' : 'div', id);
  return known.get(id);
}

/** What was saved as a file: name and text. */
export const saved = [];
let waiting = [], observed = [], now = 0;

function due(kind) {
  const calls = waiting.filter(each => each.kind === kind);
  waiting = waiting.filter(each => each.kind !== kind);
  return calls;
}
/** Sets the time of the display, in ms, and calls what waits for a frame. */
export function frame(to) {
  now = to;
  for (const { call } of due('frame')) call(to);
}
/** Calls what waits for a time; returns how long each waits. */
export const later = () => due('time').map(({ call, after }) => (call(), after));

/** As a page that was just opened: nothing listens, waits or was written into it. */
export function reopen() {
  for (const each of [windowEvents, ...known.values()]) Object.assign(each, { listeners: [], ...(['data', 'sprite'].includes(each.id) ? {} : { childNodes: [] }) });
  waiting = [];
  observed = [];
  html.dataset = {};
  location.hash = '';
}

export const resize = () => observed.forEach(call => call());

beforeEach(reopen);

let ids = 0;
const wait = kind => (call, after) => waiting.push({ kind, call, after, id: ++ids }) && ids;
const stop = id => (waiting = waiting.filter(each => each.id !== id));
const html = new Element('html');
export const windowEvents = new Element('window');

Object.assign(globalThis, {
  window: windowEvents, addEventListener: windowEvents.addEventListener.bind(windowEvents), devicePixelRatio: 2, innerHeight: 1000,
  document: { documentElement: html, styleSheets: [{ cssRules: [{ selectorText: ':root', style: { getPropertyValue: name => `light ${name.slice(2)}` } }] }],
    getElementById: element, createElement: tag => new Element(tag), querySelector: selector => element(selector) },
  getComputedStyle: () => ({ getPropertyValue: name => ` ${name.slice(2)}` }),
  matchMedia: () => ({ matches: false, addEventListener() {} }),
  requestAnimationFrame: wait('frame'), cancelAnimationFrame: stop, setTimeout: wait('time'), clearTimeout: stop,
  ResizeObserver: class { constructor(call) { observed.push(call); } observe() {} }, Image: class { complete = true; naturalWidth = 1; }, Path2D: Path,
  Blob: class { constructor([text]) { this.text = text; } }, location: { hash: '' }, history: { replaceState: (_, __, address) => (location.hash = address) },
});
Object.assign(URL, { createObjectURL: ({ text }) => text, revokeObjectURL() {} });
Object.defineProperty(globalThis, 'performance', { value: { now: () => now, mark() {} } });
element('data').textContent = '{}';
element('sprite').textContent = Buffer.from('<svg></svg>').toString('base64');

/** In place of uPlot. Its axes are linear, 200 px by 100; on the canvas, with room at the left and top, twice as large. */
export default class Plot {
  static all = [];
  static paths = { stepped: ({ align }) => () => ({ kind: `steps ${align}` }), linear: () => () => ({ kind: '' }) };
  root = new Element('div');
  over = new Element('div');
  ctx = new Context();
  bbox = { left: 40, top: 20, width: 400, height: 200 };
  constructor(options, data, place) {
    Object.assign(this, { options, data, place, height: options.height });
    const range = ({ range }, low, high) => (typeof range === 'function' ? range(this, low, high) : range ?? [low, high]);
    const [minX, maxX] = range(options.scales.x, data[0][0], data[0].at(-1)), [minY, maxY] = range(options.scales.y, 0, 1);
    this.scales = { x: { min: minX, max: maxX }, y: { min: minY, max: maxY } };
    Plot.all.push(this);
  }
  valToPos = (value, axis, isCanvas) => {
    const { min, max } = this.scales[axis], part = (value - min) / (max - min), along = axis === 'x' ? 200 * part : 100 * (1 - part);
    return isCanvas ? (axis === 'x' ? 40 : 20) + 2 * along : along;
  };
  posToVal = (at, axis) => {
    const { min, max } = this.scales[axis];
    return min + (axis === 'x' ? at / 200 : 1 - at / 100) * (max - min);
  };
  setScale(axis, range) {
    this.scales[axis] = range;
    for (const hook of this.options.hooks.setScale ?? []) hook(this, axis);
  }
  setSelect(select) {
    this.select = select;
  }
  setData(data) {
    this.data = data;
  }
  redraw() {
    this.ctx.log = [];
    for (const hook of this.options.hooks.draw ?? []) hook(this);
  }
  setSize({ width }) {
    this.width = width;
  }
  destroy() {}
}
