// A scenario as the list of numbers that the core reads, its parts, and the text of its file.
// The layout is that of tools/report/wasm/scenario_record.cpp.
import { exact } from './numbers.js';

/** {window, sprite, start: [x, y, vx, vy], every, length: [kind, value], clock: {kind, values}, jitter, events: [{when: [kind, value], action, numbers}]} */
export function partsOf(list) {
  let at = 0;
  const take = count => Array.from(list.slice(at, (at += count))), one = () => take(1)[0];
  const [window, sprite, start, every, length, kind] = [take(2), take(2), take(4), one(), take(2), one()];
  return { window, sprite, start, every, length, clock: { kind, values: take(kind === 2 ? one() : 1) }, jitter: one() ? take(4) : null,
    events: Array.from({ length: one() }, () => ({ when: take(2), action: one(), numbers: take(4) })) };
}
export const listOf = ({ window, sprite, start, every, length, clock: { kind, values }, jitter, events }) => [...window, ...sprite, ...start, every, ...length, kind,
  ...(kind === 2 ? [values.length] : []), ...values, ...(jitter ? [1, ...jitter] : [0]), events.length, ...events.flatMap(({ when, action, numbers }) => [...when, action, ...numbers])];

/** When each frame begins, in s, were there neither jitter nor hitches. */
function timeOf({ kind, values }) {
  if (kind < 2) return frame => (kind === 0 ? frame / values[0] : frame * values[0]);
  const times = [0];
  for (const dt of values) times.push(times.at(-1) + dt);
  return frame => times[frame];
}
const framesIn = (time, rate) => Math.ceil(time * rate - 1e-9);

/** The same for as long at another frame rate: events at the first frame of their time. */
export function atRate(parts, rate) {
  const time = timeOf(parts.clock), { length, clock } = parts;
  const steps = framesIn(length[0] === 2 ? length[1] : time(length[0] === 1 ? length[1] : clock.values.length), rate);
  let last = 0;
  const events = parts.events.map(event => ({ ...event, when: [0, (last = Math.max(last, framesIn(event.when[0] === 0 ? time(event.when[1]) : event.when[1], rate)))] }));
  return { ...parts, length: [1, steps], clock: { kind: 0, values: [rate] }, events: events.filter(({ when }) => when[1] < steps) };
}

const object = members => (members.length ? `{ ${members.map(([key, value]) => `"${key}": ${value}`).join(', ')} }` : '{}');
const size = ([width, height]) => object([['width_px', exact(width)], ['height_px', exact(height)]]);
const velocity = ([vx, vy]) => [['vx_px_per_s', exact(vx)], ['vy_px_per_s', exact(vy)]];
const resized = numbers => [['window', numbers.slice(0, 2)], ['sprite', numbers.slice(2)]].filter(([, [width]]) => width >= 0);
const actions = [['fling', velocity], ['place', ([x, y]) => [['x_px', exact(x)], ['y_px', exact(y)]]], ['stop', () => []],
  ['resize', numbers => resized(numbers).map(([name, sides]) => [name, size(sides)])], ['hitch', ([dt]) => [['dt_s', exact(dt)]]], ['grab', () => []], ['release', velocity]];
const jitters = [['uniform', 'fraction'], ['normal', 'sigma_s'], ['missed_frames', 'probability']];
const clocks = [['rate_hz', ([rate]) => exact(rate)], ['dt_s', ([dt]) => exact(dt)], ['dt_s', values => `[${values.map(exact).join(', ')}]`]];

/** As a page draws them: {frame, kind, window, sprite}. REQUIRES: events with frames. */
export const inputsIn = ({ events }) => events.map(({ when, action, numbers }) => ({ frame: when[1], kind: actions[action][0], ...(action === 3 ? Object.fromEntries(resized(numbers)) : {}) }))
  .filter(({ kind }) => kind !== 'hitch');

/** The file of a scenario of these parts. @param parameters by name, as its core takes them. */
export function scenarioText({ window, sprite, start: [x, y, vx, vy], every, length, clock: { kind, values }, jitter, events }, { stateHash, name, description, parameters = {} }) {
  const [clock, clockText] = clocks[kind];
  const lines = events.map(({ when, action, numbers }) => `\n    ${object([[when[0] === 0 ? 'step' : 'at_s', exact(when[1])], [actions[action][0], object(actions[action][1](numbers))]])}`);
  const members = [
    ['format', '"hyrax-scenario/1"'], ['name', JSON.stringify(name)], ['description', JSON.stringify(description)], ['window', size(window)], ['sprite', size(sprite)],
    ['start', object([['x_px', exact(x)], ['y_px', exact(y)], ...velocity([vx, vy])])],
    ['clock', object([[clock, clockText(values)], ...(jitter ? [['jitter', object([['kind', `"${jitters[jitter[0]][0]}"`], [jitters[jitter[0]][1], exact(jitter[1])],
      ['seed', String((BigInt(jitter[2]) << 32n) | BigInt(jitter[3]))]])]] : [])])],
    ...(length[0] ? [[length[0] === 1 ? 'steps' : 'duration_s', exact(length[1])]] : []),
    ...(lines.length ? [['events', `[${lines.join(',')}\n  ]`]] : []),
    ...(Object.keys(parameters).length ? [['parameters', object(Object.entries(parameters).map(([key, value]) => [key, exact(value)]))]] : []),
    ...(every === 1 ? [] : [['record', object([['every', exact(every)]])]]),
    ['expect', object([['state_hash', JSON.stringify(stateHash)]])],
  ];
  return `{\n${members.map(([key, value]) => `  "${key}": ${value}`).join(',\n')}\n}\n`;
}
