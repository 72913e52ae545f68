// The members of a sweep: their picture, the member under the pointer, and the replay of one beside its neighbours.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import Plot, { base64, Element, element, load, saved } from './stand_in.mjs';

const [{ viridis }, { Core }, { showSweeps }, { report }] = await Promise.all(['cells', 'core', 'members', 'document'].map(load));

async function showMembers(sweep, article) {
  report.sweeps = [null, sweep];
  document.querySelectorAll = () => [null, article];
  await showSweeps();
}

// The core's flight of a record goes a step of 10 px to the right, and down.
const loaded = [], required = [], used = [];
let start = [], met = { left: 0, right: 2, top: 0, ground: 1 };
Core.start = async () => ({ requireSame: fingerprint => required.push(fingerprint), useConstants: constants => used.push([...constants]), load: record => loaded.push((start = [...record]).slice(4, 8).join(' ')), playTo() {}, contacts: () => ({ step: [1], wall: [8], x: [start[4]], y: [60] }),
  finish: () => ({ steps: 1, stateHash: 'ab', contacts: met }), errors: () => ({}), contactErrors: () => ({}), causes: () => ({}),
  rows: () => ({ step: [0, 1], t: [0, 2], x: [start[4], start[4] + 10], y: [start[5], 60], vx: [10, 10], vy: [90, 90], contact: [0, 8] }) });
element('replay').parentElement = { clientWidth: 200 };

const input = (name, place, is_grid, values) => ({ name, place, is_grid, is_seed: false, values: base64(values) });
// Every third member of 18.
const grid = { core_fingerprint: 'ab', members: base64([1, 4, 7, 10, 13, 16]), count: 18, events: [], record: base64([100, 80, 10, 20, 0, 5, 0, 0, 1, 1, 60, 0, 60, 0, 0]), scenario: '{"name":"a","start":{"x_px":0,"vx_px_per_s":0},"clock":{"rate_hz":60}}',
  inputs: [input('/start/vx_px_per_s', 6, true, [-1, -1, 0, 0, 1, 1]), input('/start/x_px', 4, true, [10, 20, 10, 20, 10, 20])],
  results: [{ name: 'final_x', unit: 'px', values: base64([1, 2, 3, 4, 5, NaN]) }, { name: 'steps', unit: '1', values: base64([9, 8, 7, 6, 5, 4]) }] };

async function shown(sweep) {
  Plot.all = [];
  const article = new Element('article');
  await showMembers(sweep, article);
  const [section] = article.children, [head, choices, bar, , hover] = section.children;
  const plot = () => (Plot.all.at(-1).redraw(), Plot.all.at(-1));
  const at = (type, x, y) => (plot().over.fire(type, { clientX: 10 + x, clientY: 20 + y }), hover.textContent);
  const choose = (key, name) => element(`members-${key}`).fire('change', { target: { value: name } });
  return { section, head, choices, bar, hover, plot, at, choose };
}

test('cells are where their numbers are, in the colours of the third', async () => {
  const { plot, head, bar, hover, choices } = await shown(grid);
  // Three columns of 400 px from the left, two lines of 200 px from the foot.
  const boxes = ['40,120 133,100', '40,20 133,100', '173,120 134,100', '173,20 134,100', '307,120 133,100', '307,20 133,100'];
  assert.deepEqual(plot().ctx.log, boxes.map((box, i) => `fill ${i < 5 ? viridis(i / 4) : 'rule'}: box ${box}`));
  assert.deepEqual([head, bar, hover].map(({ textContent }) => textContent), ['The members6 of 18 members', 'final_x, px15', 'A cell is the mean of its members. Click one to replay it.']);
  const [, gradient] = /linear-gradient\(90deg, (.*)\)$/.exec(bar.children[2].attributes.style), colors = gradient.split(', ');
  assert.deepEqual([colors[0], colors.length, colors.at(-1)], [viridis(0), 9, viridis(1)]);
  assert.deepEqual(plot().options.axes.map(({ label }) => label), ['start speed to the right, px/s', 'start, x from the left, px']);
  assert.deepEqual(choices.querySelectorAll('select').map(select => select.children.map(({ value, attributes }) => value + (attributes.selected === '' ? '!' : '')).join(' ')), [
    '/start/vx_px_per_s! /start/x_px final_x steps', '/start/vx_px_per_s /start/x_px! final_x steps', '/start/vx_px_per_s /start/x_px final_x! steps']);
  assert.match(plot().root.attributes['aria-label'], /^final_x, px over start speed to the right, px\/s and start, x from the left, px\. .*; from 1 to 5\.$/);
  assert.match((await shown({ ...grid, count: 6 })).head.textContent, /all 6 members/);
});

