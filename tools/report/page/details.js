// Contacts, what was modelled and left out, how it was made.
import { element, make, report, save } from './document.js';
import { contactsOf, coverageOf, expectationOf, inputsOf, originOf, shownMax } from './lists.js';
import { firstOf, rounded } from './numbers.js';
import { wallColors } from './painter.js';

const entry = (term, text) => [make('dt', {}, term), make('dd', {}, text)];

function contactRow({ step, last, wall, name, numbers }, seek) {
  const link = make('button', { type: 'button', class: 'link', onclick: () => seek(step) }, String(step));
  return make('tr', {}, make('td', {}, link, ' ', make('span', { class: 'quiet' }, last)),
    make('td', {}, make('span', { class: 'wall', style: `color: var(--${wallColors[wall]})` }), name),
    ...numbers.map(value => make('td', { class: 'number' }, rounded(value))));
}

export function showContacts(result, seek) {
  const place = element('contacts');
  const { rows, heads, all } = contactsOf(result);
  if (rows.length === 0) return place.replaceChildren(make('p', { class: 'quiet' }, 'None.'));
  place.replaceChildren(make('table', {}, make('thead', {}, make('tr', {}, ...heads.map(head => make('th', { scope: 'col' }, head)))),
    make('tbody', {}, ...rows.map(row => contactRow(row, seek)))));
  const cut = firstOf(rows.length, all);
  if (cut) place.append(make('p', { class: 'quiet' }, cut));
}

function showInputs({ run: { inputs } }, seek) {
  const lines = inputsOf(inputs), shown = lines.slice(0, shownMax), cut = firstOf(shown.length, lines.length);
  element('inputs').hidden = lines.length === 0;
  element('inputs-list').replaceChildren(...shown.map(({ frame, text }) => make('li', {},
    make('button', { type: 'button', class: 'link', onclick: () => seek(frame) }, `step ${frame}`), ` ${text}`)),
  ...(cut ? [make('li', { class: 'quiet' }, cut)] : []));
}

function showCoverage(run) {
  element('coverage').replaceChildren(...coverageOf(run).flatMap(([term, text]) => entry(term, text)));
  element('expectations').replaceChildren(...run.expect.map(expectationOf).map(({ state, word, text }) =>
    make('p', { class: `expectation ${state}` }, make('b', {}, word), ' ', text)));
}

function showOrigin({ run, check }) {
  const place = element('made');
  place.replaceChildren(...originOf(report, run, check).flatMap(([term, text, isCode]) => entry(term, isCode ? make('code', {}, text) : text)));
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
