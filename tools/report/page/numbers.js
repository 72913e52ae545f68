// Numbers for people, by the rules of sim/result/number_text.h.

/** `digits` significant digits, without needless zeros: 1,234.5, 3.2e−12. */
export function rounded(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (typeof value === 'string' || !Number.isFinite(value)) return String(value);
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-3) return value.toExponential(Math.min(digits, 2) - 1).replace('.0e', 'e').replaceAll('-', '−').replace('e+', 'e');
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return grouped(value, Math.min(decimals, 8));
}

/** 11,400.5, with a minus sign. */
export const grouped = (value, decimalsMax, decimalsMin = 0) =>
  value.toLocaleString('en', { maximumFractionDigits: decimalsMax, minimumFractionDigits: decimalsMin }).replace('-', '−');

/** A fixed number of decimals, so that a value that changes keeps its width. */
export function fixed(value, decimals) {
  if (!Number.isFinite(value)) return '–';
  if (Math.abs(value) >= 1e9) return value.toExponential(3).replace('-', '−').replace('e+', 'e');
  return grouped(value, decimals, decimals).replace(/^−(?=[0.]*$)/, '');
}

export const count = (number, noun) => `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;

/** What is said where only the first are shown; empty where all are. */
export const firstOf = (shown, all, more = '') => (shown < all ? `The first ${shown.toLocaleString('en')} of ${all.toLocaleString('en')}${more}.` : '');

/** As JSON reads it back to the same bits. */
export const exact = value => (Object.is(value, -0) ? '-0.0' : String(value));