test('the pointer is on the member of its cell, by its number in the sweep', async () => {
  const { at, choose } = await shown(grid);
  const cell = (vx, x, value, member) => `start speed to the right, px/s ${vx}; start, x from the left, px ${x}; final_x, px ${value}; member ${member}`;
  assert.deepEqual([[1, 99], [66, 51], [1, 49], [67, 51], [199, 1]].map(([x, y]) => at('pointermove', x, y)),
    [cell('−1', 10, 1, 1), cell('−1', 10, 1, 1), cell('−1', 20, 2, 4), cell(0, 10, 3, 7), cell(1, 20, '–', 16)]);
  choose('tint', 'steps');
  assert.match(at('pointermove', 1, 99), /steps 9; member 1$/);
  assert.match((await shown({ ...grid, inputs: grid.inputs.map(each => ({ ...each, values: base64([1, 1, 2, 2, 2, 3]) })) })).at('pointermove', 1, 99), /final_x, px 1\.5; mean of 2 members$/);
});

test('points are where their numbers are, the nearest is under the pointer', async () => {
  const { at, plot, hover } = await shown({ ...grid, inputs: [input('a', 4, false, [0, 0, 0, 0, 0, 1]), input('b', 6, true, [0, 1, 2, 3, 4, 5])], results: [{ name: 'r', unit: '1', values: base64([0, 10, 20, 30, 40, 50]) }] });
  // 3 % of room on each side; the colours are those of the other input.
  const x = i => Math.round(4000 + 40000 * (i / 5 + 0.03) / 1.06) / 100, y = i => Math.round(2000 + 20000 * (1 - (i / 5 + 0.03) / 1.06)) / 100;
  assert.deepEqual(plot().ctx.log, [0, 1, 2, 3, 4, 5].map(i => `fill ${viridis(i === 5 ? 1 : 0)}: circle ${x(i)},${y(i)} r 7`));
  assert.match(hover.textContent, /^A point is a member/);
  assert.deepEqual([at('pointermove', 0, 100), at('pointermove', 20, 86), at('pointermove', 30, 80)].map(text => text.split('; ').at(-1)), ['member 1', 'member 1', 'member 4']);
  loaded.length = 0;
  at('click', 0, 100);
  assert.deepEqual(loaded, ['0 5 0 0', '0 5 1 0', '0 5 2 0', '0 5 3 0', '0 5 4 0']); // The four nearest.
  assert.equal(plot().ctx.log.at(-1), `stroke ink 5: circle ${x(0)},${y(0)} r 14`);
});

test('a click replays the member beside its neighbours, and saves it', async () => {
  const { at, section, choices } = await shown(grid);
  loaded.length = 0;
  at('click', 100, 75);
  assert.deepEqual(loaded, ['10 5 0 0', '10 5 -1 0', '20 5 0 0', '10 5 1 0']);
  assert.equal(Plot.all.at(-1).ctx.log.at(-1), 'stroke ink 5: box 173,120 134,100');
  assert.deepEqual([element('member').hidden, section.next, element('member-heading').textContent, choices.querySelector('input').value], [false, element('member'), 'Member 7', 7]);
  assert.equal(element('member-note').textContent, 'start speed to the right, px/s: 0; start, x from the left, px: 10. Ends at x 20, y 60 px after 1 steps; contacts right 2, ground 1. Thin: 3 neighbours.');
  assert.deepEqual(element('member').inView, { block: 'nearest' });
  saved.length = 0;
  element('download-member').onclick();
  assert.deepEqual(saved.map(([name, text]) => [name, JSON.parse(text)]), [['member-7.json', { format: 'hyrax-scenario/1', name: 'a', description: '', window: { width_px: 100, height_px: 80 }, sprite: { width_px: 10, height_px: 20 }, start: { x_px: 10, y_px: 5, vx_px_per_s: 0, vy_px_per_s: 0 },
    clock: { rate_hz: 60 }, steps: 60, expect: { state_hash: 'ab' } }]]);
  // Paths of the three neighbours, its own with the ground, then four of the hyrax.
  const log = element('replay').getContext().log;
  assert.deepEqual(log.slice(1, 6), ['stroke faint 2: from 60,60 100,280', 'stroke faint 2: from 100,60 140,280', 'stroke faint 2: from 60,60 100,280', 'stroke path 3: from 60,60 100,280', 'stroke orange 6: from 52,317 68,317']);
  assert.deepEqual(log.filter(line => line.includes('box') && !line.startsWith('fill')), ['stroke faint 2 of 0.4: box 40,20 40,80', 'stroke faint 2 of 0.4: box 80,20 40,80', 'stroke faint 2 of 0.4: box 40,20 40,80', 'stroke box 2: box 40,20 40,80']);
  element('forward').fire('click');
  assert.deepEqual(element('replay').getContext().log.filter(line => line.includes('of 0.4: box')), ['80,240', '120,240', '80,240'].map(at => `stroke faint 2 of 0.4: box ${at} 40,80`));
  assert.equal(element('readouts').querySelector('[data-name=row]').textContent, '1');
  const number = choices.querySelector('input');
  assert.equal(number.attributes.max, '16');
  assert.deepEqual(['10', '11', '99'].map(value => (loaded.splice(0), number.fire('change', { target: { value } }), loaded[0])), ['20 5 0 0', '10 5 1 0', '20 5 1 0']);
});

