// The page of results: verdicts, figures and tables of studies, sweeps and comparisons.
import { csvOfTable, tableOfFigure } from './csv.js';
import { element, make, report, root, save } from './document.js';
import { count } from './numbers.js';
import { tableOf } from './tables.js';
import { judgementOf } from './verdict.js';

const slug = text => text.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-').replaceAll(/^-|-$/g, '') || 'result';
const linkButton = (text, label, onclick) => make('button', { type: 'button', class: 'link', 'aria-label': label, onclick }, text);

// A part that cannot be shown, as of a file that something else wrote, does not keep the rest from being shown.
function shown(what, show) {
  try {
    return show();
  } catch (error) {
    console.warn(error);
    return make('p', { class: 'empty' }, `${what} cannot be shown: its data is not as hyrax-sim writes it.`);
  }
}

function verdictOf(result) {
  const { judgement: given, verdict: { broken, text } } = result;
  if (!given && broken.length === 0 && text.length === 0) return [];
  const tables = text.filter(part => typeof part !== 'string');
  const judgement = judgementOf(result);
  return [make('section', { class: `verdict ${broken.length ? 'bad' : given ? 'good' : ''}`, 'aria-label': 'Verdict' },
    ...(judgement ? [make('p', { class: 'judgement' }, judgement)] : []), ...(broken.length ? [make('ul', {}, ...broken.map(each => make('li', {}, each)))] : []),
    make('div', { class: tables.length > 1 && tables.every(table => table.row_count <= 20) ? 'findings columns-2' : 'findings' }, ...text.map(part => (typeof part === 'string' ? make('pre', { class: part.length < 60 && !part.trim().endsWith('.') ? 'before' : null }, part.trim()) : tableOf(part)))))];
}

// The pictures that hyrax-sim drew, in order.
const pictures = [...document.querySelectorAll('.picture')];

function figureOf(figure, name) {
  const heading = make('h3', { id: `${name}-heading` }, figure.title);
  const table = make('details', { class: 'data' }, make('summary', {}, 'Data as a table'));
  table.addEventListener('toggle', () => table.children.length === 1 && table.append(tableOf(tableOfFigure(figure))), { once: true });
  return make('figure', { class: 'figure', id: name, 'aria-labelledby': `${name}-heading` },
    make('div', { class: 'head' }, make('div', {}, heading, make('p', { class: 'quiet' }, figure.subtitle)),
      make('p', { class: `note tone-${figure.note_tone} quiet` }, figure.note)),
    pictures.shift(), ...figure.remarks.map(remark => make('p', { class: 'remarks' }, remark)),
    make('div', { class: 'actions' },
      linkButton('Save as CSV', `Save as CSV: ${figure.title}`, () => save(`${name}${figure.suffix}.csv`, 'text/csv', csvOfTable(tableOfFigure(figure)))), table));
}

// What is under the pointer or has the focus is lit in all pictures, where a series has its name.
function light({ target }) {
  const name = target.closest?.('[data-series]')?.dataset.series, all = [...document.querySelectorAll('[data-series]')];
  const isShared = all.some(each => each.dataset.series === name);
  for (const each of all) each.classList.toggle('dim', isShared && each.dataset.series !== name);
}

// Nothing of a verdict is cut or scrolled: findings with a table too wide for two columns have one, and in a table too
// wide for that each row is a block.
function fitTables() {
  const isCut = place => place.scrollWidth > place.clientWidth + 1;
  for (const findings of document.querySelectorAll('.findings')) {
    const tables = [...findings.querySelectorAll('.table')];
    for (const each of [findings, ...tables]) each.classList.remove('one-column', 'folded');
    findings.classList.toggle('one-column', tables.some(isCut));
    for (const table of tables) table.classList.toggle('folded', isCut(table));
  }
}

function tablesOf(tables, name) {
  if (tables.length === 0) return [];
  return [make('section', { 'aria-label': 'Tables' }, make('h2', {}, 'Tables'), ...tables.map(table =>
    make('details', { class: 'data' }, make('summary', {}, `${table.name}: ${table.long_name}, ${count(table.row_count, 'row')}`),
      shown('This table', () => tableOf(table)), linkButton('Save as CSV', `Save as CSV: table ${table.name}`,
        () => save(`${name}-${table.name}.csv`, 'text/csv', csvOfTable(table))))))];
}

function originOf(origin) {
  const entries = [['command', report.command], ['report', report.program], ...Object.entries(origin)];
  return make('section', { class: 'origin' }, make('h2', {}, 'How it was made'),
    make('dl', {}, ...entries.flatMap(([name, value]) => [make('dt', {}, name.replaceAll('_', ' ')),
      make('dd', {}, name === 'command' || name === 'sweep' ? make('code', {}, value) : String(value))])));
}

function resultOf(result, at, isOnly) {
  const name = isOnly ? slug(result.title) : `${slug(result.title)}-${at + 1}`;
  return make('article', { class: 'result', id: name, 'aria-label': result.title },
    make('header', {}, make(at === 0 ? 'h1' : 'h2', {}, result.title), make('p', { class: 'quiet' }, result.subtitle)),
    ...(result.figures.length > 2 ? [make('nav', { class: 'contents', 'aria-label': `Figures of ${result.title}` },
      ...result.figures.map((figure, i) => make('a', { href: `#${name}-figure-${i + 1}` }, figure.title)))] : []),
    ...[shown('The verdict', () => verdictOf(result))].flat(),
    ...(result.figures.length ? [make('h2', { class: 'unseen' }, 'Figures')] : []),
    ...result.figures.map((figure, i) => figureOf(figure, `${name}-figure-${i + 1}`)),
    ...tablesOf(result.tables, name),
    originOf(result.origin));
}

/** Shows all of them; `showMore` adds to a result what its file holds besides. */
export async function showResults(showMore = async () => {}) {
  document.title = `${report.results.map(each => each.title).join(', ')} · hyrax-sim report`;
  const shown = report.results.map((result, at) => resultOf(result, at, report.results.length === 1));
  element('results').replaceChildren(...shown);
  fitTables();
  addEventListener('resize', fitTables);
  for (const event of ['pointerover', 'focusin']) addEventListener(event, light);
  for (const picture of document.querySelectorAll('.picture > svg'))
    for (const each of [...picture.querySelectorAll('[data-series]')].filter(({ dataset }, i, all) => i === all.findIndex(other => other.dataset.series === dataset.series)))
      each.tabIndex = 0;
  root.dataset.replay = 'none';
  for (const [at, result] of report.results.entries()) await showMore(result, shown[at]);
  root.dataset.ready = '';
}
