// The sliders, and the models at their values.
import {colorOfModel, figure, ownColor, shown} from './charts.js';
import {drawCurve, sentence} from './curves.js';
import {laws, meaning} from './laws.js';
import {RegimeMap} from './map.js';
import {slider} from './slider.js';
import {byDecades, quantities, read, valid, write} from './state.js';

const models = ['a', 'b', 'c'];
const asSentence = text => `${text[0].toUpperCase()}${text.slice(1)}.`;

export class Models {
  constructor(engine, state) {
    this.engine = engine;
    this.state = state;
    const about = {stem: () => 'mixity', lines: () => this.about()};
    this.figures = {
      area: figure('chart-area', {x: {name: 'T (mN)', min: 0}, y: {name: 'A (mm²)', min: 0}}, {about}),
      toughness: figure('chart-toughness', {x: {name: 'ψ (°)', min: 0, max: 90, interval: 15}, y: {name: 'Gc/GIc', type: 'log', min: 1, max: 1000}}, {about}),
      displacement: figure('chart-displacement', {x: {name: 'u (µm)', min: 0}, y: {name: 'T (mN)', min: 0}}, {about}),
      radius: figure('chart-radius', {x: {name: 'P (mN)'}, y: {name: 'a (mm)', min: 0}}, {about}),
      map: figure('chart-map', {x: {name: 'P (mN)'}, y: {name: 'λ', type: 'log', min: 1e-5, max: 1}}, {about}),
    };
    this.measured = null;  // the user's points behind the curves, in mN and mm²
    this.turn = Object.keys(this.figures);
    this.map = new RegimeMap(engine, this, this.figures.map);
    this.makeSliders();
    this.field = document.getElementById('law');
    this.held = document.getElementById('held');
    this.held.checked = state.held;
    this.held.addEventListener('change', () => { state.held = this.held.checked; this.redraw(); });
    document.getElementById('own').addEventListener('submit', event => { event.preventDefault(); this.typed(this.field.value.trim()); });
    this.define(state.law, state.own);
    addEventListener('hashchange', () => {
      const {map, over, off, law, own, held, ...values} = read();
      Object.assign(state, {map, over, off, held});
      this.held.checked = held;
      this.define(law, own);
      for (const model of models) document.querySelector(`[aria-label='model ${model} drawn']`).checked = !off.has(model);
      this.take(values);
    });
    this.redraw();
  }

  /// The lines at the top of a saved figure.
  about() {
    const {state} = this, drawn = (this.all ?? []).map(({model}) => `${this.named(model)} (${this.chosen(model)})`);
    return [drawn.join('; '), quantities.filter(q => !q.model).map(q => `${q.label.split(' ').at(-1)} = ${shown(state[q.key])} ${q.unit}`).join(', ')];
  }

  /// "model c, Papangelo-Ciavarella 2019", and "λ = 0.0023".
  named(model) { return laws[model] ? `model ${model}, ${laws[model].name}` : this.title(model); }
  chosen(model) {
    const names = model === this.own?.model ? this.own.parameters.map(({name}) => name) : ['λ'];
    return this.parametersOf(model).map((value, i) => `${names[i]} = ${shown(value)}`).join(', ');
  }

  /// Shows points of the user behind the curves: {word, runs: [{P, T, A}]}, in mN and mm²; null removes them.
  show(measured) {
    this.measured = measured;
    if (this.all) this.drawAgain('area');
  }

  /// Defines a law that was just typed, and shows its map.
  typed(text) {
    if (this.define(text) && this.own) {
      this.state.map = 'own';
      this.map.offer();
    }
  }

  /// Defines the law in a text, replacing the last one; removes it if the text is empty.
  define(text, values = []) {
    const {state} = this, says = document.getElementById('law-says');
    let law = null;
    this.field.value = text;
    try {
      law = text ? this.engine.define(text) : null;
      says.textContent = law ? law.warnings.map(asSentence).join(' ') : '';
    } catch (error) {
      says.textContent = asSentence(error.message.replace(/^law:1:(\d+): /, 'Character $1: ')) + (this.own ? ` What is drawn is still ${state.law}.` : '');
      this.map.offer();
      return false;
    } finally {
      const wrong = Boolean(text) && !law;
      says.classList.toggle('alert', wrong);
      this.field.setAttribute('aria-invalid', String(wrong));
    }
    this.own = law;
    state.law = text;
    state.own = law ? law.parameters.map(({start, lower, upper}, i) => values[i] >= lower && values[i] <= upper ? values[i] : start) : [];
    const fitted = document.getElementById('own-fitted'), box = fitted.firstChild;
    fitted.hidden = !law;
    if (!law || box.value !== law.model) box.checked = Boolean(law);
    box.value = law ? law.model : '';
    this.makeOwnSliders();
    this.map.offer();
    this.schedule();
    return true;
  }

