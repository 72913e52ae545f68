// The text of a scenario file from the record that the core hands out of what was flung.
// The layout is that of tools/report/wasm/scenario_record.cpp.
import { exact } from './numbers.js';

const object = members => `{ ${members.map(([key, value]) => `"${key}": ${value}`).join(', ')} }`;
const size = (width, height) => object([['width_px', exact(width)], ['height_px', exact(height)]]);
const velocity = ([vx, vy]) => object([['vx_px_per_s', exact(vx)], ['vy_px_per_s', exact(vy)]]);

// By the number of an action; a playground has no others.
const actions = {
  0: numbers => ['fling', velocity(numbers)],
  1: ([x, y]) => ['place', object([['x_px', exact(x)], ['y_px', exact(y)]])],
  5: () => ['grab', '{}'],
  6: numbers => ['release', velocity(numbers)],
};

export function scenarioText(record, stateHash, name, description) {
  let at = 0;
  const next = (count = 1) => record.slice(at, (at += count));
  const [width, height, spriteWidth, spriteHeight, x, y, vx, vy] = next(8);
  next(3); // Rows are recorded at every step, and the trace has the length.
  const [clock, frames] = next(2);
  if (clock !== 2) throw new Error('the clock of a playground is a recorded trace');
  const trace = Array.from(next(frames), exact);
  next(); // No jitter.
  const [events] = next();
  const lines = Array.from({ length: events }, () => {
    const [, step, action, ...numbers] = next(7);
    return `\n    ${object([['step', exact(step)], actions[action](numbers)])}`;
  });
  const members = [
    ['format', '"hyrax-scenario/1"'],
    ['name', JSON.stringify(name)],
    ['description', JSON.stringify(description)],
    ['window', size(width, height)],
    ['sprite', size(spriteWidth, spriteHeight)],
    ['start', object([['x_px', exact(x)], ['y_px', exact(y)], ['vx_px_per_s', exact(vx)], ['vy_px_per_s', exact(vy)]])],
    ['clock', `{ "dt_s": [${trace.join(', ')}] }`],
    ...(lines.length ? [['events', `[${lines.join(',')}\n  ]`]] : []),
    ['expect', object([['state_hash', JSON.stringify(stateHash)]])],
  ];
  return `{\n${members.map(([key, value]) => `  "${key}": ${value}`).join(',\n')}\n}\n`;
}
