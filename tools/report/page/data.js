// Arrays of numbers, as hyrax-sim writes them into the page.

export function bytes(base64) {
  const text = atob(base64);
  const array = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) array[i] = text.charCodeAt(i);
  return array;
}

/** Little-endian binary64. */
export function doubles(base64) {
  const view = new DataView(bytes(base64).buffer);
  return Float64Array.from({ length: view.byteLength / 8 }, (_, i) => view.getFloat64(8 * i, true));
}

/** In the order of all lists by wall. */
export const walls = ['left', 'right', 'top', 'ground'];

export const rowFields = ['step', 't', 'dt', 'x', 'y', 'vx', 'vy', 'contact'];

export const rowsOf = run => Object.fromEntries(rowFields.map(field => [field, doubles(run.rows[field])]));

/** The contacts that the page has of the file; null where only a replay gives them. */
export const contactsIn = ({ contacts }) => contacts && Object.fromEntries(Object.entries(contacts).map(([name, values]) => [name, doubles(values)]));

/** Smallest and largest value that is known; null and null if none is. */
export function rangeOf(values) {
  let low = Infinity, high = -Infinity;
  for (let i = 0; i < values.length; ++i) { // A million in little time, which `of` takes long for.
    const value = values[i];
    if (value === null || value === undefined) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low > high ? [null, null] : [low, high];
}

// The first index whose value is past a place; values rise.
function firstPast(values, isPast) {
  let low = 0, high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (isPast(values[middle])) high = middle;
    else low = middle + 1;
  }
  return low;
}
/** The first index whose value is at least `wanted`; values rise. */
export const firstAtLeast = (values, wanted) => firstPast(values, value => !(value < wanted));
/** The last index whose value is at most `wanted`; values rise. */
export const lastAtMost = (values, wanted) => firstPast(values, value => !(value <= wanted)) - 1;
