// A user's files: read, cut if they are logs, confirmed, cropped, fitted, saved.
import {answerHtml, buttonsHtml, escape, howRead, list, modelsHtml, named} from './answer.js';
import {Cuts} from './cuts.js';
import {besideOf, copied, cropped, offer, parted, ranges} from './files.js';
import {FitFigures} from './fit_figures.js';
import {follow, showOptions, takeOptions, undo} from './options.js';
import {Stopped} from './remote.js';
import {storedHtml} from './stored.js';

const $ = id => document.getElementById(id);
const fitting = 'Fitting …';
const names = files => files.map(({name}) => name);
const same = (one, other) => one.length === other.length && one.every(name => other.includes(name));

export class Experiment {
  constructor() {
    this.figures = new FitFigures(this);
    this.cuts = new Cuts(() => this.name ?? '');
    this.turn = 0;
    this.started = new Promise(resolve => {
      this.begin = (engine, models) => {
        Object.assign(this, {engine, models});
        resolve();
      };
    });
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
    $('constants').addEventListener('submit', event => { event.preventDefault(); this.readAgain(); });
    $('columns').addEventListener('change', () => this.readAgain());
    for (const box of document.querySelectorAll('input[name=model]')) box.addEventListener('change', () => this.whole && this.fit());
    $('run').addEventListener('change', () => this.select($('run').value));
    $('read').addEventListener('click', ({target}) => {
      const button = target.closest('button');
      if (button?.dataset.remedy) follow(this, JSON.parse(button.dataset.remedy));
      if (button?.dataset.without) undo(this, button.dataset.without);
      if (button?.dataset.copy) copied({'text/plain': new Blob([button.dataset.copy], {type: 'text/plain'})}, button);
    });
    for (const id of ['crop-first', 'crop-last'])
      $(id).addEventListener('change', () => this.crop(id === 'crop-first' ? 0 : 1, $(id).value === '' ? NaN : Math.round(Number($(id).value)) - 1));
    for (const button of document.querySelectorAll('[data-save]')) button.addEventListener('click', () => this.save(button.dataset.save));
    $('stop').addEventListener('click', () => this.stop());
    $('as-points').addEventListener('click', () => {
      this.asPoints = true;
      this.readAgain();
    });
  }

  /// Opens data files, perhaps with their TOML or with a fit definition, once the engine has started.
  async open(files) {
    if (!files.length) return;
    $('read').hidden = false;
    if (!this.engine) this.busy('Starting the engine …');
    const [{data, beside, definition, stored, problem}] = await Promise.all([parted(files), this.started]);
    if (stored) {
      this.stored = stored;
      this.showStored();
    }
    if (problem) {
      this.busy('');
      return this.trouble(problem);
    }
    if (definition) return this.openDefinition(definition, data, beside);
    if (!data.length) return this.busy('');
    return this.take(data, beside);
  }

  /// Opens a definition saved by this page with its constants, options, cuts, models and law. Its data may already be open.
  openDefinition(definition, data, beside) {
    return this.job(async step => {
      this.engine.write(definition.name, definition.bytes);
      const told = await step('Reading …', this.engine.definition(definition.name)), former = this.source;
      if (!data.length && former && same(names(former.data), told.data)) ({data, beside} = former);
      if (!data.length) throw new Error(`${definition.name} is of the data ${told.data.join(', ')}: drop ${told.data.length > 1 ? 'all' : 'both'} files at once.`);
      const other = same(names(data), told.data) ? '' : `, which is of ${told.data.join(', ')}`;
      return this.taken(step, data, beside, {...told, from: `constants, options and models are those of ${definition.name}${other}`});
    });
  }

  /// The first law that comes with data becomes the law of the page. Returns the models by their keys on the page.
  withLaw({models, laws = {}}) {
    const [[key, law] = [], ...others] = Object.entries(laws);
    if (law) this.models.define(/^law_\d+$/.test(key) ? law : `${key}: ${law}`);
    if (others.length) this.from = `${this.from ? `${this.from}; ` : ''}left out: ${others.map(([name]) => name).join(', ')}, as the page has one law beside the published ones`;
    return models.map(one => (one === key ? this.models.own?.model : one));
  }

