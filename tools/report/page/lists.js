// What the lists of a run's page say, as plain values: contacts, inputs, what was exercised, how it was made.
import { walls } from './data.js';
import { count } from './numbers.js';

export const shownMax = 200;

// The errors of each contact that ends an arc, by step and wall.
const errorsOf = list => new Map(Array.from(list?.step ?? [], (step, i) => [`${step} ${list.wall[i]}`, i]));

/** {heads, rows, all}: the first contacts, {step, last, wall, name, numbers} each, and how many there are. */
export function contactsOf({ run, contacts, contactErrors, check }) {
  const heads = ['Step', 'Wall', 't, s', 'Before, px/s', 'After, px/s', 'Overshoot, px', 'Late by, ms', 'Restitution'];
  const all = Object.values(check?.contacts ?? run.result.contacts).reduce((sum, each) => sum + each, 0);
  if (!contacts) return { heads, rows: [], all };
  const errors = errorsOf(contactErrors);
  const rows = Array.from({ length: Math.min(shownMax, contacts.step.length) }, (_, i) => {
    const step = contacts.step[i], wall = contacts.wall[i], isInX = wall < 4;
    const [before, after] = isInX ? [contacts.vx_before[i], contacts.vx_after[i]] : [contacts.vy_before[i], contacts.vy_after[i]];
    const error = errors.get(`${step} ${wall}`);
    const measured = error === undefined ? [null, null] : [1000 * contactErrors.time_error[error], contactErrors.effective_restitution[error]];
    return { step, last: contacts.last_step[i] > step ? `to ${contacts.last_step[i]}` : '', wall, name: walls[Math.log2(wall)],
      numbers: [contacts.t[i], before, after, contacts.overshoot[i], ...measured] };
  });
  return { heads, rows, all };
}

/** What the hand or the script did, {frame, text} each; a hand's way is one line. */
export function inputsOf(inputs) {
  return inputs.filter(({ kind, frame }, i) => kind !== 'place' || inputs[i - 1]?.kind !== 'place' || inputs[i - 1].frame < frame - 1)
    .map(({ kind, frame, window, sprite }) => ({ frame,
      text: [kind, ...(window ? [`window ${window.join(' × ')} px`] : []), ...(sprite ? [`sprite ${sprite.join(' × ')} px`] : [])].join(', ') }));
}

/** Terms and what is said of them. */
export function coverageOf({ result, margin }) {
  const list = names => (names.length ? names.join(', ') : 'nothing');
  return [['Exercised', list(result.exercised)], ['Never touched', list(result.never_touched)],
    ['Not computed', list(result.not_computed)], ['Margin', margin || 'not measured: this core has another step than the paper']];
}

/** What is said of one expectation. */
export const expectationOf = ({ holds, text }) => (holds ? { state: 'good', word: 'holds', text } : { state: 'bad', word: 'does not hold', text });

/** Terms, what is said of them, and whether that is code. */
export function originOf(report, run, check) {
  return [
    ['command', report.command, true],
    ['report', report.program],
    ['file', `${run.file.split('/').at(-1)}, ${count(run.row_count, 'row')}`],
    ['physics', run.physics],
    ['state hash of the file', run.state_hash, true],
    ['of this browser', check?.stateHash ?? '–', true],
    ...Object.entries(run.provenance).map(([name, value]) => [name.replaceAll('_', ' '), value])];
}
