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
    $('file').addEventListener('change', event => this.open([...event.target.files]));
    for (const [name, over] of [['dragover', true], ['dragleave', false], ['drop', false]])
      document.addEventListener(name, event => {
        event.preventDefault();
        drop.classList.toggle('over', over);
        if (name === 'drop') this.open([...event.dataTransfer.files]);
      });
    $('constants').addEventListener('submit', event => { event.preventDefault(); this.readAgain(true); });
    $('columns').addEventListener('change', () => this.readAgain(true));
    for (const box of document.querySelectorAll('input[name=model]')) box.addEventListener('change', () => this.result && this.fit());
    $('run').addEventListener('change', () => this.drawRun());
    for (const id of ['crop-first', 'crop-last']) $(id).addEventListener('change', () => this.crop(id === 'crop-first' ? 0 : 1, Number($(id).value) - 1));
    for (const button of document.querySelectorAll('[data-save]')) button.addEventListener('click', () => this.save(button.dataset.save));
  }

  /// Files as a browser gives them: one of data, and perhaps its TOML.
  async open(files) {
    if (!files.length) return;
    const bytes = await Promise.all(files.map(async file => ({name: file.name, bytes: new Uint8Array(await file.arrayBuffer())})));
    const data = bytes.filter(file => !/\.toml$/i.test(file.name));
    if (data.length !== 1) return this.trouble(data.length ? 'One file of data at a time: the program pools several (mixity fit run_*.csv --pool).' : 'That is a TOML alone: drop the data with it.');
    this.take(data[0], bytes.find(file => /\.toml$/i.test(file.name)));
  }

  /// `stated`: constants, options and models that come with the data.
  take(data, toml, stated = {}) {
    this.name = data.name.replace(/[^\w.\-]/g, '_');
    this.engine.write(this.name, data.bytes);
    this.engine.write(this.name.replace(/(\.[A-Za-z]\w*)?$/, '.toml'), toml ? toml.bytes : new Uint8Array());
    this.options = stated.options ?? {};
    if (stated.models) for (const box of document.querySelectorAll('input[name=model]')) box.checked = stated.models.includes(box.value);
    this.told = this.result = null;
    $('told').innerHTML = '';
    $('columns').value = '';
    $('read').hidden = false;
    $('downloads').hidden = $('others').hidden = true;
    for (const field of $('constants').querySelectorAll('input:not([type=checkbox])')) {
      field.value = stated.constants?.[field.name] ?? '';
      delete field.dataset.shown;
    }
    this.more = Object.fromEntries(Object.entries(stated.constants ?? {}).filter(([name]) => !$('constants').elements[name]));
    this.readAgain(true);
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
      return this.notRead(error.message);
    }
    const {told} = this;
    for (const [name, text] of Object.entries(told.constants)) {
      const field = $('constants').elements[name];
      if (!field || field.value) continue;
      field.value = field.dataset.shown = text.shown;
      field.dataset.exact = text.exact;
    }
    this.showRead(true);
    this.kept = told.runs ? told.runs.map(run => [0, run.lines.length - 1]) : [];
    $('run').innerHTML = (told.runs ?? []).map((run, i) => `<option value="${i}">${escape(run.name || `P = ${shown(run.P)}`)}</option>`).join('');
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
    this.trouble(`${sentence} — fill in what is empty below and press Fit.`);
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
    if (whole) for (const one of told.excluded) sentences.push(`line ${one.line} left out: ${one.reason}`);
    $('taken').innerHTML = list(sentences);
  }

  chosen() {
    return [...document.querySelectorAll('input[name=model]:checked')].map(box => box.value);
  }

  /// At once; with many points after a word that it takes a while.
  fit() {
    clearTimeout(this.fitting);
    if (!this.told || !this.chosen().length) return;
    if (this.told.points < 1000) return this.fitNow();
    $('told').textContent = 'Fitting …';
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
      $('told').innerHTML = '';
      return this.trouble(error.message);
    }
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
    const table = answer.jumps.length ? '<table class="jumps"><caption>Where the contact jumps, predicted</caption><thead><tr>' + answer.jumps[0].map(cell => `<th scope="col">${escape(cell)}</th>`).join('') + '</tr></thead><tbody>' +
      answer.jumps.slice(1).map(row => `<tr>${row.map(cell => `<td>${escape(cell)}</td>`).join('')}</tr>`).join('') + '</tbody></table>' : '';
    $('told').innerHTML = `<p class="result">${escape(answer.result || 'No value was found')}</p><p>${escape(answer.model)}</p><p>${escape(answer.interval)}</p>` +
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
    if (!told.runs) return this.drawEnergies(best);
    const {force, area} = told.units;
    told.runs.forEach((run, i) => {
      const own = color(i % 8), [first, last] = this.kept[i], fitted = best?.runs.find(one => Math.abs(one.P - run.P) <= 1e-9 * Math.abs(run.P));
      const name = inBrackets(`P = ${shown(run.P)}`, '');
      const hover = k => `line ${run.lines[k]}, ${run.name || name}<br>T = ${shown(run.T[k], 5)}, A = ${shown(run.A[k], 5)}`;
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
    $('caption-fit').textContent = best ? `Measured areas, and model ${best.model} with a band of one standard error; triangles mark its jumps. Grey points are left out. Shift and the wheel zoom, a double click shows all.` : 'Measured areas.';
    this.placeHandles();
  }

  drawEnergies(best) {
    const {psi, f} = this.told.energies;
    const series = [marks('points', 'measured', psi.map((x, i) => [x, f[i]]), color(0), 'circle')];
    const most = 1.5 * Math.max(...f);
    for (const model of this.result?.drawn.models ?? []) series.push(line(`law-${model.model}`, `model ${model.model}`, model.toughness.filter(([, y]) => y <= most), color(colorOfModel[model.model] ?? 4), model === best ? 'solid' : 'dashed'));
    this.fitFigure.draw(series, 'Measured toughness against phase angle, and the models',
      {legend: {data: series.map(one => one.name)}, xAxis: {name: 'ψ (rad)', min: 0, max: 1.58}, yAxis: {name: 'Gc/GIc', min: 0, max: null}});
    this.fitFigure.chart.setOption({graphic: []}, {replaceMerge: ['graphic']});
    $('caption-fit').textContent = 'Measured toughness and the laws of the models.';
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
    const nearest = T => run.T.reduce((best, value, k) => Math.abs(Math.abs(value) - T) < Math.abs(Math.abs(run.T[best]) - T) ? k : best, 0);
    this.runFigure.chart.setOption({graphic: [handle(this.runFigure, 'first', first + .5, x => this.crop(0, Math.round(x - .5))), handle(this.runFigure, 'last', last + 1.5, x => this.crop(1, Math.round(x - 1.5)))]});
    this.fitFigure.chart.setOption({graphic: [handle(this.fitFigure, 'last', Math.abs(run.T[last]), T => this.crop(1, nearest(T)))]});
  }

  crop(end, k) {
    const run = this.selected(), kept = this.kept[run], most = this.told.runs[run].T.length - 1;
    kept[end] = Math.min(Math.max(Number.isFinite(k) ? k : kept[end], end === 0 ? 0 : kept[0]), end === 0 ? kept[1] : most);
    this.fit();
    this.drawPoints();
    this.drawRun();
  }

  async save(what) {
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
