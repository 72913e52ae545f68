// A table {name, long_name, row_count, columns: [{name, unit, digits, values}]} on the page.
import { make } from './document.js';
import { firstOf, rounded } from './numbers.js';

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
  const names = columns.map(column => [column.name.replaceAll('_', ' '), column.unit && column.unit !== '1' ? column.unit.replaceAll('2', '²') : '']);
  const head = make('tr', {}, ...columns.map((column, i) => make(column.name ? 'th' : 'td', { scope: column.name ? 'col' : null, class: kinds[i], title: column.long_name || null },
    names[i][0], names[i][1] && make('span', { class: 'unit' }, names[i][1]))));
  const lines = Array.from({ length: rows }, (_, row) => make('tr', {}, ...columns.map((column, i) =>
    make('td', { class: kinds[i], 'data-name': names[i].filter(Boolean).join(', ') }, cellText(column.values[row], column.digits)))));
  const place = make('div', { class: 'table', tabindex: '0', role: 'group', 'aria-label': table.long_name || table.name },
    make('table', {}, make('thead', {}, head), make('tbody', {}, ...lines)));
  const cut = firstOf(rows, table.row_count, ' rows; the file has all');
  return cut ? make('div', {}, place, make('p', { class: 'quiet' }, cut)) : place;
}