test('a choice has a panel for each value, over common axes and colours', async () => {
  const rate = { ...input('/clock/rate_hz', 10, false, [144, 60, 60, 144, 60, 60]), is_choice: true }, faceted = { ...grid, inputs: [...grid.inputs, rate] };
  const { section, choices, at, choose } = await shown(faceted), panels = () => Plot.all.slice(-2).map(plot => (plot.redraw(), plot.ctx.log));
  assert.deepEqual(section.querySelectorAll('h3').map(({ textContent }) => textContent), ['frame rate, Hz: 60', 'frame rate, Hz: 144']);
  // Each member is in its panel's place of the six cells of all, in the colour that it has among all.
  const boxes = ['40,120 133,100', '40,20 133,100', '173,120 134,100', '173,20 134,100', '307,120 133,100', '307,20 133,100'];
  const fills = rows => rows.map(i => `fill ${i < 5 ? viridis(i / 4) : 'rule'}: box ${boxes[i]}`);
  assert.deepEqual(panels(), [fills([1, 2, 4, 5]), fills([0, 3])]);
  assert.match(at('pointermove', 100, 25), /^frame rate, Hz: 144; start speed to the right, px\/s 0; .*member 10$/);
  assert.equal(at('pointermove', 100, 75), at('pointermove', 100, 25), 'nothing is there in this panel');
  loaded.length = 0;
  at('click', 100, 25);
  assert.deepEqual([loaded, panels().map(log => log.at(-1).startsWith('stroke ink'))], [['20 5 0 0'], [false, true]]); // Its neighbours are in the other panel.
  assert.deepEqual(choices.querySelectorAll('select').at(-1).children.map(({ value }) => value), ['/clock/rate_hz', '']);
  choose('panel', '');
  assert.deepEqual([section.querySelectorAll('h3').length, panels()[1].length], [0, 7]);
  const one = await shown({ ...faceted, inputs: [input('a', 4, false, [0, 1, 2, 3, 4, 5]), rate] });
  assert.deepEqual(one.plot().options.axes.map(({ label }) => label), ['a', 'final_x, px']);
  const ranges = Plot.all.slice(-2).map(({ scales }) => JSON.stringify(scales));
  assert.equal(ranges[0], ranges[1]);
  assert.equal((await shown({ ...faceted, inputs: [rate] })).section.querySelectorAll('h3').length, 0, 'nothing else is varied');
});

test('numbers that are no grids, many points and a page with figures have their places', async () => {
  const drawn = (...names) => ({ ...grid, inputs: names.map((name, i) => input(name, i, false, [0, 1, 2, 3, 4, 5])) });
  const axes = ({ plot }) => [...plot().options.axes.map(({ label }) => label), plot().root.attributes['aria-label'].split(' over')[0]];
  assert.deepEqual(axes(await shown(drawn('a'))), ['a', 'final_x, px', 'steps']);
  assert.deepEqual(axes(await shown({ ...drawn('a'), results: grid.results.slice(0, 1) })), ['a', 'final_x, px', 'final_x, px']);
  assert.deepEqual(axes(await shown(drawn('a', 'b'))), ['a', 'final_x, px', 'b']);
  for (const [points, radius] of [[800, 7], [801, 4.4]]) {
    const values = base64(Array.from({ length: points }, (_, i) => i));
    const { plot } = await shown({ ...grid, members: values, inputs: [{ ...input('a', 0, false, []), values }], results: [{ name: 'r', unit: '1', values }] });
    assert.match(plot().ctx.log[0], new RegExp(` r ${radius}$`));
  }
  met = {};
  (await shown({ ...grid, events: [{ frame: 0, kind: 'grab' }] })).at('click', 100, 75);
  assert.match(element('member-note').textContent, /; contacts none\. Thin/);
  assert.deepEqual([element('replay').getContext().log.filter(line => line.startsWith('text')), element('play').attributes['aria-label']], [['text ink: grab left 76,48'], 'Pause']);
  const article = new Element('article'), figure = new Element('figure');
  figure.setAttribute('class', 'figure');
  article.append(figure);
  for (const results of [[], grid.results]) await showMembers({ ...grid, results }, article);
  assert.deepEqual([article.children.length, figure.previous.attributes['aria-label'], required], [1, 'The members of result 2', ['ab']]);
});
