// The picture of a sweep's members as plain values: their numbers, cells or points, colours.
import { doubles, firstAtLeast } from './data.js';
import { constantsOf } from './replay.js';

const cellsMax = 100; // Along an axis.
const pointsMax = 5000;
export const stops = ['440154', '472d7b', '3b528b', '2c728e', '21918c', '28ae80', '5ec962', 'addc30', 'fde725']
  .map(hex => [0, 2, 4].map(at => parseInt(hex.slice(at, at + 2), 16)));

/** Viridis, for 0 .. 1. */
export function viridis(part) {
  const at = Math.min(Math.max(part, 0), 1) * (stops.length - 1), low = Math.min(Math.floor(at), stops.length - 2);
  return `rgb(${stops[low].map((from, i) => Math.round(from + (at - low) * (stops[low + 1][i] - from))).join(' ')})`;
}

// What people call a number of a scenario, with its unit; what has no name here keeps its pointer.
const names = { '/start/x_px': 'start, x from the left, px', '/start/y_px': 'start, y from the top, px', '/start/vx_px_per_s': 'start speed to the right, px/s', '/start/vy_px_per_s': 'start speed downwards, px/s',
  '/clock/rate_hz': 'frame rate, Hz', '/clock/dt_s': 'frame time, s', '/clock/jitter/seed': 'seed of the jitter', '/window/width_px': 'window width, px', '/window/height_px': 'window height, px' };
const labelOf = pointer => names[pointer] ?? (pointer.startsWith('/parameters/') ? pointer.slice('/parameters/'.length) : pointer);

/** What can stand on an axis or be a colour: {name, label, values, isGrid, isInput, all, stride}. */
export function numbersOf({ inputs, results }, members) {
  return [
    ...inputs.map(({ name, is_seed, is_grid, is_choice, values }) => ({ name, label: labelOf(name), isGrid: is_grid, isChoice: is_choice, isInput: true, all: doubles(values), stride: is_seed ? 2 : 1 })),
    ...results.map(({ name, unit, values }) => ({ name, label: unit && unit !== '1' ? `${name}, ${unit}` : name, isGrid: false, all: doubles(values), stride: 1 }))]
    .map(each => ({ ...each, values: each.stride === 1 ? each.all : members.map((_, i) => each.all[2 * i] * 2 ** 32 + each.all[2 * i + 1]) }));
}

// The edges of a grid's cells: halfway between its values, or even ones of many values.
function edgesOf(values) {
  const found = [...new Set(values)].sort((a, b) => a - b), count = Math.min(found.length, cellsMax);
  const [low, high] = [found[0], found.at(-1)], half = (high - low || 1) / (2 * (found.length - 1 || 1));
  if (count === found.length)
    return [low - half, ...found.slice(1).map((each, i) => (each + found[i]) / 2), high + half];
  return Array.from({ length: count + 1 }, (_, i) => low - half + (i * (high - low + 2 * half)) / count);
}

/** The rows of each panel, {value, rows}, by rising values: of a choice one each, else one of all. */
export function panelsOf(choice, count) {
  const all = Array.from({ length: count }, (_, row) => row);
  if (!choice) return [{ rows: all }];
  return [...new Set(choice.values)].sort((a, b) => a - b).map(value => ({ value, rows: all.filter(row => choice.values[row] === value) }));
}

/** {edges, items} of these rows: cells {column, line, row, x, y, value, count} of two grids, points {row, x, y, value} of others. Edges are those of all rows. */
export function itemsOf({ x, y, tint }, rows) {
  if (!(x.isGrid && y.isGrid && x !== y)) {
    const stride = Math.ceil(rows.length / pointsMax);
    const points = rows.filter((_, i) => i % stride === 0).map(row => ({ row, x: x.values[row], y: y.values[row], value: tint.values[row] }));
    return { edges: null, items: points.filter(item => Number.isFinite(item.x + item.y)) };
  }
  const edges = [edgesOf(x.values), edgesOf(y.values)], [across, up] = edges, cells = new Map();
  for (const row of rows) {
    const column = firstAtLeast(across, x.values[row]) - 1, line = firstAtLeast(up, y.values[row]) - 1;
    const key = column + line * cellsMax;
    if (!cells.has(key)) cells.set(key, { column, line, row, x: x.values[row], y: y.values[row], sum: 0, count: 0 });
    const cell = cells.get(key);
    if (!Number.isFinite(tint.values[row])) continue;
    cell.sum += tint.values[row];
    ++cell.count;
  }
  return { edges, items: [...cells.values()].map(cell => ({ ...cell, value: cell.count ? cell.sum / cell.count : NaN })) };
}

/** The record of a sample's member, the constants that it is played with, and its varied numbers as texts by pointer. */
export function recordOf(sweep, numbers, row) {
  const record = doubles(sweep.record), constants = [...constantsOf(sweep)], texts = {};
  for (const [key, { name, place }] of sweep.inputs.entries()) {
    const { all, stride } = numbers[key], values = all.slice(stride * row, stride * (row + 1));
    if (name.startsWith('/parameters/')) constants[sweep.parameters.names.indexOf(name.slice('/parameters/'.length))] = values[0];
    else values.forEach((value, i) => (record[place + i] = value));
    texts[name] = stride === 1 ? String(values[0]) : String((BigInt(values[0]) << 32n) | BigInt(values[1]));
  }
  return { record, constants, texts };
}
