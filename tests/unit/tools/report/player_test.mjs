// The replay's controls: what each key and button shows, at which speed it plays, where its ticks are.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { count, element, frame, load, textOf, windowEvents } from './stand_in.mjs';

const [{ Moment }, { Player, showReadouts }] = await Promise.all(['moment', 'player'].map(load));

// Every second step is recorded.
const rows = { step: count(21).map(i => 2 * i), t: count(21).map(i => i / 10) };
for (const name of ['x', 'y', 'vx', 'vy', 'contact']) rows[name] = rows.t;
const contacts = { step: [7, 12, 30], wall: [1, 2, 8] };
element('speed').value = '0.5';
Object.assign(element('ticks'), { clientWidth: 96, clientHeight: 10 }); // 80 points from one end of the slider to the other.

/** Opens at a row, does it, and says which row is shown. */
function shown(from, act, met = contacts) {
  const moment = new Moment(rows);
  moment.show(from);
  let zooms = 0;
  const player = new Player(moment, met, { inputs: [], steps: 40 }, () => ++zooms);
  act(player);
  const { index } = moment, { value } = element('time');
  player.end();
  assert.equal(value, index);
  return zooms ? `zoom ${zooms}` : index;
}
const press = (key, more) => () => windowEvents.fire('keydown', { key, target: element('replay'), ...more });

test('keys step, jump and go from contact to contact, and are left to the browser, to a list and to the playground', () => {
  for (const [key, ...places] of [['ArrowLeft', [0, 0], [5, 4], [20, 19]], ['ArrowRight', [0, 1], [19, 20], [20, 20]], ['Home', [5, 0]], ['End', [5, 20]],
    // Contacts are at steps 7, 12 and 30: shown in rows 4 (of step 8), 6 and 15.
    [']', [0, 4], [3, 4], [4, 6], [6, 15], [14, 15], [15, 15], [20, 20]], ['[', [20, 15], [16, 15], [15, 6], [6, 4], [5, 4], [0, 0], [3, 3]], ['0', [5, 'zoom 1']], ['x', [5, 5]]])
    for (const [from, to] of places) assert.equal(shown(from, press(key)), to, `${key} at row ${from}`);
  assert.deepEqual([shown(5, press('ArrowRight', { shiftKey: true })), shown(15, press('ArrowLeft', { shiftKey: true }))], [15, 5]);
  assert.deepEqual([']', '['].map(key => shown(5, press(key), null)), [5, 5]);
  for (const more of [{ ctrlKey: true }, { metaKey: true }, { altKey: true }, { target: { tagName: 'SELECT' } }, { target: { tagName: 'SUMMARY' } }])
    assert.equal(shown(5, press('End', more)), 5);
  assert.equal(shown(5, press('End', { target: { tagName: 'BUTTON' } })), 20);
  document.documentElement.dataset.mode = 'fling';
  assert.equal(shown(5, press('End')), 5);
  delete document.documentElement.dataset.mode;
  shown(5, player => player.end());
  const prevented = [];
  for (const key of ['End', 'x']) shown(5, press(key, { preventDefault: () => prevented.push(key) }));
  assert.deepEqual(prevented, ['End']);
  const isPlaying = [];
  shown(5, player => [{}, { target: { tagName: 'BUTTON' } }, {}].forEach(more => (press(' ', more)(), isPlaying.push(player.isPlaying))));
  assert.deepEqual(isPlaying, [true, true, false]);
});

test('buttons and the slider show a row, and stop the player', () => {
  const act = (id, event = 'click') => player => (player.play(), element(id).fire(event), assert.ok(!player.isPlaying));
  assert.deepEqual(['first', 'back', 'forward', 'play'].map(id => shown(5, act(id))), [0, 4, 6, 5]);
  assert.equal(shown(5, player => ((element('time').value = '9'), act('time', 'input')(player))), 9);
  assert.deepEqual([0, 7, 8, 39, 40, 41].map(step => shown(5, player => player.seekStep(step))), [0, 4, 4, 20, 20, 20]);
  assert.equal(element('time').max, 20);
  const ended = new Player(new Moment(rows), contacts, { inputs: [] }, () => {});
  ended.end();
  element('forward').fire('click');
  assert.equal(ended.moment.index, 0);
});

