// Contacts, what was modelled and left out, how it was made.
import { element, make, report, save } from './document.js';
import { count, rounded } from './numbers.js';
import { wallColors } from './painter.js';

const shownMax = 200;
const wallNames = { 1: 'left', 2: 'right', 4: 'top', 8: 'ground' };

const entry = (term, ...texts) => [make('dt', {}, term), ...texts.map(text => make('dd', {}, text))];
const code = text => make('code', {}, text);

// The errors of each contact that ends an arc, by step and wall.
const errorsOf = list => new Map(Array.from(list?.step ?? [], (step, i) => [`${step} ${list.wall[i]}`, i]));

function contactRow({ contacts, contactErrors }, errors, i, seek) {
  const step = make('button', { type: 'button', class: 'link', onclick: () => seek(contacts.step[i]) }, String(contacts.step[i]));
  const last = contacts.last_step[i] > contacts.step[i] ? `to ${contacts.last_step[i]}` : '';
  const wall = contacts.wall[i];
  const isInX = wall < 4;
  const before = isInX ? contacts.vx_before[i] : contacts.vy_before[i];
  const after = isInX ? contacts.vx_after[i] : contacts.vy_after[i];
  const error = errors.get(`${contacts.step[i]} ${wall}`);
  const measured = error === undefined ? [null, null] : [1000 * contactErrors.time_error[error], contactErrors.effective_restitution[error]];
  return make('tr', {}, make('td', {}, step, ' ', make('span', { class: 'quiet' }, last)),
    make('td', {}, make('span', { class: 'wall', style: `color: var(--${wallColors[wall]})` }), wallNames[wall]),
    ...[contacts.t[i], before, after, contacts.overshoot[i], ...measured].map(value => make('td', { class: 'number' }, rounded(value))));
}

export function showContacts(result, seek) {
  const { contacts } = result;
  const place = element('contacts');
  if (!contacts || contacts.step.length === 0) return place.replaceChildren(make('p', { class: 'quiet' }, 'None.'));
  const heads = ['Step', 'Wall', 't, s', 'Before, px/s', 'After, px/s', 'Overshoot, px', 'Late by, ms', 'Restitution'];
  const errors = errorsOf(result.contactErrors);
  const shown = Math.min(shownMax, contacts.step.length);
  const rows = Array.from({ length: shown }, (_, i) => contactRow(result, errors, i, seek));
  place.replaceChildren(make('table', {}, make('thead', {}, make('tr', {}, ...heads.map(head => make('th', { scope: 'col' }, head)))),
    make('tbody', {}, ...rows)));
  const all = Object.values(result.check.contacts).reduce((sum, each) => sum + each, 0);
  if (all > shown) place.append(make('p', { class: 'quiet' }, `The first ${shown} of ${all.toLocaleString('en')}.`));
}

// What the hand or the script did; a hand's way is one line.
function showInputs({ run: { inputs } }, seek) {
  const lines = inputs.filter(({ kind, frame }, i) => kind !== 'place' || inputs[i - 1]?.kind !== 'place' || inputs[i - 1].frame < frame - 1);
  element('inputs').hidden = lines.length === 0;
  const what = input => [input.kind, ...(input.window ? [`window ${input.window.join(' × ')} px`] : []), ...(input.sprite ? [`sprite ${input.sprite.join(' × ')} px`] : [])].join(', ');
  element('inputs-list').replaceChildren(...lines.slice(0, shownMax).map(input => make('li', {},
    make('button', { type: 'button', class: 'link', onclick: () => seek(input.frame) }, `step ${input.frame}`), ` ${what(input)}`)),
  ...(lines.length > shownMax ? [make('li', { class: 'quiet' }, `The first ${shownMax} of ${lines.length.toLocaleString('en')}.`)] : []));
}

function showCoverage(run) {
  const list = names => (names.length ? names.join(', ') : 'nothing');
  element('coverage').replaceChildren(
    ...entry('Exercised', list(run.result.exercised)),
    ...entry('Never touched', list(run.result.never_touched)),
    ...entry('Not computed', list(run.result.not_computed)),
    ...entry('Margin', run.margin));
  element('expectations').replaceChildren(...run.expect.map(each =>
    make('p', { class: `expectation ${each.holds ? 'good' : 'bad'}` }, make('b', {}, each.holds ? 'holds' : 'does not hold'), ' ', each.text)));
}

function showOrigin({ run, check }) {
  const provenance = Object.entries(run.provenance).flatMap(([name, value]) => entry(name.replaceAll('_', ' '), value));
  const place = element('made');
  place.replaceChildren(
    ...entry('command', code(report.command)),
    ...entry('report', report.program),
    ...entry('file', `${run.file}, ${count(run.row_count, 'row')}`),
    ...entry('physics', run.physics),
    ...entry('state hash of the file', code(run.state_hash)),
    ...entry('of this browser', code(check?.stateHash ?? '–')),
    ...provenance);
  if (run.scenario_text)
    place.append(...entry('scenario', make('button', { type: 'button', class: 'link',
      onclick: () => save(`${run.name}.json`, 'application/json', run.scenario_text) }, `Save ${run.name}.json`)));
}

export function showDetails(result, seek) {
  showContacts(result, seek);
  showInputs(result, seek);
  showCoverage(result.run);
  showOrigin(result);
}