  /// `beside`: the TOML of a data file by its name. `stated`: constants, options, models and laws that come with the data.
  take(data, beside, stated = {}) { return this.job(step => this.taken(step, data, beside, stated)); }

  taken(step, data, beside, stated) {
    const {engine} = this;
    this.source = {data, beside};
    this.name = data.length > 1 ? `${data[0].name} and ${data.length - 1} more` : data[0].name;
    this.trouble('');
    for (const one of data) {
      engine.write(one.name, one.bytes);
      engine.write(besideOf(one.name), beside[one.name]?.bytes ?? new Uint8Array());
    }
    this.asPoints = false;
    this.options = {...stated.options};
    this.models.show(null);
    this.from = stated.from;
    const ellipse = stated.models?.some(one => /-ellipse/.test(one)) ? {shape: 'ellipse'} : {};
    const models = stated.models && this.withLaw(stated).map(one => one?.replace(/-ellipse.*/, ''));
    for (const box of document.querySelectorAll('input[name=model]')) box.checked = models ? models.includes(box.value) : box.checked;
    this.more = {};
    this.forget();
    this.figures.showAll();
    $('columns').value = stated.constants?.columns ?? '';
    for (const field of this.fields()) {
      field.value = stated.constants?.[field.name] ?? '';
      delete field.dataset.shown;
    }
    this.more = Object.fromEntries(Object.entries({...stated.constants, ...ellipse}).filter(([name]) => name !== 'columns' && !$('constants').elements[name]));
    showOptions(this);
    return this.reading(step);
  }

  /// Does work in steps, each of which says what it waits for: `work(step)`, step(sentence, promise). A later job ends an
  /// earlier one, and so does the button.
  async job(work) {
    clearTimeout(this.fitting);
    if (this.engine.files.busy) this.engine.stop();
    const turn = ++this.turn;
    const step = async (says, promise) => {
      this.busy(says);
      const told = await promise;
      if (turn !== this.turn) throw new Stopped();
      return told;
    };
    try {
      this.trouble('');
      await work(step);
    } catch (error) {
      if (turn !== this.turn) return;
      this.forgetFit();
      this.trouble(error instanceof Stopped ? 'Stopped. Press Fit to begin again.' : error.message, error.buttons);
    }
    if (turn === this.turn) this.busy('');
  }

  /// Says what is waited for, and what part of it is done.
  busy(says, part) {
    $('busy').hidden = !says;
    if ($('busy-says').textContent !== says) $('busy-says').textContent = says;
    if (part === undefined) $('busy-part').removeAttribute('value');
    else $('busy-part').value = part;
    $('stop').hidden = !this.engine;
  }

  /// Removes the fit from the page, and what was read.
  forget() {
    this.told = this.log = null;
    this.whole = false;
    this.kept = [];
    this.forgetFit();
    $('run').innerHTML = '';
    $('crop').hidden = $('measured').hidden = $('log').hidden = true;
    this.figures.clear();
  }

  forgetFit() {
    this.result = null;
    $('told').innerHTML = '';
    $('downloads').hidden = $('others').hidden = true;
    $('residuals').hidden = $('axes').hidden = true;
    $('drawn').hidden = true;
  }

  trouble(sentence, buttons = []) {
    $('read').hidden = false;
    $('constants').hidden = $('mapping').hidden = !this.name;
    $('trouble').textContent = sentence;
    if (buttons.length) $('trouble').insertAdjacentHTML('beforeend', `<br>${buttonsHtml(buttons)}`);
    $('trouble').hidden = !sentence;
  }

  /// Results that were dropped, beside those of the fit at hand.
  showStored() {
    $('stored').hidden = !this.stored;
    if (this.stored) $('stored').innerHTML = named(storedHtml(this.stored, this.result));
  }

  /// Shows a run by its number.
  select(run) {
    $('run').value = String(run);
    this.setLoad();
    this.figures.draw();
  }

  stem() { return (this.log?.data ?? this.source?.data[0].name ?? 'mixity').replace(/\.[^.]*$/, ''); }

