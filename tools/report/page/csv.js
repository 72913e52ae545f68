// A table as CSV, and a figure's data as a table.
import { exact } from './numbers.js';

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
