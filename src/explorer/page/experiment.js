// A user's file: read, confirmed, cropped, fitted, saved.
import {answerHtml, escape, howRead, list, looksLikeALog, modelsHtml, named} from './answer.js';
import {pngOf, shown, svgOf} from './charts.js';
import {cropped, offer, parted, ranges} from './files.js';
import {FitFigures} from './fit_figures.js';

const $ = id => document.getElementById(id);

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
    $('constants').addEventListener('submit', event => { event.preventDefault(); this.readAgain(true, true); });
    $('columns').addEventListener('change', () => this.readAgain(true));
    for (const box of document.querySelectorAll('input[name=model]')) box.addEventListener('change', () => this.whole && this.fit());
    $('run').addEventListener('change', () => this.figures.drawRun());
    for (const id of ['crop-first', 'crop-last'])
      $(id).addEventListener('change', () => this.crop(id === 'crop-first' ? 0 : 1, $(id).value === '' ? NaN : Math.round(Number($(id).value)) - 1));
    for (const button of document.querySelectorAll('[data-save]')) button.addEventListener('click', () => this.save(button.dataset.save));
  }

  /// Opens a data file, perhaps with its TOML or with a fit definition.
  async open(files) {
    if (!files.length) return;
    const {data, beside, definition, problem} = await parted(files);
    if (problem) return this.trouble(problem);
    if (definition) return this.openDefinition(definition, data, beside);
    this.take(data, beside);
  }

  /// Opens a definition saved by this page with its constants, options, cuts, models and law. Its data may already be open.
  openDefinition(definition, data, beside) {
    const {engine, models} = this, former = this.source;
    engine.write(definition.name, definition.bytes);
    let told = null, problem = '';
    try {
      told = engine.definition(definition.name);
      if (!data && former?.data.name === told.data) ({data, beside} = former);
      if (!data) problem = `${definition.name} is of the data ${told.data}: drop both files at once.`;
    } catch (error) {
      problem = error.message;
    }
    if (problem || !Object.keys(told.laws).length) models.define(models.state.law, models.state.own);  // the engine has forgotten it
    if (problem) return this.trouble(problem);
    this.take(data, beside, {...told, from: `constants, options and models are those of ${definition.name}${told.data === data.name ? '' : `, which is of ${told.data}`}`});
  }

  /// The first law that comes with data becomes the law of the page. Returns the models by their keys on the page.
  withLaw({models, laws = {}}) {
    const [[key, law] = [], ...others] = Object.entries(laws);
    if (law) this.models.define(/^law_\d+$/.test(key) ? law : `${key}: ${law}`);
    if (others.length) this.from = `${this.from ? `${this.from}; ` : ''}left out: ${others.map(([name]) => name).join(', ')}, as the page has one law beside the published ones`;
    return models.map(one => (one === key ? this.models.own?.model : one));
  }

  /// `stated`: constants, options, models and laws that come with the data.
  take(data, toml, stated = {}) {
    this.source = {data, beside: toml};
    this.name = data.name;
    this.engine.write(this.name, data.bytes);
    this.engine.write(this.name.replace(/(\.[A-Za-z]\w*)?$/, '.toml'), toml ? toml.bytes : new Uint8Array());
    this.options = {...stated.options};
    this.from = stated.from;
    const models = stated.models && this.withLaw(stated);
    for (const box of document.querySelectorAll('input[name=model]')) box.checked = models ? models.includes(box.value) : box.checked;
    this.told = null;
    this.more = {};
    this.forget();
    this.figures.showAll();
    $('columns').value = stated.constants?.columns ?? '';
    $('read').hidden = false;
    for (const field of this.fields()) {
      field.value = stated.constants?.[field.name] ?? '';
      delete field.dataset.shown;
    }
    this.more = Object.fromEntries(Object.entries(stated.constants ?? {}).filter(([name]) => name !== 'columns' && !$('constants').elements[name]));
    this.readAgain(true);
  }

  /// Removes the fit from the page.
  forget() {
    clearTimeout(this.fitting);
    this.result = null;
    this.whole = false;
    this.kept = [];
    $('told').innerHTML = $('run').innerHTML = $('busy').textContent = '';
    $('downloads').hidden = $('others').hidden = $('crop').hidden = $('measured').hidden = true;
    this.figures.clear();
  }

  trouble(sentence) {
    $('read').hidden = false;
    $('constants').hidden = $('mapping').hidden = !this.name;
    $('trouble').textContent = sentence;
    $('trouble').hidden = !sentence;
  }

  fields() { return $('constants').querySelectorAll('input:not([type=checkbox])'); }

  /// The constants in the form: {name: text}.
  constants() {
    const stated = {...this.more};
    for (const field of this.fields()) if (field.value.trim()) stated[field.name] = field.value === field.dataset.shown ? field.dataset.exact : field.value.trim();
    const columns = $('columns').value.trim();
    return columns ? {...stated, columns} : stated;
  }

  /// Reads the file with the form's constants, shows how it was read, and fits; if it looks like a log, only if `asked`.
  readAgain(andFit, asked = false) {
    if (!this.name) return;
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
      if (!field) this.more[name] = text.exact;  // from a TOML; saved files must include it
      if (!field || field.value) continue;
      field.value = field.dataset.shown = text.shown;
      field.dataset.exact = text.exact;
    }
    this.showRead(true);
    const lines = JSON.stringify(told.runs?.map(run => run.lines));
    if (lines !== this.lines || !this.kept.length) {
      const {kept, between} = cropped(told.runs ?? [], this.options.exclude ?? '');
      this.kept = kept;
      if (told.runs) this.options.exclude = between;
    }
    this.lines = lines;
    const selected = this.selected();
    $('run').innerHTML = (told.runs ?? []).map((run, i) => `<option value="${i}">${escape(run.name || `P = ${shown(run.P)}`)}</option>`).join('');
    if (selected < this.kept.length) $('run').value = String(selected);
    $('measured').hidden = false;
    $('crop').hidden = !told.runs;
    this.figures.draw();
    if (told.log && !asked) this.trouble(looksLikeALog(this.name));
    else if (andFit) this.fit();
  }

  /// Shows why a file was not read; if only constants are missing, also its columns.
  notRead(sentence) {
    this.told = null;
    this.trouble(sentence);
    try {
      this.told = this.engine.read(this.name, {radius: '1 mm', modulus: '1 MPa', toughness: '1 J/m^2', ...this.constants()});
    } catch (error) {
      this.trouble(error.message);
      $('more').open = error.options?.some(option => option === 'load' || option === 'pixel');
      $('mapping').open = !$('more').open;
      $('read-title').textContent = this.name;
      $('taken').innerHTML = '';
      return;
    }
    this.showRead(false);
    this.trouble(this.told.log ? looksLikeALog(this.name) : `${sentence}: fill in the sphere and the constants above, with their units, and press Fit.`);
    $('constants').querySelector('input:placeholder-shown')?.focus();
  }

  showRead(whole) {
    const {told} = this;
    $('read-title').textContent = `${this.name}: ${told.points} of ${told.rows} rows${told.runs ? `, ${told.runs.length} run${told.runs.length === 1 ? '' : 's'}` : ''}`;
    $('taken').innerHTML = list(howRead(told, this.from, whole, name => !$('constants').elements[name]));
  }

  chosen() { return [...document.querySelectorAll('input[name=model]:checked')].map(box => box.value); }

  /// Fits after the browser has drawn the message that this takes a while.
  fit() {
    clearTimeout(this.fitting);
    if (!this.whole) return;
    if (!this.chosen().length) return this.trouble('Choose a model.');
    $('busy').textContent = 'Fitting …';
    this.fitting = setTimeout(() => this.fitNow(), 30);
  }

  fitNow() {
    const models = this.chosen();
    const out = (this.told.runs ?? []).flatMap(({lines}, i) => lines.filter((_, k) => k < this.kept[i][0] || k > this.kept[i][1]));
    const options = {...this.options, models: models.join(',')};
    options.exclude = [this.options.exclude, ranges(out)].filter(Boolean).join(',');
    if (!options.exclude) delete options.exclude;
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
    $('told').innerHTML = named(answerHtml(this.result));
    $('models').innerHTML = named(modelsHtml(this.result));
    $('downloads').hidden = $('others').hidden = false;
    this.figures.draw();
    this.setSliders();
  }

  /// Sets the sliders of the models to the fitted values.
  setSliders() {
    const {contact} = this.result.drawn, {fits} = this.result.fits.datasets[0], values = {};
    if (contact) Object.assign(values, {R: contact.radius * 1e3, E: contact.modulus * 1e-6, G: contact.toughness * 1e3});
    for (const {model, parameters} of fits) if (parameters.lambda?.value > 0) values[model] = parameters.lambda.value;
    const own = fits.find(fit => fit.model === this.models.own?.model);
    if (own) this.models.takeOwn(Object.values(own.parameters).slice(0, this.models.own.parameters.length).map(({value}) => value));
    this.models.take(values);
  }

  selected() { return Number($('run').value || 0); }

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
    offer(...await files[what]());
  }
}
