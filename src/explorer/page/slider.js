// A slider with a field for its value.
import {shown} from './charts.js';

/// Adds a slider to `form`. `quantity`: {label, unit, low, high, logarithmic}; `tint`: the colour of its model, if any.
/// get() returns the value; set(value) receives a new one from slider or field, null if the field is not a number.
export function slider(form, id, {label, unit = '', low, high, logarithmic}, {tint, get, set, parse = Number}) {
  const box = document.createElement('div');
  box.className = tint === undefined ? 'slider' : 'slider model';
  if (tint !== undefined) box.style.setProperty('--own', `var(--color-${tint})`);
  box.innerHTML = `<label for="${id}">${label.replace('_Ic', '<sub>Ic</sub>')}</label>
    <span class="value"><input type="number" step="any" aria-label="${label}${unit && ` in ${unit}`}"> ${unit}</span>
    <input type="range" id="${id}" min="0" max="1000" step="1">`;
  const [number, range] = [box.querySelector('input[type=number]'), box.querySelector('input[type=range]')];
  const share = value => (logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low));
  const at = part => (logarithmic ? low * (high / low) ** part : low + (high - low) * part);
  const show = () => {
    number.value = shown(get(), 5);
    range.value = 1000 * share(get());
    range.setAttribute('aria-valuetext', `${shown(get())} ${unit}`);
  };
  const take = value => {
    if (value !== null) set(Number(value.toPrecision(6)));
    show();
  };
  range.addEventListener('input', () => take(at(range.value / 1000)));
  number.addEventListener('change', () => take(parse(number.value)));
  form.append(box);
  show();
  return {box, show};
}
