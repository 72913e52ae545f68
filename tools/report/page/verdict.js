// The verdict as plain values: tiles that say first what a reader wants to know.
import { walls } from './data.js';
import { count, rounded } from './numbers.js';

const tile = (label, value, note, state = '') => ({ label, value, note, state });

function goldenTile(golden) {
  if (!golden) return tile('Golden file', 'not compared', 'report --against GOLDEN.h5 compares');
  if (golden.agrees) return tile('Golden file', 'agrees', `${count(golden.rows_compared, 'row')}, bit for bit`, 'good');
  return tile('Golden file', 'differs', differenceText(golden), 'bad');
}

function differenceText(golden) {
  const first = golden.first_divergence;
  const parts = [golden.class];
  if (golden.shape) parts.push(golden.shape);
  if (first) parts.push(`from step ${first.step} in ${first.field}`);
  if (golden.max_px) parts.push(`at most ${rounded(golden.max_px, 3)} px apart`);
  if (golden.contacts_moved) parts.push(`${count(golden.contacts_moved, 'contact')} ${golden.contacts_moved === 1 ? 'differs' : 'differ'}`);
  return parts.join('; ');
}

function expectTile(expectations) {
  if (expectations.length === 0) return tile('Expectations', 'none', 'the scenario has no expect');
  const held = expectations.filter(each => each.holds).length;
  const broken = expectations.find(each => !each.holds);
  return tile('Expectations', `${held} of ${expectations.length} hold`, broken ? broken.text : 'expect of the scenario', broken ? 'bad' : 'good');
}

function replayTile(result) {
  if (result.isWhatIf) return tile('Not the file’s run', 'changed here', 'Save scenario writes it');
  const label = result.file ? 'Replayed in this browser' : 'What you flung, replayed';
  const { outcome, check, run } = result;
  if (outcome === 'none') return tile(label, 'not replayed', result.reason ?? 'the scenario cannot be played here');
  const compared = run.blocks ? `${count(run.row_count, 'row')} by block hash` : `${count(result.file ? check.compared : run.row_count, 'row')} of ${(run.steps + 1).toLocaleString('en')}`;
  if (outcome === 'agrees') return tile(label, 'same bits', `${compared} and the state hash, ${rounded(result.milliseconds, 2)} ms`, 'good');
  const where = check.firstDifference === null ? 'the state hash differs; no stored row does' : `first at step ${check.firstDifference}`;
  return tile(label, 'differs', where, 'bad');
}

function errorTile(label, worst, meaning) {
  return tile(label, worst === null ? '–' : `${rounded(worst, 3)} px`, worst === null ? 'no flight arc' : meaning);
}

function bouncesTile({ contacts, bounces }) {
  const [met, bounced] = [contacts, bounces].map(counts => walls.reduce((sum, wall) => sum + counts[wall], 0));
  const parts = walls.filter(wall => bounces[wall]).map(wall => `${wall} ${bounces[wall]}`);
  if (met > bounced) parts.push(count(met - bounced, 'resting contact'));
  return tile('Bounces', String(bounced), parts.join(', ') || 'it met no wall');
}

function restTile({ result: { final, at_rest_since_s: since }, non_finite: nonFinite }) {
  if (nonFinite) return tile('Ends', 'not finite', nonFinite, 'bad');
  const place = `x ${rounded(final.x_px, 6)}, y ${rounded(final.y_px, 6)} px`;
  return since === null ? tile('Ends', 'not settled', place) : tile('Comes to rest', `after ${rounded(since, 4)} s`, place);
}

// The largest cause first; small ones are in the chart.
function driftTile({ errors, causes }) {
  const worst = errors.energy_drift_rel;
  if (worst === null) return tile('Energy drift', '–', 'no flight arc');
  const at = causes ? causes.step.length - 1 : -1;
  const parts = at < 0 ? [] : [['gravity', causes.gravity[at]], ['drag', causes.drag[at]], ['lift', causes.lift[at]], ['late bounce', causes.bounce[at]]]
    .sort(([, a], [, b]) => Math.abs(b) - Math.abs(a)).filter(([, value], _, [[, most]]) => Math.abs(value) > 0.01 * Math.abs(most));
  const sums = parts.map(([name, value]) => `${name} ${value > 0 ? '+' : ''}${rounded(value, 3)}`).join(', ');
  return tile('Energy drift', `${rounded(100 * worst, 3)} %`, sums ? `largest of an arc; in all ${sums} px` : 'largest of a flight arc');
}

/** Sentences on what went wrong, tiles of verdicts and tiles of figures; a tile is {label, value, note, state}. */
export function verdictOf(result) {
  const { run } = result;
  const { errors } = run;
  const difference = run.golden && !run.golden.agrees ? `Differs from the golden file: ${differenceText(run.golden)}` : '';
  return {
    causes: [run.non_finite && `${run.non_finite}; the run ended there`, difference].filter(Boolean),
    verdicts: [replayTile(result), ...(result.file ? [goldenTile(run.golden), expectTile(run.expect)] : [])],
    figures: [
      bouncesTile(run.result),
      restTile(run),
      ...(errors ? [errorTile('Implementation error', errors.implementation_px, 'from the exact solution of its step'),
        errorTile('Truncation error', errors.truncation_px, 'from the ODE at this frame rate'),
        errorTile('Model error', errors.model_px, 'from the ODE with the drag of 60 Hz'),
        driftTile({ errors, causes: result.causes })] : []),
    ],
  };
}
