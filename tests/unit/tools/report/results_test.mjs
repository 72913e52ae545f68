// The page of results: all that it says of verdicts, figures, tables and origins, what it saves, and what the pointer lights.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { Element, element, load, saved, windowEvents } from './stand_in.mjs';

const of = (tag, attributes, ...children) => {
  const made = new Element(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
};
const series = ['a', 'b', 'a'].map(name => of('g', { 'data-series': name }, of('path', {})));
const pictures = [of('svg', {}, ...series), of('svg', {}), of('svg', {})].map(svg => of('div', { class: 'picture' }, svg));
const found = { '.picture': pictures, '.picture > svg': pictures.map(({ firstChild }) => firstChild), '[data-series]': series };
document.querySelectorAll = selector => found[selector] ?? element('results').querySelectorAll(selector);
const { report } = await load('document');
const { showResults } = await load('results');

const table = (name, count, columns) => ({ name, long_name: `Table ${name}`, row_count: count, columns });
const long = 'a text of more than thirty-six letters';
const small = table('speeds', 2, [{ name: 'method_of', values: ['Euler', 'Verlet'] }, { name: 'speed', unit: 'px2/s2', long_name: 'how fast', digits: 2, values: [12.345, null] }, { name: 'holds', values: [true, false] }, { name: '', unit: '1', values: ['', long] }, { name: 'n', values: [1.23456789, 2] }, { name: 'short', values: ['', long.slice(0, 36)] }]);
const cut = table('rows', 5, [{ name: 'step', unit: '1', values: [0, 1] }]);
const figure = (title, more) => ({ suffix: '-all', title, subtitle: `Of ${title}`, note: 'a note', note_tone: 'bad', remarks: ['First.', 'Second.'],
  body: { plots: [{ x: { label: 't, s', categories: [] }, y: { label: 'x, px', categories: [] }, series: [{ name: 'a', x: [1], y: [2], y_low: [], x_low: [], x_high: [] }] }] }, ...more });
const result = { title: 'Study of rest: (α) ', subtitle: 'What it is', judgement: 'no rule is broken', verdict: { broken: [], text: ['A heading', 'A sentence that ends.', small, 'x'.repeat(60), small] },
  tables: [small, cut], figures: [figure('First'), figure('Second', { remarks: [] }), figure('Third', { suffix: '' })], origin: { built_by: 'g++', sweep: '{"members": 2}' } };
const bare = { title: '', subtitle: '', judgement: '', verdict: { broken: [], text: [] }, tables: [], figures: [], origin: {} };

/** Each element on a line: its name, attributes, and its own text. */
const outline = (each, indent = '') => [`${indent}${each.tagName.toLowerCase()}${Object.entries(each.attributes).map(([name, value]) => ` ${name}="${value}"`).join('')}${each.tabIndex === 0 ? ' tabindex' : ''}`,
  ...each.childNodes.flatMap(child => (child instanceof Element ? outline(child, `${indent}  `) : child ? [`${indent}  ${child}`] : []))];
async function shown(...results) {
  Object.assign(report, { command: 'report a.h5', program: 'hyrax-sim 1', results });
  found['.picture'].forEach(picture => delete picture.parentElement);
  await showResults();
  return element('results');
}

test('a page of a study is the one approved', async () => {
  const text = `${outline(await shown(result)).join('\n')}\n`, path = new URL('pictures/study.txt', import.meta.url);
  if (process.env.HYRAX_APPROVE) writeFileSync(path, text);
  assert.equal(text, readFileSync(path, 'utf8'));
  assert.deepEqual([document.title, document.documentElement.dataset.replay, document.documentElement.dataset.ready], ['Study of rest: (α)  · hyrax-sim report', 'none', '']);
});

test('figures and tables are saved under their names, and shown as data once', async () => {
  const page = await shown({ ...result, figures: [] }, result), details = page.querySelectorAll('details');
  saved.length = 0;
  for (const button of page.querySelectorAll('button')) button.click();
  assert.deepEqual(saved.map(([name]) => name), ['study-of-rest-1-speeds.csv', 'study-of-rest-1-rows.csv', 'study-of-rest-2-figure-1-all.csv', 'study-of-rest-2-figure-2-all.csv', 'study-of-rest-2-figure-3.csv',
    'study-of-rest-2-speeds.csv', 'study-of-rest-2-rows.csv']);
  assert.deepEqual([saved[1][1], saved[2][1]], ['step\n0\n1\n', 'series,"t, s","x, px"\na,1,2\n']);
  for (let again = 0; again < 2; ++again) details[2].fire('toggle');
  assert.deepEqual(details[2].children.map(({ textContent }) => textContent), ['Data as a table', 'seriest, sx, pxa12']);
  assert.equal((await shown({ ...result, figures: result.figures.slice(1) })).querySelector('nav'), null); // Of two figures.
  const many = { ...cut, row_count: 501, columns: [{ name: 'step', values: Array.from({ length: 501 }, (_, i) => i) }] };
  assert.equal((await shown({ ...bare, tables: [many] })).querySelectorAll('tr').length, 501); // With its head.
});

test('several results have numbers, and what is broken is counted', async () => {
  const page = await shown(bare, { ...bare, title: 'B', verdict: { broken: ['one', 'two'], text: [] } });
  assert.deepEqual(page.children.map(({ id, children }) => [id, ...children.map(({ tagName, attributes }) => attributes.class ?? tagName)]), [['result-1', 'HEADER', 'origin'], ['b-2', 'HEADER', 'verdict bad', 'origin']]);
  assert.deepEqual(page.querySelectorAll('.verdict').map(({ textContent }) => textContent), ['2 rules do not holdonetwo']);
  assert.deepEqual(['h1', 'h2'].map(tag => page.querySelectorAll(tag).map(({ textContent }) => textContent)), [[''], ['How it was made', 'B', 'How it was made']]);
  const more = [];
  await showResults(async ({ title }, article) => more.push([title, article.id]));
  assert.deepEqual([more, document.title], [[['', 'result-1'], ['B', 'b-2']], ', B · hyrax-sim report']);
});

test('what cannot be shown leaves the rest', async t => {
  t.mock.method(console, 'warn', () => {});
  const page = await shown({ ...result, verdict: { broken: [], text: [{}] }, tables: [{ ...cut, columns: null }], figures: [] });
  assert.deepEqual(page.querySelectorAll('.empty').map(({ textContent }) => textContent), ['The verdict', 'This table'].map(what => `${what} cannot be shown: its data is not as hyrax-sim writes it.`));
});

test('the pointer lights a series in all pictures', async () => {
  await shown(result);
  const dim = target => (windowEvents.fire('pointerover', { target }), series.map(({ classes }) => classes.includes('dim')));
  assert.deepEqual([series[0].firstChild, series[1], element('results')].map(dim), [[false, true, false], [true, false, true], [false, false, false]]);
  windowEvents.fire('focusin', { target: series[1] });
  assert.equal(series[0].classes.includes('dim'), true);
});

test('a table that is too wide folds its rows, and takes the whole width', async () => {
  const page = await shown(result), [findings] = page.querySelectorAll('.findings'), tables = findings.querySelectorAll('.table');
  const fitted = (...widths) => (widths.forEach((width, i) => (tables[i].scrollWidth = width)), windowEvents.fire('resize'), [findings, ...tables].map(({ attributes }) => attributes.class));
  assert.deepEqual(fitted(201, 201), ['findings columns-2', 'table', 'table']); // In 200 px, but for a rounding.
  assert.deepEqual(fitted(202, 0), ['findings columns-2 one-column', 'table folded', 'table']);
  assert.deepEqual(fitted(0, 0), ['findings columns-2', 'table', 'table']);
});
