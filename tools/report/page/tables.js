// A table {name, long_name, row_count, columns: [{name, unit, digits, values}]} on the page and as CSV.
import { make } from './document.js';
import { exact, rounded } from './numbers.js';

const rowsShown = 500;

const isText = column => column.values.some(value => typeof value === 'string') || column.values.length === 0;

function cellText(value, digits) {
  if (value === null) return '–';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  return typeof value === 'number' ? rounded(value, digits ?? 6) : value;
}

export function tableOf(table) {
  const { columns } = table;
  const rows = Math.min(rowsShown, columns[0]?.values.length ?? 0);
  const kinds = columns.map(column => (!isText(column) ? 'number' : column.values.every(value => String(value).length <= 36) ? 'text short' : 'text'));
  const head = make('tr', {}, ...columns.map((column, i) => make(column.name ? 'th' : 'td', { scope: column.name ? 'col' : null, class: kinds[i], title: column.long_name || null },
    column.name.replaceAll('_', ' '), column.unit && column.unit !== '1' ? make('span', { class: 'unit' }, column.unit.replaceAll('2', '²')) : '')));
  const lines = Array.from({ length: rows }, (_, row) => make('tr', {}, ...columns.map((column, i) =>
    make('td', { class: kinds[i] }, cellText(column.values[row], column.digits)))));
  const place = make('div', { class: 'table', tabindex: '0', role: 'group', 'aria-label': table.long_name || table.name },
    make('table', { class: kinds.at(-1) === 'text' ? 'prose' : null }, make('thead', {}, head), make('tbody', {}, ...lines)));
  if (rows >= table.row_count) return place;
  return make('div', {}, place, make('p', { class: 'quiet' }, `The first ${rows.toLocaleString('en')} of ${table.row_count.toLocaleString('en')} rows; the file has all.`));
}

// A text that a spreadsheet would take for a formula begins with an apostrophe.
function csvField(value) {
  if (value === null || value === undefined) return '';
  if (typeof value !== 'string') return typeof value === 'number' ? exact(value) : String(value);
  const text = /^[=+@\t\r]|^-[^\d.∞I]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

export function csvOfTable({ columns }) {
  const heads = columns.map(({ name, unit }) => csvField(unit && unit !== '1' ? `${name} (${unit})` : name));
  const lines = (columns[0]?.values ?? []).map((_, row) => columns.map(column => csvField(column.values[row])).join(','));
  return `${[heads.join(','), ...lines].join('\n')}\n`;
}

/** A figure's data as a table. */
export function tableOfFigure({ title, body }) {
  const table = (names, rows) => ({ name: title, long_name: `Data of ${title}`, row_count: rows.length, columns: names.map((name, i) => ({ name, values: rows.map(row => row[i] ?? null) })) });
  if (body.cells) return table(['row', 'column', 'text', 'colour'], body.cells.map(cell => [body.rows[cell.row], body.columns[cell.column]?.text, cell.text, cell.tone]));
  if (body.list_rows) return table(body.list_columns.map((column, i) => column.title || `column ${i + 1}`), body.list_rows.map(row => row.map(({ text, detail }) => (detail ? `${text} (${detail})` : text))));
  const value = (axis, number) => axis.categories[number] ?? number;
  const names = body.plots.length > 1 ? ['plot', 'series'] : ['series'];
  const [first] = body.plots;
  const isOneAxes = body.plots.every(plot => plot.x.label === first?.x.label && plot.y.label === first?.y.label);
  const extra = ['y_low', 'x_low', 'x_high'].filter(name => body.plots.some(plot => plot.series.some(series => series[name].length)));
  const rows = body.plots.flatMap((plot, p) => plot.series.flatMap(series => series.x.map((x, i) =>
    [...(names.length > 1 ? [isOneAxes ? p + 1 : `${plot.y.label} against ${plot.x.label}`] : []), series.name, value(plot.x, x), value(plot.y, series.y[i]), ...extra.map(name => series[name][i])])));
  return table([...names, (isOneAxes && first?.x.label) || 'x', (isOneAxes && first?.y.label) || 'y', ...extra], rows);
}