  fields() { return $('constants').querySelectorAll('input[name]:not([type=checkbox])'); }

  /// The constants in the form: {name: text}.
  constants() {
    const stated = {...this.more};
    for (const field of this.fields()) if (field.value.trim()) stated[field.name] = field.value === field.dataset.shown ? field.dataset.exact : field.value.trim();
    const columns = $('columns').value.trim();
    return columns ? {...stated, columns} : stated;
  }

  /// The files that are fitted and the constants for them. The runs of a log have theirs in a file beside them.
  fitted() { return this.log ? [[this.log.data], {}] : [names(this.source.data), this.constants()]; }

  readAgain() {
    if (!this.name) return undefined;
    takeOptions(this);
    return this.job(step => this.reading(step));
  }

  /// Reads the files with the form's constants, cuts them if they are logs, shows how that was done, and fits.
  async reading(step) {
    const {engine} = this, given = names(this.source.data);
    this.log = null;
    try {
      let told = await step('Reading …', engine.read(given, this.constants(), this.asPoints));
      if (told.log) {
        this.log = await step('Finding the loading runs …', engine.cut(given, given[0].replace(/\.[^.]*$/, ''), this.constants()));
        this.cuts.draw(this.log);
        told = await step('Reading the runs …', engine.read(...this.fitted(), true));
      }
      this.told = told;
    } catch (error) {
      if (error instanceof Stopped) throw error;
      const {log} = this;
      this.forget();
      this.log = log;
      return this.notRead(step, error);
    }
    const {told} = this;
    this.whole = true;
    for (const [name, text] of Object.entries(told.constants)) {
      const field = $('constants').elements[name];
      // the program takes a Poisson's ratio beside E* from the TOML only, which stays beside the data
      if (name === 'poisson_ratio' && !told.constants.youngs_modulus && !told.constants.mode_III) continue;
      if (!field && !this.log) this.more[name] = text.exact;  // from a TOML; saved files must include it
      if (!field || field.value) continue;
      field.value = field.dataset.shown = text.shown;
      field.dataset.exact = text.exact;
    }
    this.showRead(true);
    const lines = JSON.stringify(told.runs?.map(run => run.lines));
    if (lines !== this.lines || !this.kept.length) {
      const {kept, between} = cropped(told.runs ?? [], this.options.exclude ?? '', told.files);
      this.kept = kept;
      if (told.runs) this.options.exclude = between;
    }
    this.lines = lines;
    showOptions(this);
    const selected = this.selected();
    $('run').innerHTML = (told.runs ?? []).map((_, i) => `<option value="${i}">${escape(this.figures.runTitle(i))}</option>`).join('');
    if (selected < this.kept.length) $('run').value = String(selected);
    $('measured').hidden = false;
    $('crop').hidden = !told.runs?.length;
    this.forgetFit();
    this.figures.draw();
    return this.fitNow(step);
  }

  /// Shows why files were not read; if only constants are missing, also their columns.
  async notRead(step, {message, buttons}) {
    const [given, constants] = this.fitted();
    $('log').hidden = !this.log;
    try {
      this.told = await step('Reading …', this.engine.read(given, {radius: '1 mm', modulus: '1 MPa', toughness: '1 J/m^2', ...constants}, true));
    } catch (error) {
      if (error instanceof Stopped) throw error;
      $('more').open = error.options?.some(option => ['load', 'load_from', 'pixel', 'sheet'].includes(option));
      $('mapping').open = !$('more').open;
      $('read-title').textContent = this.name;
      $('taken').innerHTML = '';
      return this.trouble(error.message, error.buttons);
    }
    this.showRead(false);
    this.trouble(`${message}: fill in the sphere and the constants above, with their units, and press Fit.`, buttons);
    $('constants').querySelector('input:placeholder-shown')?.focus();
  }

  showRead(whole) {
    const {told, log} = this, runs = told.runs ? `, ${told.runs.length} run${told.runs.length === 1 ? '' : 's'}` : '';
    $('read-title').textContent = log ? `${this.name}: a log with ${told.runs.length} loading run${told.runs.length === 1 ? '' : 's'}, ${told.points} points`
      : `${this.name}: ${told.points + (told.pull_off?.points.length ?? 0)} of ${told.rows} rows${told.points ? runs : ', all of them pull-off loads'}`;
    $('taken').innerHTML = list(howRead(told, this.from, whole, name => !$('constants').elements[name]));
    $('log').hidden = !log;
  }

