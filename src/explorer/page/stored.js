// Results that were stored as JSON, of this page or of the program, beside the fit at hand.
import {escape} from './answer.js';
import {shown} from './charts.js';

/// The result in a file; null if it holds none.
export function storedIn({name, bytes}) {
  try {
    const {schema, version, datasets} = JSON.parse(new TextDecoder().decode(bytes));
    return /^mixity-/.test(schema) && Array.isArray(datasets) && datasets.every(({fits}) => Array.isArray(fits)) ? {name, version, datasets} : null;
  } catch {
    return null;
  }
}

function valueText({value, stderr, unit}) {
  return value === null || value === undefined ? 'unknown' : `${shown(value, 5)}${stderr ? ` ± ${shown(stderr, 2)}` : ''}${unit ? ` ${unit}` : ''}`;
}

/// `result`: of the fit at hand; null if there is none.
export function storedHtml({name, version, datasets}, result) {
  const now = result?.fits.datasets[0];
  const row = (set, fit) => {
    const fitted = now && now.name === set.name ? now.fits.find(one => one.model === fit.model) : null;
    return Object.entries(fit.parameters ?? {}).map(([key, p], i) => `<tr><th scope="row">${i ? '' : escape(`${set.name}: ${fit.model}`)}</th>
      <td data-label="parameter">${escape(key.replace('lambda', 'λ'))}</td><td data-label="stored">${escape(valueText(p))}</td>
      <td data-label="now">${fitted?.parameters[key] ? escape(valueText(fitted.parameters[key])) : ''}</td><td data-label="stored status">${escape(fit.status)}</td></tr>`).join('');
  };
  return `<h3>Stored results of ${escape(name)}</h3><p class="soft">By mixity ${escape(version ?? 'of an unknown version')}.${now ? '' : ' Drop their data to fit again and compare.'}</p>
    <table class="fits"><thead><tr><th>data and model</th><th>parameter</th><th>stored</th><th>now</th><th>stored status</th></tr></thead>
    <tbody>${datasets.map(set => set.fits.map(fit => row(set, fit)).join('')).join('')}</tbody></table>`;
}
