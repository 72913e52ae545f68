// Draws the window to scale: the path, contacts, the hyrax.
import { bytes, firstAtLeast } from './data.js';
import { element, root } from './document.js';
import { sizesAt } from './replay.js';

const poses = ['fly', 'stand', 'held'];

// The sprite's file has all poses; a style shows one.
function poseImage(svg, pose, onload) {
  const image = new Image();
  image.onload = onload;
  const style = `<style>.pose{display:none}#${pose}{display:inline}</style></svg>`;
  image.src = `data:image/svg+xml,${encodeURIComponent(svg.replace('</svg>', style))}`;
  return image;
}

const light = [...document.styleSheets].flatMap(({ cssRules }) => [...cssRules]).find(({ selectorText }) => selectorText === ':root').style;
/** As the page shows it; on paper the light one. */
export const color = name => ('paper' in root.dataset ? light : getComputedStyle(root)).getPropertyValue(`--${name}`).trim();

/** `repaint` follows the look of the page: dark or light, and on paper. */
export function followLook(repaint) {
  const onPaper = is => {
    root.toggleAttribute('data-paper', is);
    repaint();
  };
  addEventListener('beforeprint', () => onPaper(true));
  addEventListener('afterprint', () => onPaper(false));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint);
}

/** By a contact's bit; as kWallTones of sim/result/figure.h. */
export const wallColors = { 1: 'sky-blue', 2: 'vermilion', 4: 'purple', 8: 'orange' };
const wallDirections = { 1: [-1, 0], 2: [1, 0], 4: [0, -1], 8: [0, 1] };
// The corners of a triangle that points to its wall, from -1 to 1.
const wallCorners = wall => (([x, y]) => [[x, y], [-x - y, x - y], [y - x, -x - y]])(wallDirections[wall]);

/** A sign of its wall, of that many px to each side. */
export function paintWall(context, wall, x, y, half) {
  context.fillStyle = color(wallColors[wall]);
  context.beginPath();
  wallCorners(wall).forEach(([toX, toY], i) => context[i ? 'lineTo' : 'moveTo'](x + half * toX, y + half * toY));
  context.fill();
}
export const wallStyle = wall => `color: var(--${wallColors[wall]}); clip-path: polygon(${wallCorners(wall).map(corner => corner.map(at => `${50 + 50 * at}%`).join(' ')).join(', ')})`;

// Whether a row's speed, or that of the row before, explains its distance from that, as run_path.cpp has it. Rows
// without speeds are a hand's way.
function isFlown({ t, x, y, vx, vy }, i) {
  if (!vx) return true;
  const speed = Math.max(Math.hypot(vx[i], vy[i]), Math.hypot(vx[i - 1], vy[i - 1]));
  return Math.hypot(x[i] - x[i - 1], y[i] - y[i - 1]) <= 1.1 * speed * (t[i] - t[i - 1]) + 2;
}

// A long path takes far longer to draw than its parts; so many lines fill any window.
const linesAtOnce = 500, linesMax = 8_000;

export class Painter {
  #images;
  #stamps = new Map();
  #layer = document.createElement('canvas');
  #flights = document.createElement('canvas');
  #layerOf = [];

  constructor(canvas, onchange) {
    this.canvas = canvas;
    const svg = new TextDecoder().decode(bytes(element('sprite').textContent));
    this.#images = Object.fromEntries(poses.map(pose => [pose, poseImage(svg, pose, onchange)]));
  }

  /** What to draw: window and sprite sizes in force, rows, contacts, inputs, another run's rows. */
  setScene(scene) {
    this.scene = scene;
    this.extent = [0, 1].map(side => Math.max(...scene.sizes.map(size => size.window[side]), 1));
    this.fit();
  }

  /** Fits the canvas into its place, at the resolution of the display. */
  fit() {
    const [width, height] = this.extent;
    const place = this.canvas.parentElement, room = place.clientWidth - 2 * (parseFloat(getComputedStyle(place).paddingLeft) || 0);
    const most = Math.max(180, Math.min(innerHeight * 0.46, 600));
    const cssWidth = Math.min(room, (most * width) / height), cssHeight = Math.max(40, (cssWidth * height) / width);
    Object.assign(this.canvas.style, { width: `${cssWidth}px`, height: `${cssHeight}px` });
    this.ratio = devicePixelRatio || 1;
    this.canvas.width = Math.max(1, Math.round(cssWidth * this.ratio));
    this.canvas.height = Math.round(cssHeight * this.ratio);
    this.scale = this.canvas.width / width;
    this.#paintLayer();
  }

