// How a file was read, in sentences; a fit as HTML: the answer first, then every model.
import {shown, squared} from './charts.js';

export const escape = text => text.replace(/[&<>"]/g, c => ({'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;'})[c]);
/// λ for lambda in a sentence. Options that are typed stay: free=lambda.
const inGreek = text => text.replace(/(^|[^\w=.'-])lambda(?=(_III?)?(?![\w=]|[.']\w))/g, '$1λ');
/// A text of the engine as HTML, λ with its subscript and T^2 as T².
export const marked = text => inGreek(escape(text)).replace(/\^2(?!\d)/g, '²').replace(/λ_(III?)\b/g, 'λ<sub>$1</sub>').replace(/τ0\b/g, 'τ<sub>0</sub>');
export const list = sentences => sentences.map(one => `<li>${marked(one)}</li>`).join('');
/// The key of a law without a name is generated and not shown.
export const named = text => text.replaceAll(/(\bmodel )?\blaw_\d+\b(, law_\d+\b)?/g, 'your own law');

/// How a file was read. `whole`: with all constants known; `hidden(name)`: whether the form has no field for a constant.
export function howRead(told, from, whole, hidden) {
  const sentences = [told.notice, from].filter(Boolean);
  sentences.push(...told.taken);
  if (told.reading) sentences.push(`read as ${told.reading}`);
  if (told.runs) sentences.push(`loads in ${told.units.force || 'no unit'}, areas in ${squared(told.units.area || 'no unit')}`);
  if (told.ignored.length) sentences.push(`not used: ${told.ignored.join(', ')}`);
  if (!whole) return sentences;
  sentences.push(...told.notes);
  for (const [name, text] of Object.entries(told.constants)) if (hidden(name)) sentences.push(`${name} = ${squared(text.shown)}`);
  for (const one of told.excluded) sentences.push(`${one.where} left out: ${one.reason}`);
  if (told.excluded_count > told.excluded.length) sentences.push(`and ${told.excluded_count - told.excluded.length} more lines`);
  return sentences;
}

const percent = part => `${shown(100 * part, 2)} %`;

function budget(parts) {
  if (!parts.length) return '';
  const own = i => `--part:var(--color-${i + 1})`;
  return `<p>What the error comes from:</p>
    <div class="bar" role="img" aria-label="${parts.map(([name, part]) => `${escape(name)} ${percent(part)}`).join(', ')}">${parts.map(([, part], i) => `<span style="${own(i)};flex:${part}"></span>`).join('')}</div>
    <p class="key">${parts.map(([name, part], i) => `<span style="${own(i)}">${escape(name)} ${percent(part)}</span>`).join(' ')}</p>`;
}

function jumps([headings, ...rows]) {
  if (!rows.length) return '';
  return `<div class="scroll"><table class="jumps"><caption>Where the contact jumps, ± one standard error</caption>
    <thead><tr>${headings.map(cell => `<th scope="col">${escape(squared(cell))}</th>`).join('')}</tr></thead>
    <tbody>${rows.map(row => `<tr>${row.map(cell => `<td>${escape(cell)}</td>`).join('')}</tr>`).join('')}</tbody></table>
    ${copyHtml([headings, ...rows].map(row => row.join('\t')).join('\n'), 'the table of jumps')}</div>`;
}

/// Buttons that set what a message recommends.
export const buttonsHtml = buttons => buttons.map(one => `<button type="button" data-remedy="${escape(JSON.stringify(one))}">${escape(one.label)}</button>`).join(' ');

const copyHtml = (text, what) => `<button type="button" class="copy" data-copy="${escape(text)}" aria-label="Copy ${escape(what)}">Copy</button>`;

/// What is wrong, and what can be tried. The best model's message is the answer's doubt.
function adviceHtml({answer, advice, fits}) {
  const best = fits.datasets[0].fits.find(fit => answer.model.startsWith(`model ${fit.model},`))?.model;
  const own = advice.find(one => one.model === best), known = new Set(own?.buttons.map(({label}) => label));
  const others = advice.filter(one => answer.doubt && one !== own && one.buttons.some(({label}) => !known.has(label) && known.add(label)));
  if (!answer.doubt && !own) return '';
  const line = one => `<li>Model ${escape(one.model)}: ${marked(one.text)} <span class="remedies">${buttonsHtml(one.buttons)}</span></li>`;
  const text = answer.doubt ? `<strong class="alert">${marked(answer.doubt)}</strong>` : marked(own.text);
  return `<div class="banner doubt"><p>${text}</p>${own ? `<p class="remedies">Try: ${buttonsHtml(own.buttons)}</p>` : ''}${others.length ? `<p>The other models:</p><ul>${others.map(line).join('')}</ul>` : ''}</div>`;
}

export function answerHtml(result) {
  const {answer, fits} = result, why = fits.datasets[0].fits[0].message, doubtful = Boolean(answer.doubt);
  const status = !doubtful && answer.result ? '<p>Status: ok. The tests of the fit found nothing wrong.</p>' : '', advice = adviceHtml(result);
  return `${doubtful ? advice : ''}<p class="result">${marked(answer.result || `No value was found${why ? `: ${why}` : ''}`)}${answer.result ? ` ${copyHtml(answer.result, 'the result')}` : ''}</p>` +
    [answer.model, answer.interval].filter(Boolean).map(line => `<p>${marked(line)}</p>`).join('') + status + (doubtful ? '' : advice) + budget(answer.budget) + jumps(answer.jumps) +
    (answer.cannot_say.length ? `<h3>What the data cannot say</h3><ul>${list(answer.cannot_say)}</ul>` : '');
}

/// A table that begins with the model that describes the data best.
export function modelsHtml({fits, drawn, parameters: texts}) {
  const {comparison = [], fits: all} = fits.datasets[0], best = drawn.models.map(one => one.model);
  const place = fit => (best.includes(fit.model) ? best.indexOf(fit.model) : best.length);
  const row = fit => {
    const weight = comparison?.find(one => one.model === fit.model)?.weight;
    return `<tr><th scope="row">${escape(fit.model)}</th>
      <td data-label="parameters">${Object.entries(fit.parameters).map(([name, p], i) => `<div>${marked(texts[fit.model][i])}${p.value === null ? '' : ` ${copyHtml(`${p.value}\t${p.stderr ?? ''}`, `${name} of model ${fit.model} with all digits and its standard error`)}`}</div>`).join('')}</td>
      <td data-label="status">${escape(fit.status)}${fit.message ? `: ${marked(fit.message)}` : ''}</td>
      <td data-label="AICc weight">${typeof weight !== 'number' ? '' : weight < 1e-4 ? '&lt; 0.0001' : shown(weight, 3)}</td></tr>`;
  };
  return `<table class="fits"><thead><tr><th>model</th><th>parameters</th><th>status</th><th>AICc weight</th></tr></thead>
    <tbody>${[...all].sort((one, other) => place(one) - place(other)).map(row).join('')}</tbody></table>`;
}
