// A file of the reader's own: read, confirmed, cropped, fitted, saved.
import {areas, color, colorOfModel, figure, handle, line, marks, pngOf, shown, svgOf} from './charts.js';

const $ = id => document.getElementById(id);
const escape = text => text.replace(/[&<>"]/g, c => ({'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;'})[c]);
const list = sentences => sentences.map(one => `<li>${escape(one)}</li>`).join('');
const inBrackets = (name, unit) => unit ? `${name} (${unit.replace('^2', '²')})` : name;

/// "4,7-9" of line numbers.
function ranges(lines) {
  const parts = [];
  for (const n of [...lines].sort((x, y) => x - y)) {
    const last = parts.at(-1);
    if (last && n === last[1] + 1) last[1] = n;
    else parts.push([n, n]);
  }
  return parts.map(([first, last]) => first === last ? `${first}` : `${first}-${last}`).join(',');
}

export class Experiment {
  constructor(engine, models) {
    this.engine = engine;
    this.models = models;
    this.fitFigure = figure('chart-fit', {x: {name: 'T', min: 0}, y: {name: 'A', min: 0}});
    this.runFigure = figure('chart-run', {x: {name: 'point'}, y: {name: 'T'}, y2: {name: 'A'}}, {grid: {right: 62}});
    this.fitFigure.resized = this.runFigure.resized = () => this.placeHandles();
    const drop = $('drop');
    $('file').addEventListener('change', event => {
      const files = [...event.target.files];
      this.open(files).then(() => { event.target.value = ''; });
    });
    for (const [name, over] of [['dragover', true], ['dragleave', false], ['drop', false]])
      document.addEventListener(name, event => {
        event.preventDefault();
        drop.classList.toggle('over', over);
        if (name === 'drop') this.open([...event.dataTransfer.files]);
      });
    $('constants').addEventListener('submit', event => { event.preventDefault(); this.readAgain(true); });
    $('columns').addEventListener('change', () => this.readAgain(true));
    for (const box of document.querySelectorAll('input[name=model]')) box.addEventListener('change', () => this.whole && this.fit());
    $('run').addEventListener('change', () => this.drawRun());
    for (const id of ['crop-first', 'crop-last'])
      $(id).addEventListener('change', () => this.crop(id === 'crop-first' ? 0 : 1, $(id).value === '' ? NaN : Math.round(Number($(id).value)) - 1));
    for (const button of document.querySelectorAll('[data-save]')) button.addEventListener('click', () => this.save(button.dataset.save));
  }

  /// Files as a browser gives them: one of data, and perhaps its TOML.
  async open(files) {
    if (!files.length) return;
    const bytes = await Promise.all(files.map(async file => ({name: file.name, bytes: new Uint8Array(await file.arrayBuffer())})));
    const data = bytes.filter(file => !/\.toml$/i.test(file.name));
    if (data.length !== 1) return this.trouble(data.length ? 'One file of data at a time: the program pools several (mixity fit run_*.csv --pool).' : 'That is a TOML alone: drop the data with it.');
    const toml = bytes.find(file => /\.toml$/i.test(file.name));
    if (toml && /^\s*data\s*=/m.test(new TextDecoder().decode(toml.bytes)))
      return this.trouble(`${toml.name} is a definition of a fit, which the program runs: mixity fit ${toml.name}. Drop the data without it.`);
    this.take(data[0], toml);
  }

  /// `stated`: constants, options and models that come with the data.
  take(data, toml, stated = {}) {
    this.name = data.name.replaceAll('/', '_');
    this.engine.write(this.name, data.bytes);
    this.engine.write(this.name.replace(/(\.[A-Za-z]\w*)?$/, '.toml'), toml ? toml.bytes : new Uint8Array());
    this.options = stated.options ?? {};
    if (stated.models) for (const box of document.querySelectorAll('input[name=model]')) box.checked = stated.models.includes(box.value);
    this.told = null;
    this.more = {};
    this.forget();
    for (const entry of [this.fitFigure, this.runFigure]) entry.showAll();
    $('columns').value = '';
    $('read').hidden = false;
    for (const field of $('constants').querySelectorAll('input:not([type=checkbox])')) {
      field.value = stated.constants?.[field.name] ?? '';
      delete field.dataset.shown;
    }
    this.more = Object.fromEntries(Object.entries(stated.constants ?? {}).filter(([name]) => !$('constants').elements[name]));
    this.readAgain(true);
  }

  /// Nothing of what was fitted stays on the page.
  forget() {
    clearTimeout(this.fitting);
    this.result = null;
    this.whole = false;
    this.kept = [];
    $('told').innerHTML = $('run').innerHTML = $('busy').textContent = $('caption-fit').textContent = '';
    $('downloads').hidden = $('others').hidden = $('crop').hidden = true;
    for (const entry of [this.fitFigure, this.runFigure]) {
      entry.draw([], 'Nothing is drawn', {legend: {data: []}});
      entry.chart.setOption({graphic: []}, {replaceMerge: ['graphic']});
    }
  }

  trouble(sentence) {
    $('read').hidden = false;
    $('trouble').textContent = sentence;
    $('trouble').hidden = !sentence;
  }

  constants() {
    const stated = {...this.more};
    for (const field of $('constants').querySelectorAll('input:not([type=checkbox])')) if (field.value.trim()) stated[field.name] = field.value === field.dataset.shown ? field.dataset.exact : field.value.trim();
    const columns = $('columns').value.trim();
    return columns ? {...stated, columns} : stated;
  }

  /// Reads the file with what the form says, shows how, and fits.
  readAgain(andFit) {
    this.trouble('');
    try {
      this.told = this.engine.read(this.name, this.constants());
    } catch (error) {
      this.forget();
      return this.notRead(error.message);
    }
    const {told} = this;
    this.whole = true;
    for (const [name, text] of Object.entries(told.constants)) {
      const field = $('constants').elements[name];
      if (!field) this.more[name] = text.exact;  // of a TOML: what is saved must hold it, too
      if (!field || field.value) continue;
      field.value = field.dataset.shown = text.shown;
      field.dataset.exact = text.exact;
    }
    this.showRead(true);
    const lines = JSON.stringify(told.runs?.map(run => run.lines));
    if (lines !== this.lines || !this.kept.length) this.kept = told.runs ? told.runs.map(run => [0, run.lines.length - 1]) : [];
    this.lines = lines;
    const selected = this.selected();
    $('run').innerHTML = (told.runs ?? []).map((run, i) => `<option value="${i}">${escape(run.name || `P = ${shown(run.P)}`)}</option>`).join('');
    if (selected < this.kept.length) $('run').value = String(selected);
    $('crop').hidden = !told.runs;
    this.drawPoints();
    this.drawRun();
    if (andFit) this.fit();
  }

  /// Where only the constants are missing the columns are shown all the same.
  notRead(sentence) {
    this.told = null;
    this.trouble(sentence);
    try {
      this.told = this.engine.read(this.name, {radius: '1 mm', modulus: '1 MPa', toughness: '1 J/m^2', ...this.constants()});
    } catch (error) {
      this.trouble(error.message);
      $('mapping').open = /column|header|quantity/.test(error.message);
      $('read-title').textContent = this.name;
      $('taken').innerHTML = '';
      return;
    }
    this.showRead(false);
    this.trouble(`${sentence}: fill in the sphere and the constants above, with their units, and press Fit.`);
    $('constants').querySelector('input:placeholder-shown')?.focus();
  }

  showRead(whole) {
    const {told} = this;
    $('read-title').textContent = `${this.name}: ${told.points} of ${told.rows} rows${told.runs ? `, ${told.runs.length} run${told.runs.length === 1 ? '' : 's'}` : ''}`;
    const sentences = told.notice ? [told.notice] : [];
    sentences.push(...told.taken);
    if (told.reading) sentences.push(`read as ${told.reading}`);
    if (told.runs) sentences.push(`loads in ${told.units.force || 'no unit'}, areas in ${told.units.area || 'no unit'}`);
    if (told.ignored.length) sentences.push(`not used: ${told.ignored.join(', ')}`);
    if (whole) sentences.push(...told.notes);
    for (const [name, text] of Object.entries(whole ? told.constants : {})) if (!$('constants').elements[name]) sentences.push(`${name} = ${text.shown}`);
    if (whole) for (const one of told.excluded) sentences.push(`line ${one.line} left out: ${one.reason}`);
    if (whole && told.excluded_count > told.excluded.length) sentences.push(`and ${told.excluded_count - told.excluded.length} more lines`);
    $('taken').innerHTML = list(sentences);
  }

  chosen() {
    return [...document.querySelectorAll('input[name=model]:checked')].map(box => box.value);
  }

  /// After a word that it takes a while, which the browser must have shown.
  fit() {
    clearTimeout(this.fitting);
    if (!this.whole) return;
    if (!this.chosen().length) return this.trouble('Choose a model.');
    $('busy').textContent = 'Fitting …';
    this.fitting = setTimeout(() => this.fitNow(), 30);
  }

  fitNow() {
    const models = this.chosen();
    const out = [];
    (this.told.runs ?? []).forEach((run, i) => run.lines.forEach((n, k) => { if (k < this.kept[i][0] || k > this.kept[i][1]) out.push(n); }));
    const options = {...this.options, models: models.join(',')};
    if (out.length) options.exclude = [this.options.exclude, ranges(out)].filter(Boolean).join(',');
    const begin = performance.now();
    try {
      this.result = this.engine.fit(this.name, this.constants(), options);
    } catch (error) {
      this.result = null;
      $('told').innerHTML = $('busy').textContent = '';
      $('downloads').hidden = $('others').hidden = true;
      return this.trouble(error.message);
    }
    $('busy').textContent = '';
    this.time = performance.now() - begin;
    this.trouble('');
    this.showAnswer();
    this.drawPoints();
    this.drawRun();
    this.tellModels();
  }

  showAnswer() {
    const {answer, fits} = this.result;
    const bar = answer.budget.length ? `<p>What the error comes from:</p><div class="bar" role="img" aria-label="${answer.budget.map(([name, part]) => `${name} ${shown(100 * part, 2)} %`).join(', ')}">` +
      answer.budget.map(([, part], i) => `<span style="--part:var(--color-${i + 1});flex:${part}"></span>`).join('') + '</div><p class="key">' +
      answer.budget.map(([name, part], i) => `<span style="--part:var(--color-${i + 1})">${escape(name)} ${shown(100 * part, 2)} %</span>`).join(' ') + '</p>' : '';
    const table = answer.jumps.length ? '<div class="scroll"><table class="jumps"><caption>Where the contact jumps, ± one standard error</caption><thead><tr>' + answer.jumps[0].map(cell => `<th scope="col">${escape(cell)}</th>`).join('') + '</tr></thead><tbody>' +
      answer.jumps.slice(1).map(row => `<tr>${row.map(cell => `<td>${escape(cell)}</td>`).join('')}</tr>`).join('') + '</tbody></table></div>' : '';
    $('told').innerHTML = `<p class="result">${escape(answer.result || `No value was found${fits.datasets[0].fits[0].message ? `: ${fits.datasets[0].fits[0].message}` : ''}`)}</p><p>${escape(answer.model)}</p><p>${escape(answer.interval)}</p>` +
      (answer.doubt ? `<p class="banner"><strong class="alert">${escape(answer.doubt)}</strong></p>` : answer.result ? '<p>Status: ok, its tests found nothing amiss.</p>' : '') + bar + table +
      (answer.cannot_say.length ? `<h3>What the data cannot say</h3><ul>${list(answer.cannot_say)}</ul>` : '');
    const compared = Object.fromEntries((fits.datasets[0].comparison ?? []).map(one => [one.model, one]));
    $('models').innerHTML = '<table class="fits"><thead><tr><th>model</th><th>parameters</th><th>status</th><th>AICc weight</th></tr></thead><tbody>' + fits.datasets[0].fits.map(fit => {
      const values = Object.entries(fit.parameters).map(([name, p]) => `${name.replace('lambda', 'λ')} = ${p.value === null ? 'unknown' : shown(p.value, 5)}${p.stderr ? ` ± ${shown(p.stderr, 2)}` : ''}${p.unit ? ` ${p.unit}` : ''}`);
      const weight = compared[fit.model]?.weight ?? compared[fit.model]?.akaike_weight;
      return `<tr><th scope="row">${fit.model}</th><td data-label="parameters">${values.map(v => `<div>${escape(v)}</div>`).join('')}</td><td data-label="status">${escape(fit.status)}${fit.message ? `: ${escape(fit.message)}` : ''}</td><td data-label="AICc weight">${weight === undefined || weight === null ? '' : shown(weight, 3)}</td></tr>`;
    }).join('') + '</tbody></table>';
    $('downloads').hidden = $('others').hidden = false;
  }

  /// Sets the sliders below to what was found.
  tellModels() {
    const {contact} = this.result.drawn, values = {};
    if (contact) Object.assign(values, {R: contact.radius * 1e3, E: contact.modulus * 1e-6, G: contact.toughness * 1e3});
    for (const fit of this.result.fits.datasets[0].fits) if (fit.parameters.lambda?.value > 0) values[fit.model] = fit.parameters.lambda.value;
    this.models.take(values);
  }

  drawPoints() {
    const {told} = this, best = this.result?.drawn.models[0], series = [];
    if (!this.whole) return;
    if (!told.runs) return this.drawEnergies(best);
    const {force, area} = told.units;
    told.runs.forEach((run, i) => {
      const own = color(i % 7), [first, last] = this.kept[i], fitted = best?.runs.find(one => Math.abs(one.P - run.P) <= 1e-9 * Math.abs(run.P));
      const name = inBrackets(`P = ${shown(run.P)}`, '');
      const hover = k => `line ${run.lines[k]}, ${escape(run.name || name)}<br>T = ${shown(run.T[k], 5)}, A = ${shown(run.A[k], 5)}`;
      const points = run.T.map((T, k) => ({value: [Math.abs(T), run.A[k]], hover: hover(k), k}));
      series.push(marks(`points-${i}`, name, points.filter(p => p.k >= first && p.k <= last), own, 'circle', {symbolSize: 6}));
      series.push(marks(`out-${i}`, name, points.filter(p => p.k < first || p.k > last), color(7), 'circle', {symbolSize: 5, itemStyle: {color: color(7), opacity: .5}}));
      if (!fitted) return;
      series.push(line(`curve-${i}`, name, fitted.curve, own), line(`unstable-${i}`, name, fitted.unstable, own, 'dashed'), marks(`jump-${i}`, name, fitted.folds, own, 'triangle', {symbolSize: 11}));
      if (fitted.band.length > 1) {
        const [band] = areas([{name, outline: [...fitted.band.map(([T, low]) => [T, low]), ...[...fitted.band].reverse().map(([T, , high]) => [T, high])], color: own, opacity: .3}]);
        series.push({...band, id: `band-${i}`});
      }
    });
    this.fitFigure.draw(series, `Measured areas of ${told.runs.length} runs against tangential load${best ? ` and model ${best.model}` : ''}`,
      {legend: {data: told.runs.map(run => `P = ${shown(run.P)}`)}, xAxis: {name: inBrackets('T', force), type: 'value', min: 0, max: null}, yAxis: {name: inBrackets('A', area), min: 0, max: null}});
    $('caption-fit').textContent = best ? `${this.told.notice ? 'Reconstructed' : 'Measured'} areas, and model ${best.model} with a band of one standard error; triangles mark its jumps. Grey points are left out. Shift and the wheel zoom, a double click shows all.` : `${this.told.notice ? 'Reconstructed' : 'Measured'} areas.`;
    this.placeHandles();
  }

  drawEnergies(best) {
    const {psi, f} = this.told.energies;
    const series = [marks('points', this.told.notice ? 'reconstructed' : 'measured', psi.map((x, i) => [x, f[i]]), color(0), 'circle')];
    const most = 1.5 * Math.max(...f);
    for (const model of this.result?.drawn.models ?? []) series.push(line(`law-${model.model}`, `model ${model.model}`, model.toughness.filter(([, y]) => y <= most), color(colorOfModel[model.model] ?? 4), model === best ? 'solid' : 'dashed'));
    this.fitFigure.draw(series, 'Measured toughness against phase angle, and the models',
      {legend: {data: series.map(one => one.name)}, xAxis: {name: 'ψ (rad)', min: 0, max: 1.58}, yAxis: {name: 'Gc/GIc', min: 0, max: null}});
    this.fitFigure.chart.setOption({graphic: []}, {replaceMerge: ['graphic']});
    $('caption-fit').textContent = `${this.told.notice ? 'Reconstructed' : 'Measured'} toughness and the laws of the models.`;
  }

  selected() {
    return Number($('run').value || 0);
  }

  drawRun() {
    const run = this.told?.runs?.[this.selected()];
    if (!run) return;
    const [first, last] = this.kept[this.selected()], {force, area} = this.told.units;
    $('crop-first').value = first + 1;
    $('crop-last').value = last + 1;
    $('crop-first').max = $('crop-last').max = run.T.length;
    const style = (k, own) => k < first || k > last ? {color: color(7), borderColor: color(7), opacity: .5} : {color: 'transparent', borderColor: own};
    const series = (id, name, values, own, axis, symbol) => marks(id, name, values.map((y, k) => ({value: [k + 1, y], itemStyle: style(k, own), hover: `line ${run.lines[k]}<br>${name} = ${shown(y, 5)}`})), own, symbol, {yAxisIndex: axis, symbolSize: 6});
    this.runFigure.draw([series('T', inBrackets('T', force), run.T, color(1), 0, 'rect'), series('A', inBrackets('A', area), run.A, color(2), 1, 'circle')],
      `Tangential load and area of run ${run.name} point by point`,
      {legend: {data: [inBrackets('T', force), inBrackets('A', area)]}, xAxis: {name: 'point, in the order of the file', min: 0, max: run.T.length + 1},
        yAxis: [{name: inBrackets('T', force)}, {name: inBrackets('A', area)}]});
    this.placeHandles();
  }

  /// Two on the run, one for its end on the figure of all runs.
  placeHandles() {
    const run = this.told?.runs?.[this.selected()];
    if (!run || !this.kept?.length) return;
    const [first, last] = this.kept[this.selected()];
    // of points at the same T that which is nearer to where the run ended
    const off = (k, T) => Math.abs(Math.abs(run.T[k]) - T) + 1e-9 * Math.abs(T) * Math.abs(k - last);
    const nearest = T => run.T.reduce((best, _, k) => off(k, T) < off(best, T) ? k : best, last);
    this.runFigure.chart.setOption({graphic: [handle(this.runFigure, 'first', first + .5, x => this.crop(0, Math.round(x - .5))), handle(this.runFigure, 'last', last + 1.5, x => this.crop(1, Math.round(x - 1.5)))]});
    this.fitFigure.chart.setOption({graphic: [handle(this.fitFigure, 'last', Math.abs(run.T[last]), T => this.crop(1, nearest(T)))]});
  }

  crop(end, k) {
    const run = this.selected(), kept = this.kept[run];
    if (!kept) return;
    const most = this.told.runs[run].T.length - 1;
    kept[end] = Math.min(Math.max(Number.isFinite(k) ? k : kept[end], end === 0 ? 0 : kept[0]), end === 0 ? kept[1] : most);
    this.fit();
    this.drawPoints();
    this.drawRun();
  }

  async save(what) {
    if (!this.result) return;
    const stem = this.name.replace(/\.[^.]*$/, '');
    const files = {
      used: () => [`${stem}_used.csv`, 'text/csv', this.result.used],
      fit: () => [`${stem}_fit.json`, 'application/json', JSON.stringify(this.result.fits, null, 2) + '\n'],
      toml: () => [`${stem}_fit.toml`, 'application/toml', this.result.definition],
      svg: () => [`${stem}.svg`, 'image/svg+xml', svgOf(this.fitFigure)],
      png: async () => [`${stem}.png`, 'image/png', await pngOf(this.fitFigure)],
    };
    const [name, type, content] = await files[what]();
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([content], {type}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}