  chosen() { return [...document.querySelectorAll('input[name=model]:checked')].map(box => box.value); }

  /// Fits a moment later, as cuts and models often change more than once.
  fit() {
    clearTimeout(this.fitting);
    if (!this.whole) return;
    this.busy(fitting);
    this.fitting = setTimeout(() => this.job(step => this.fitNow(step)), 30);
  }

  stop() {
    clearTimeout(this.fitting);
    if (this.engine.files.busy) this.engine.stop();  // the job under way says so
    else this.busy('');
  }

  async fitNow(step) {
    const models = this.chosen(), {runs = [], files} = this.told;
    if (!models.length) return this.trouble('Choose a model.');
    const out = runs.flatMap(({lines}, i) => lines.filter((_, k) => k < this.kept[i][0] || k > this.kept[i][1]));
    const options = {...this.options, models: models.join(','), ...(this.log ? {peaks: this.log.peaks} : {})};
    options.exclude = [this.options.exclude, ranges(out, files)].filter(Boolean).join(',');
    if (!options.exclude) delete options.exclude;
    const begin = performance.now();
    this.result = await step(fitting, this.engine.fit(...this.fitted(), options, part => this.busy(fitting, part)));
    this.time = performance.now() - begin;
    $('told').innerHTML = named(answerHtml(this.result));
    $('models').innerHTML = named(modelsHtml(this.result));
    $('downloads').hidden = $('others').hidden = $('drawn').hidden = false;
    this.figures.draw();
    this.setSliders();
    this.showStored();
  }

  /// Sets the sliders of the models to the fitted values.
  setSliders() {
    const {contact} = this.result.drawn, {fits, mode_III} = this.result.fits.datasets[0], values = {};
    if (mode_III === 'averaged') return;  // the sliders' figures are of the other convention
    if (contact) Object.assign(values, {R: contact.radius * 1e3, E: contact.modulus * 1e-6, G: contact.toughness * 1e3});
    for (const {model, parameters} of fits) if (parameters.lambda?.value > 0) values[model] = parameters.lambda.value;
    const own = fits.find(fit => fit.model === this.models.own?.model);
    if (own) this.models.takeOwn(Object.values(own.parameters).slice(0, this.models.own.parameters.length).map(({value}) => value));
    this.models.take(values);
    this.showBehind();
    this.setLoad();
  }

  /// The points behind the curves of the sliders, which are those of a held load.
  showBehind() {
    const {told, result} = this, contact = result?.drawn.contact;
    const keeps = (i, values) => values.filter((_, k) => this.figures.keeps(i)(k));
    this.models.show(told?.runs && contact && !told.held.approach ? {word: told.notice ? 'reconstructed' : 'measured',
      runs: told.runs.map((run, i) => ({P: run.P * contact.mN, T: keeps(i, run.T).map(T => T * contact.mN), A: keeps(i, run.A).map(A => A * contact.mm2)}))} : null);
  }

  /// Sets the sliders to the selected run: its load, and half of its largest T.
  setLoad() {
    const run = this.models.measured?.runs[this.selected()];
    if (run?.T.length) this.models.take({P: Number(run.P.toPrecision(6)), T: Number((.5 * Math.max(...run.T.map(Math.abs))).toPrecision(4))});
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

  save(what) {
    const cut = this.log?.files[what];
    if (cut) return offer(cut, cut.endsWith('.csv') ? 'text/csv' : 'application/toml', this.log.contents[cut]);
    if (!this.result) return;
    const stem = this.stem();
    const files = {
      used: () => [`${stem}_used.csv`, 'text/csv', this.result.used],
      fit: () => [`${stem}_fit.json`, 'application/json', JSON.stringify(this.result.fits, null, 2) + '\n'],
      toml: () => [`${stem}_fit.toml`, 'application/toml', this.result.definition],
    };
    offer(...files[what]());
  }
}