  /** A point of an event, in px of the window. */
  pointOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [((event.clientX - box.left) * this.extent[0]) / box.width, ((event.clientY - box.top) * this.extent[1]) / box.height];
  }

  // How lines and texts are drawn from now on; a width in points of the display.
  #pen(context, tint, width, isDashed = false) {
    context.strokeStyle = context.fillStyle = color(tint);
    context.lineWidth = width * this.ratio;
    context.setLineDash(isDashed ? [5 * this.ratio, 4 * this.ratio] : []);
  }
  #line(context, [from, ...points]) {
    context.beginPath();
    context.moveTo(...from);
    for (const point of points) context.lineTo(...point);
    context.stroke();
  }
  // Of a sprite there, on the canvas.
  #middle(x, y, sprite) {
    return [(x + sprite[0] / 2) * this.scale, (y + sprite[1] / 2) * this.scale];
  }

  // Of a path that goes over itself again only the first time is dashed, so that dashes do not fill the gaps of others.
  #path(context, rows, isDashed = false) {
    const jumps = new Path2D(), seen = new Map(), cell = 4 * this.ratio, isResized = this.scene.sizes.length > 1, [sprite] = this.scene.sizes.map(size => size.sprite);
    let flown = new Path2D(), x = NaN, y = NaN, count = 0, isUp = false, drawn = 0;
    const once = (fromX, fromY, toX, toY) => {
      const parts = Math.max(1, Math.ceil(Math.hypot(toX - fromX, toY - fromY) / cell));
      for (let part = 1; part <= parts; ++part) {
        const at = share => [fromX + (share / parts) * (toX - fromX), fromY + (share / parts) * (toY - fromY)], key = at(part - 0.5).map(place => Math.floor(place / cell)).join();
        if (!seen.has(key)) seen.set(key, count);
        const isAgain = count++ - seen.get(key) > 4;
        if (isAgain && !isUp && part > 1) flown.lineTo(...at(part - 1));
        if (!isAgain && isUp) flown.moveTo(...at(part - 1));
        isUp = isAgain;
      }
      if (!isUp) flown.lineTo(toX, toY);
    };
    let i = 0;
    for (; i < rows.x.length && drawn < linesMax; ++i) {
      const [width, height] = isResized ? sizesAt(this.scene.sizes, rows.step?.[i] ?? 0).sprite : sprite;
      const nextX = (rows.x[i] + width / 2) * this.scale, nextY = (rows.y[i] + height / 2) * this.scale;
      if (!Number.isFinite(nextX + nextY)) break;
      if (Math.abs(nextX - x) < 0.7 && Math.abs(nextY - y) < 0.7) continue;
      if (!Number.isNaN(x) && !isFlown(rows, i)) {
        jumps.moveTo(x, y);
        jumps.lineTo(nextX, nextY);
        x = NaN;
      }
      if (Number.isNaN(x)) flown.moveTo(nextX, nextY);
      else if (isDashed) once(x, y, nextX, nextY);
      else flown.lineTo(nextX, nextY);
      x = nextX;
      y = nextY;
      if (++drawn % linesAtOnce === 0 && !isDashed) {
        context.stroke(flown);
        flown = new Path2D();
        flown.moveTo(x, y);
      }
    }
    context.stroke(flown);
    context.save();
    context.setLineDash([4 * this.ratio, 3 * this.ratio]);
    context.stroke(jumps);
    context.restore();
    return drawn === linesMax && i < rows.x.length ? rows.t[i - 1] : null;
  }

  // All that does not change with the moment.
  #paintLayer() {
    const { canvas, scene } = this;
    this.#layer.width = canvas.width;
    this.#layer.height = canvas.height;
    const context = this.#layer.getContext('2d');
    context.lineJoin = 'round';
    if (scene.other) {
      this.#pen(context, scene.tint ?? 'bad', 1.5, true);
      this.#path(context, scene.other, true);
    }
    if (!scene.rows) return;
    this.#pen(context, 'path', 1.5);
    this.pathEnd = this.#path(context, scene.rows); // In s, of a path that is cut; else null.
    if (scene.contacts) this.#paintContacts(context, scene.contacts);
    this.#paintInputs(context, scene);
    for (const rows of [scene.rows, scene.other]) if (rows) this.#paintNonFinite(context, rows, scene.sizes);
  }

  // A cross before the row that is not finite, with which a run ends.
  #paintNonFinite(context, rows, sizes) {
    const row = rows.step.length - 2;
    if (row < 0 || [rows.x, rows.y, rows.vx, rows.vy].every(values => Number.isFinite(values[row + 1]))) return;
    const [x, y] = this.#middle(rows.x[row], rows.y[row], sizesAt(sizes, rows.step[row]).sprite);
    const arm = 7 * this.ratio;
    this.#pen(context, 'bad', 3);
    context.beginPath();
    for (const side of [-1, 1]) {
      context.moveTo(x - arm, y - side * arm);
      context.lineTo(x + arm, y + side * arm);
    }
    context.stroke();
    context.font = `${12 * this.ratio}px system-ui, sans-serif`;
    context.textAlign = x > this.canvas.width / 2 ? 'right' : 'left';
    context.fillText('not finite', x + (context.textAlign === 'right' ? -1.6 : 1.6) * arm, y - 1.2 * arm);
    context.textAlign = 'left';
  }

  // A ring where the hand or the script met the sprite, with its name; where a hand led it, dots.
  #paintInputs(context, { inputs, rows, sizes }) {
    const { ratio } = this;
    const named = [];
    context.font = `${11 * ratio}px system-ui, sans-serif`;
    this.#pen(context, 'ink', 1.5);
    for (const { frame, kind } of inputs.slice(0, 500)) {
      const row = firstAtLeast(rows.step, kind === 'place' ? frame + 1 : frame);
      const [x, y] = this.#middle(rows.x[row], rows.y[row], sizesAt(sizes, frame).sprite);
      if (!Number.isFinite(x + y)) continue;
      context.beginPath();
      context.arc(x, y, (kind === 'place' ? 1.5 : 4) * ratio, 0, 2 * Math.PI);
      if (kind === 'place') context.fill();
      else context.stroke();
      if (kind === 'place' || named.some(([atX, atY]) => Math.abs(atX - x) < 60 * ratio && Math.abs(atY - y) < 16 * ratio)) continue;
      context.fillText(kind, x + 8 * ratio, y - 6 * ratio);
      named.push([x, y]);
    }
  }

  // A stroke along the wall, as long as the sprite's side.
  #paintContacts(context, contacts) {
    const inset = 1.5 * this.ratio;
    for (let i = 0; i < Math.min(contacts.step.length, 500); ++i) {
      const { window, sprite } = sizesAt(this.scene.sizes, contacts.step[i]);
      const wall = contacts.wall[i], isInX = wall < 4, across = isInX ? 0 : 1, along = 1 - across;
      const at = wall === 1 || wall === 4 ? inset : window[across] * this.scale - inset;
      const ends = [0.3, 0.7].map(part => ([contacts.x, contacts.y][along][i] + sprite[along] * part) * this.scale);
      this.#pen(context, wallColors[wall], 3);
      this.#line(context, ends.map(end => (isInX ? [at, end] : [end, at])));
    }
  }

  #paintArrow(context, { x, y, vx, vy }, sprite) {
    const speed = Math.hypot(vx, vy);
    if (!(speed > 20)) return;
    const length = Math.min(0.12 * speed * this.scale, 90 * this.ratio);
    const [ux, uy] = [vx / speed, vy / speed];
    const [fromX, fromY] = this.#middle(x, y, sprite);
    const [toX, toY] = [fromX + ux * length, fromY + uy * length];
    const head = 6 * this.ratio;
    this.#pen(context, 'ink', 1.5);
    this.#line(context, [[fromX, fromY], [toX, toY]]);
    context.beginPath();
    context.moveTo(toX + ux * head, toY + uy * head);
    context.lineTo(toX - uy * head * 0.6, toY + ux * head * 0.6);
    context.lineTo(toX + uy * head * 0.6, toY - ux * head * 0.6);
    context.fill();
  }

  /** Both sprites on a canvas of its own, or of a small distance their upper left corners, with a rule from one to the other. Returns how many times it is magnified. */
  magnify(canvas, here, there, sprite, tint) {
    const { ratio } = this, side = Math.max(...sprite), [dx, dy] = [there.x - here.x, there.y - here.y], px = Math.hypot(dx, dy), isWhole = 4 * px > side;
    Object.assign(canvas, { width: Math.round(canvas.clientWidth * ratio), height: Math.round(canvas.clientHeight * ratio) });
    const half = isWhole ? Math.max(0.5 * Math.abs(dy) + 0.7 * side, ((0.5 * Math.abs(dx) + 0.7 * side) * canvas.height) / canvas.width) : 1.5 * px;
    const scale = canvas.height / (2 * half), context = canvas.getContext('2d'), aside = isWhole ? side / 2 : 0;
    const corner = [canvas.width / 2 - (dx / 2 + aside) * scale, canvas.height / 2 - (dy / 2 + aside) * scale], other = [corner[0] + dx * scale, corner[1] + dy * scale];
    const outline = ([x, y], name, width, isDashed) => {
      this.#pen(context, name, width, isDashed);
      context.strokeRect(x, y, ...sprite.map(length => Math.min(length * scale, 1e5)));
    };
    outline(corner, 'path', 3);
    outline(other, tint, 2, true);
    this.#pen(context, 'ink', 1.5);
    this.#line(context, [corner, other]);
    for (const [x, y] of [corner, other]) this.#line(context, [[x - (4 * ratio * dy) / px, y + (4 * ratio * dx) / px], [x + (4 * ratio * dy) / px, y - (4 * ratio * dx) / px]]);
    return scale / this.scale;
  }

  // An SVG takes long to draw: it is drawn once for each size.
  #stamp(pose, side) {
    const image = this.#images[pose], key = `${pose} ${side}`;
    if (!image.complete || image.naturalWidth === 0) return null;
    if (!this.#stamps.has(key)) {
      const stamp = document.createElement('canvas');
      stamp.width = stamp.height = side;
      stamp.getContext('2d').drawImage(image, 0, 0, side, side);
      this.#stamps.set(key, stamp);
    }
    return this.#stamps.get(key);
  }

  #paintHyrax(context, body, sprite, pose, tint = 'box') {
    const [width, height] = [sprite[0] * this.scale, sprite[1] * this.scale];
    const side = Math.max(2 * this.ratio, Math.min(width, height));
    context.save();
    context.translate(...this.#middle(body.x, body.y, sprite));
    this.#pen(context, tint, 1);
    context.strokeRect(-width / 2, -height / 2, width, height);
    if (body.vx < 0) context.scale(-1, 1);
    const stamp = this.#stamp(pose, Math.round(side));
    if (stamp) context.drawImage(stamp, -side / 2, -side / 2, side, side);
    context.restore();
  }

  // Long paths are drawn once.
  #flightsLayer(flights) {
    const { canvas } = this, key = [flights, canvas.width, color('ink')];
    if (key.every((part, i) => part === this.#layerOf[i])) return this.#flights;
    this.#layerOf = key;
    this.#flights.width = canvas.width;
    this.#flights.height = canvas.height;
    const context = this.#flights.getContext('2d');
    context.font = `${11 * this.ratio}px system-ui, sans-serif`;
    context.textAlign = 'center';
    flights.forEach(({ name, rows, tint }, i) => {
      this.#pen(context, tint, 1, tint === 'ink');
      this.#path(context, rows, tint === 'ink');
      if (!name) return; // Else it stands above the end, each in a line of its own.
      const [x, y] = this.#middle(rows.x.at(-1), rows.y.at(-1), this.scene.sizes[0].sprite), half = context.measureText(name).width / 2;
      context.fillText(name, Math.min(Math.max(x, half), canvas.width - half), y - (20 + 13 * i) * this.ratio);
    });
    return this.#flights;
  }

  // Above the sprite, or below it where there is no room.
  #paintLabel(context, { x, y }, { window, sprite }, label) {
    const { scale, ratio } = this;
    context.font = `600 ${13 * ratio}px system-ui, sans-serif`;
    const half = context.measureText(label).width / 2, height = 20 * ratio;
    const middle = Math.min(Math.max(this.#middle(x, y, sprite)[0], half), window[0] * scale - half);
    const at = y * scale > height ? y * scale - 6 * ratio : (y + sprite[1]) * scale + height;
    context.textAlign = 'center';
    this.#pen(context, 'screen', 4);
    context.strokeText(label, middle, at);
    context.fillStyle = color('ink');
    context.fillText(label, middle, at);
    context.textAlign = 'left';
  }

  /**
   * Draws a body {step, x, y, vx, vy, contact}; `trail`: rows to draw instead of the scene's; `flights`: rows {rows, tint}
   * of others, a list that stays the same while they do; `ghosts`: {at, tint} of others; `label`: a text above it.
   */
  paint(body, { isHeld = false, trail = null, flights = [], ghosts = [], label = '' } = {}) {
    const context = this.canvas.getContext('2d');
    const size = sizesAt(this.scene.sizes, body.step);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.fillStyle = color('screen');
    context.fillRect(0, 0, size.window[0] * this.scale, size.window[1] * this.scale);
    if (flights.length) context.drawImage(this.#flightsLayer(flights), 0, 0);
    if (trail) {
      this.#pen(context, 'path', 1.5);
      context.lineJoin = 'round';
      this.#path(context, trail);
    } else {
      context.drawImage(this.#layer, 0, 0);
    }
    context.globalAlpha = 0.4;
    for (const { at, tint } of ghosts) this.#paintHyrax(context, at, size.sprite, 'fly', tint);
    context.globalAlpha = 1;
    const isDown = body.y >= size.window[1] - size.sprite[1] - 1 && Math.abs(body.vy) < 60;
    this.#paintHyrax(context, body, size.sprite, isHeld ? 'held' : isDown ? 'stand' : 'fly');
    this.#paintArrow(context, body, size.sprite);
    if (label) this.#paintLabel(context, body, size, label);
  }
}
