// A file of the reader's own: read, confirmed, cropped, fitted, saved.
import {answerHtml, escape, list, modelsHtml} from './answer.js';
import {pngOf, shown, svgOf} from './charts.js';
import {FitFigures} from './fit_figures.js';

const $ = id => document.getElementById(id);
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
    this.figures = new FitFigures(this);
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
    $('run').addEventListener('change', () => this.figures.drawRun());
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
    this.figures.showAll();
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
    $('told').innerHTML = $('run').innerHTML = $('busy').textContent = '';
    $('downloads').hidden = $('others').hidden = $('crop').hidden = true;
    this.figures.clear();
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
    this.figures.draw();
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
    this.figures.draw();
    this.tellModels();
  }

  showAnswer() {
    $('told').innerHTML = answerHtml(this.result);
    $('models').innerHTML = modelsHtml(this.result);
    $('downloads').hidden = $('others').hidden = false;
  }

  /// Sets the sliders below to what was found.
  tellModels() {
    const {contact} = this.result.drawn, values = {};
    if (contact) Object.assign(values, {R: contact.radius * 1e3, E: contact.modulus * 1e-6, G: contact.toughness * 1e3});
    for (const fit of this.result.fits.datasets[0].fits) if (fit.parameters.lambda?.value > 0) values[fit.model] = fit.parameters.lambda.value;
    const own = this.result.fits.datasets[0].fits.find(fit => fit.model === this.models.own?.model);
    if (own) this.models.takeOwn(Object.values(own.parameters).slice(0, this.models.own.parameters.length).map(({value}) => value));
    this.models.take(values);
  }

  selected() {
    return Number($('run').value || 0);
  }

  crop(end, k) {
    const run = this.selected(), kept = this.kept[run];
    if (!kept) return;
    const most = this.told.runs[run].T.length - 1;
    kept[end] = Math.min(Math.max(Number.isFinite(k) ? k : kept[end], end === 0 ? 0 : kept[0]), end === 0 ? kept[1] : most);
    this.fit();
    this.figures.draw();
  }

  async save(what) {
    if (!this.result) return;
    const stem = this.name.replace(/\.[^.]*$/, '');
    const files = {
      used: () => [`${stem}_used.csv`, 'text/csv', this.result.used],
      fit: () => [`${stem}_fit.json`, 'application/json', JSON.stringify(this.result.fits, null, 2) + '\n'],
      toml: () => [`${stem}_fit.toml`, 'application/toml', this.result.definition],
      svg: () => [`${stem}.svg`, 'image/svg+xml', svgOf(this.figures.all)],
      png: async () => [`${stem}.png`, 'image/png', await pngOf(this.figures.all)],
    };
    const [name, type, content] = await files[what]();
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([content], {type}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}