  makeOwnSliders() {
    const form = document.getElementById('own-sliders'), {state} = this;
    form.textContent = '';
    (this.own?.parameters ?? []).forEach(({name, lower, upper}, i) => slider(form, `own-${i}`,
      {label: `${name} of your own law`, low: lower, high: upper, logarithmic: byDecades({lower, upper})}, {
        tint: ownColor,
        get: () => state.own[i],
        parse: text => text.trim() === '' || !Number.isFinite(Number(text)) ? null : Number(text),
        set: value => {
          state.own[i] = Math.min(Math.max(value, lower), upper);
          this.schedule();
        },
      }));
  }

  takeOwn(values) {
    if (!values.every(Number.isFinite)) return;
    this.state.own = values;
    this.makeOwnSliders();
  }

  /// The title of a model, and its colour.
  title(model) { return model === this.own?.model ? 'your own law' : `model ${model}`; }
  tint(model) { return model === this.own?.model ? ownColor : colorOfModel[model]; }
  parametersOf(model) { return model === this.own?.model ? this.state.own : [this.state[model]]; }

  makeSliders() {
    const form = document.getElementById('sliders'), {state} = this;
    form.addEventListener('submit', event => event.preventDefault());
    this.sliders = {};
    for (const q of quantities) {
      const set = value => { state[q.key] = value; this.schedule(); };
      this.sliders[q.key] = slider(form, `slider-${q.key}`, q, {tint: q.model && colorOfModel[q.key], get: () => state[q.key], set, parse: text => valid(q, text)});
      if (!q.model) continue;
      const box = this.sliders[q.key].box, says = document.createElement('p');
      says.className = 'soft meaning';
      says.innerHTML = meaning(q.key);
      box.append(this.switchOf(q.key), says);
    }
  }

  /// Shows or hides a model.
  switchOf(model) {
    const label = document.createElement('label');
    label.innerHTML = '<input type="checkbox"> drawn';
    const box = label.firstChild;
    box.checked = !this.state.off.has(model);
    box.setAttribute('aria-label', `model ${model} drawn`);
    box.addEventListener('change', () => { this.state.off[box.checked ? 'delete' : 'add'](model); this.redraw(); });
    return label;
  }

  /// Sets the sliders from a fit: {P, R, ...}.
  take(values) {
    for (const q of quantities)
      if (Number.isFinite(values[q.key])) {
        this.state[q.key] = values[q.key];
        this.sliders[q.key].show();
      }
    this.redraw();
  }

  schedule() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.redraw(); });
  }

  constants() {
    const {R, E, G} = this.state;
    return {radius: R * 1e-3, modulus: E * 1e6, toughness: G * 1e-3};
  }

  /// Calls the engine and draws figures for the duration of a frame; the others follow in the next frames.
  redraw() {
    const begin = performance.now();
    const {state} = this;
    clearTimeout(this.saving);
    this.saving = setTimeout(() => write(state), 150);
    const wanted = [...models.filter(m => !state.off.has(m)), ...(this.own ? [this.own.model] : [])];
    const T_most = Math.max(2 * Math.abs(state.T), 1), P_most = Math.max(2 * Math.abs(state.P), 5);
    try {
      this.all = this.engine.draw({...this.constants(), P: state.P, T: state.T, T_most, P_most, held: state.held, models: wanted.map(m => ({model: m, parameters: this.parametersOf(m)}))});
    } catch (error) {
      document.getElementById('says').textContent = error.message;
      return;
    }
    document.getElementById('says').textContent = this.all.map(one => sentence(this, one)).join('\n');
    this.stale = new Set(Object.keys(this.figures));
    this.drawSome(begin);
  }

  /// Draws the figures in turn, those in view first, so that none waits while a slider moves.
  drawSome(begin) {
    const inView = name => { const box = this.figures[name].chart.getDom().getBoundingClientRect(); return box.bottom > 0 && box.top < innerHeight; };
    const turn = [...this.turn.filter(inView), ...this.turn.filter(name => !inView(name))];
    for (const name of turn) {
      if (!this.stale.has(name)) continue;
      if (name === 'map') this.map.draw();
      else drawCurve(this, name);
      this.stale.delete(name);
      this.turn.push(this.turn.splice(this.turn.indexOf(name), 1)[0]);
      if (performance.now() - begin > 8) break;
    }
    this.time = performance.now() - begin;
    if (this.stale.size) this.follow();
  }

  follow() {
    if (this.following) return;
    this.following = true;
    requestAnimationFrame(() => { this.following = false; this.drawSome(performance.now()); });
  }

  /// Redraws a figure.
  drawAgain(name) {
    this.stale.add(name);
    this.follow();
  }
}
