// A file of the reader's own: read, confirmed, cropped, fitted, saved.
import {answerHtml, escape, list, modelsHtml, named} from './answer.js';
import {pngOf, shown, svgOf} from './charts.js';
import {cropped, parted, ranges} from './files.js';
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

  /// One file of data, perhaps with what is stated beside it, or with the definition of a fit of it.
  async open(files) {
    if (!files.length) return;
    const {data, beside, definition} = await parted(files);
    const other = data.find(({name}) => /\.(json|html?|svg|png|jpe?g|gif|pdf|docx?)$/i.test(name));
    if (other) return this.trouble(`${other.name} is no table: drop the data as CSV or text, and with them a TOML if there is one.`);
    if (data.length > 1) return this.trouble('One file of data at a time: the program pools several (mixity fit run_*.csv --pool).');
    if (definition) return this.openDefinition(definition, data[0], beside);
    if (!data.length) return this.trouble('That is a TOML alone: drop the data with it.');
    this.take(data[0], beside);
  }

  /// As this page saves one: constants, options, cuts, models and the law come from it. `data` may be there already.
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

  /// The first law that comes with data becomes the one that is typed; the models by what they are called here then.
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
    for (const field of $('constants').querySelectorAll('input:not([type=checkbox])')) {
      field.value = stated.constants?.[field.name] ?? '';
      delete field.dataset.shown;
    }
    this.more = Object.fromEntries(Object.entries(stated.constants ?? {}).filter(([name]) => name !== 'columns' && !$('constants').elements[name]));
    this.readAgain(true);
  }

  /// Nothing of what was fitted stays on the page.
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

  constants() {
    const stated = {...this.more};
    for (const field of $('constants').querySelectorAll('input:not([type=checkbox])')) if (field.value.trim()) stated[field.name] = field.value === field.dataset.shown ? field.dataset.exact : field.value.trim();
    const columns = $('columns').value.trim();
    return columns ? {...stated, columns} : stated;
  }

  /// Reads the file with what the form says, shows how, and fits; what looks like a log only where that is asked for.
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
      if (!field) this.more[name] = text.exact;  // of a TOML: what is saved must hold it, too
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
    if (told.log && !asked) this.trouble(this.ofLog());
    else if (andFit) this.fit();
  }

  ofLog() {
    return `${this.name} looks like a log over time. The program makes loading runs of it (mixity runs ${this.name}): drop the runs.csv that it writes, with runs.toml. Fit takes the rows as they are.`;
  }

  /// Where only the constants are missing the columns are shown all the same.
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
    this.trouble(this.told.log ? this.ofLog() : `${sentence}: fill in the sphere and the constants above, with their units, and press Fit.`);
    $('constants').querySelector('input:placeholder-shown')?.focus();
  }

  showRead(whole) {
    const {told} = this;
    $('read-title').textContent = `${this.name}: ${told.points} of ${told.rows} rows${told.runs ? `, ${told.runs.length} run${told.runs.length === 1 ? '' : 's'}` : ''}`;
    const sentences = told.notice ? [told.notice] : [];
    if (this.from) sentences.push(this.from);
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
    this.showAnswer();
    this.figures.draw();
    this.tellModels();
  }

  showAnswer() {
    $('told').innerHTML = named(answerHtml(this.result));
    $('models').innerHTML = named(modelsHtml(this.result));
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
