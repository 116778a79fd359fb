// The state of the sliders, which is stored in the page's address.

/// The quantities and the ranges of their sliders; λ ends where its model does. Loads in mN, R in mm, E* in MPa, G_Ic in mJ/m^2.
export const quantities = [
  {key: 'P', label: 'normal load P', unit: 'mN', low: -1, high: 20, value: 4},
  {key: 'T', label: 'tangential load T', unit: 'mN', low: 0, high: 300, value: 60},
  {key: 'R', label: 'sphere radius R', unit: 'mm', low: .01, high: 100, value: 9.42, logarithmic: true},
  {key: 'E', label: 'modulus E*', unit: 'MPa', low: .01, high: 1000, value: 2.133, logarithmic: true},
  {key: 'G', label: 'toughness G_Ic', unit: 'mJ/m²', low: .1, high: 10000, value: 27, logarithmic: true},
  {key: 'a', label: 'λ of model a', low: 1e-5, high: 1, value: .15, logarithmic: true, model: true},
  {key: 'b', label: 'λ of model b', low: 1e-5, high: 2, value: .03, logarithmic: true, model: true},
  {key: 'c', label: 'λ of model c', low: 1e-5, high: 1, value: .0023, logarithmic: true, model: true},
];

/// A text as a value of this quantity; null if it is not one, or beyond a thousand times the slider's range.
export function valid(q, text) {
  const value = Number(text), span = Math.max(Math.abs(q.low), q.high);
  if (text === null || text.trim() === '' || !Number.isFinite(value)) return null;
  if (q.model) return value > 0 && value <= q.high ? value : null;
  if (q.logarithmic) return value >= 1e-3 * q.low && value <= 1e3 * q.high ? value : null;
  return Math.abs(value) <= 1e3 * span ? value : null;
}

/// Whether the slider of a parameter is logarithmic.
export const byDecades = ({lower, upper}) => lower > 0 && upper > 20 * lower;

let known = location.hash;  // the address as this page read or wrote it last

export function read() {
  const state = {off: new Set()};
  known = location.hash;
  const stated = new URLSearchParams(location.hash.slice(1));
  for (const q of quantities) {
    state[q.key] = valid(q, stated.get(q.key)) ?? q.value;
  }
  for (const key of (stated.get('without') ?? '').split('')) state.off.add(key);
  state.law = stated.get('law') ?? '';
  state.own = (stated.get('own') ?? '').split(',').filter(Boolean).map(Number);
  state.held = stated.get('held') === '1';  // whether the held approach is drawn, too
  state.map = ['a', 'b', 'c', ...(state.law ? ['own'] : [])].includes(stated.get('map')) ? stated.get('map') : 'b';
  state.over = stated.get('over') ?? '';  // the parameter on the map's axis
  return state;
}

/// Writes the address, unless the user has just changed it, which must then be read first.
export function write(state) {
  if (location.hash !== known) return;
  const stated = new URLSearchParams();
  for (const q of quantities) stated.set(q.key, String(state[q.key]));
  if (state.off.size) stated.set('without', [...state.off].sort().join(''));
  if (state.held) stated.set('held', '1');
  stated.set('map', state.map);
  if (state.law) {
    stated.set('law', state.law);
    stated.set('own', state.own.join(','));
    if (state.map === 'own') stated.set('over', state.over);
  }
  history.replaceState(null, '', '#' + stated);
  known = location.hash;
}