test('it plays as fast as chosen, to the end or again and again', () => {
  const played = (from, times, ...how) => {
    const seen = [];
    frame(1000);
    shown(from, player => (player.play(...how), times.forEach(time => (frame(1000 + time), seen.push(player.isPlaying ? player.moment.index : `${player.moment.index}, ends`)))));
    return seen;
  };
  assert.deepEqual(played(0, [50, 200, 400, 1000]), [0, 1, 2, 5]); // Half as fast as time, ten rows a second.
  assert.deepEqual(played(10, [1000, 1900, 2100]), [15, 19, '20, ends']);
  assert.deepEqual(played(20, [1000, 5000]), [5, '20, ends']);
  assert.deepEqual(played(0, [500, 1500], [4, 8], 1), [8, 8]);
  assert.deepEqual(played(6, [100, 250, 500], [4, 8], 1), [7, 8, 6]);
  const label = () => [element('play').attributes['aria-label'], element('play').attributes.class];
  shown(0, player => (player.toggle(), assert.deepEqual(label(), ['Pause', 'playing']), player.toggle(), assert.deepEqual(label(), ['Play', ''])));
});

test('ticks are where the slider has the contact, in the colour and shape of its wall', () => {
  const run = { inputs: [{ frame: 20 }], steps: 40, non_finite: 'x is NaN' };
  const draw = (met, of) => (new Player(new Moment(rows), met, of, () => {}).end(), element('ticks').getContext().log);
  // Two px for each point, 16 before step 0, four for each step; inputs half as high.
  assert.deepEqual(draw(contacts, run), ['fill ink: box 96,0 3,10', 'fill sky-blue: from 36,10 52,2 52,18', 'fill vermilion: from 72,10 56,18 56,2', 'fill orange: from 136,18 128,2 144,2',
    'fill bad: box 176,0 10,20']);
  assert.deepEqual(draw(undefined, { inputs: [], steps: 40 }), []);
});

test('the readouts are those of the row, with their units', () => {
  showReadouts({ t: 1.23456, row: 1234, x: 1.236, y: -2, vx: 1234.56, vy: NaN });
  showReadouts({ t: 1.23456, row: 1235, x: 1.236, y: -2, vx: 1234.56, vy: NaN });
  assert.deepEqual(element('readouts').children.map(each => each.children.map(({ textContent }) => textContent).join(': ')),
    ['time: 1.235 s', 'row: 1,235', 'x: 1.24 px', 'y: −2.00 px', 'vx: 1,234.6 px/s', 'vy: – px/s']);
});

test('each control has the name and the key that it says', () => {
  const html = textOf('stage.html'), names = { space: ' ', 'left arrow': 'ArrowLeft', 'right arrow': 'ArrowRight' };
  const buttons = [...html.matchAll(/id="(\w+)"[^>]* aria-label="(.*?)" title="(.*?) \((.*?)\)"/g)].map(([, ...parts]) => parts);
  assert.deepEqual(buttons.map(([id, label, title]) => [id, label, title]), [['first', 'To the start', 'To the start'], ['back', 'One step back', 'One step back'], ['play', 'Play', 'Play or pause'], ['forward', 'One step forward', 'One step forward']]);
  const plays = act => shown(5, player => (act(player), player.isPlaying && player.seek(17)));
  for (const [id, , , key] of buttons) assert.equal(plays(press(names[key] ?? key)), plays(() => element(id).fire('click')), id);
  const speeds = [...html.matchAll(/<option value="([\d.]+)"( selected)?>(.*?)×/g)].map(([, ...parts]) => parts);
  assert.deepEqual(speeds.map(([value]) => value), ['0.1', '0.25', '0.5', '1', '2', '4']);
  for (const [value, selected, text] of speeds) assert.deepEqual([text, Boolean(selected)], [value, value === '1']);
  assert.equal(/<p class="keys">(.*)<\/p>/.exec(html)[1].replace(/<[^>]*>/g, ''), 'space play ← → step, with shift ten [ ] contact 0 whole run');
  assert.match(html, /id="time"[^>]* aria-label="Row"/);
  assert.match(textOf('runs.html'), /drag in a chart to zoom/);
  assert.match(textOf('README.md').replaceAll(/\s+/g, ' '), /Space plays, the arrows step \(with shift ten steps\), `\[` and `\]` go to a contact, `0` shows the whole run\. `FILE\.html#step=120` opens at row 120\..* one zoom \(drag; double-click for the whole run\)/);
});
