// The sliders, and what the models say at them.
import {color, colorOfModel, figure, line, marks, shown} from './charts.js';
import {RegimeMap} from './map.js';
import {byDecades, quantities, read, valid, write} from './state.js';

const models = ['a', 'b', 'c'];
const ownColor = 4;
const asSentence = text => `${text[0].toUpperCase()}${text.slice(1)}.`;

export class Models {
  constructor(engine, state) {
    this.engine = engine;
    this.state = state;
    this.figures = {
      area: figure('chart-area', {x: {name: 'T (mN)', min: 0}, y: {name: 'A (mm²)', min: 0}}),
      toughness: figure('chart-toughness', {x: {name: 'ψ (rad)', min: 0, max: 1.58}, y: {name: 'Gc/GIc', type: 'log', min: 1, max: 1000}}),
      displacement: figure('chart-displacement', {x: {name: 'u (µm)', min: 0}, y: {name: 'T (mN)', min: 0}}),
      radius: figure('chart-radius', {x: {name: 'P (mN)'}, y: {name: 'a (mm)', min: 0}}),
      map: figure('chart-map', {x: {name: 'P (mN)'}, y: {name: 'λ', type: 'log', min: 1e-5, max: 1}}),
    };
    this.turn = Object.keys(this.figures);
    this.map = new RegimeMap(engine, this, this.figures.map);
    this.makeSliders();
    this.field = document.getElementById('law');
    document.getElementById('own').addEventListener('submit', event => { event.preventDefault(); this.typed(this.field.value.trim()); });
    this.define(state.law, state.own);
    addEventListener('hashchange', () => {
      const {map, over, off, law, own, ...values} = read();
      Object.assign(state, {map, over, off});
      this.define(law, own);
      for (const model of models) document.querySelector(`[aria-label='model ${model} drawn']`).checked = !off.has(model);
      this.take(values);
    });
    this.redraw();
  }

  /// A law that has just been typed is what the map is looked at for.
  typed(text) {
    if (this.define(text) && this.own) {
      this.state.map = 'own';
      this.map.offer();
    }
  }

  /// A law that somebody typed is a model until another one is; none is typed: there is none.
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
    (this.own?.parameters ?? []).forEach(({name, lower, upper}, i) => {
      const logarithmic = byDecades({lower, upper}), box = document.createElement('div');
      box.className = 'slider model';
      box.style.setProperty('--own', `var(--color-${ownColor})`);
      box.innerHTML = `<label for="own-${i}">${name} of your own law</label>
        <span class="value"><input type="number" step="any" aria-label="${name} of your own law"></span>
        <input type="range" id="own-${i}" min="0" max="1000" step="1">`;
      const [number, range] = [box.querySelector('input[type=number]'), box.querySelector('input[type=range]')];
      const show = () => {
        number.value = shown(state.own[i], 5);
        range.value = 1000 * (logarithmic ? Math.log(state.own[i] / lower) / Math.log(upper / lower) : (state.own[i] - lower) / (upper - lower));
        range.setAttribute('aria-valuetext', shown(state.own[i]));
      };
      const set = value => {
        if (Number.isFinite(value)) state.own[i] = Math.min(Math.max(Number(value.toPrecision(6)), lower), upper);
        show();
        this.schedule();
      };
      range.addEventListener('input', () => set(logarithmic ? lower * (upper / lower) ** (range.value / 1000) : lower + (upper - lower) * range.value / 1000));
      number.addEventListener('change', () => set(number.value.trim() === '' ? NaN : Number(number.value)));
      form.append(box);
      show();
    });
  }

  takeOwn(values) {
    if (!values.every(Number.isFinite)) return;
    this.state.own = values;
    this.makeOwnSliders();
  }

  /// What a model is called, and its colour.
  title(model) { return model === this.own?.model ? 'your own law' : `model ${model}`; }
  tint(model) { return model === this.own?.model ? ownColor : colorOfModel[model]; }
  parametersOf(model) { return model === this.own?.model ? this.state.own : [this.state[model]]; }

  makeSliders() {
    const form = document.getElementById('sliders');
    form.addEventListener('submit', event => event.preventDefault());
    this.controls = {};
    for (const q of quantities) {
      const box = document.createElement('div');
      box.className = q.model ? 'slider model' : 'slider';
      if (q.model) box.style.setProperty('--own', `var(--color-${colorOfModel[q.key]})`);
      const id = `slider-${q.key}`;
      box.innerHTML = `<label for="${id}">${q.label.replace('_Ic', '<sub>Ic</sub>')}</label>
        <span class="value"><input type="number" step="any" aria-label="${q.label}${q.unit ? ` in ${q.unit}` : ''}"> ${q.unit ?? ''}</span>
        <input type="range" id="${id}" min="0" max="1000" step="1">`;
      if (q.model) {
        const label = document.createElement('label');
        label.innerHTML = '<input type="checkbox"> drawn';
        const box2 = label.firstChild;
        box2.checked = !this.state.off.has(q.key);
        box2.setAttribute('aria-label', `model ${q.key} drawn`);
        box2.addEventListener('change', () => { this.state.off[box2.checked ? 'delete' : 'add'](q.key); this.redraw(); });
        box.append(label);
      }
      const [number, range] = [box.querySelector('input[type=number]'), box.querySelector('input[type=range]')];
      range.addEventListener('input', () => this.set(q, q.logarithmic
        ? q.low * (q.high / q.low) ** (range.value / 1000) : q.low + (q.high - q.low) * range.value / 1000, number));
      number.addEventListener('change', () => {
        const value = valid(q, number.value);
        if (value !== null) this.set(q, value);
        else this.show(q);
      });
      this.controls[q.key] = {number, range};
      form.append(box);
      this.show(q);
    }
  }

  /// The state of a quantity on its slider and in its field.
  show(q) {
    const value = this.state[q.key], {number, range} = this.controls[q.key];
    number.value = shown(value, 5);
    range.value = 1000 * (q.logarithmic ? Math.log(value / q.low) / Math.log(q.high / q.low) : (value - q.low) / (q.high - q.low));
    range.setAttribute('aria-valuetext', `${shown(value)} ${q.unit ?? ''}`);
  }

  set(q, value) {
    this.state[q.key] = Number(value.toPrecision(6));
    this.show(q);
    this.schedule();
  }

  /// From a fit: {P, R, ...}.
  take(values) {
    for (const q of quantities)
      if (Number.isFinite(values[q.key])) {
        this.state[q.key] = values[q.key];
        this.show(q);
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

  /// Asks the engine, and draws figures as long as a frame lasts; those that are left follow in the next ones.
  redraw() {
    const begin = performance.now();
    const {state} = this;
    clearTimeout(this.saving);
    this.saving = setTimeout(() => write(state), 150);
    const wanted = [...models.filter(m => !state.off.has(m)), ...(this.own ? [this.own.model] : [])];
    const T_most = Math.max(2 * Math.abs(state.T), 1), P_most = Math.max(2 * Math.abs(state.P), 5);
    try {
      this.all = this.engine.draw({...this.constants(), P: state.P, T: state.T, T_most, P_most, models: wanted.map(m => ({model: m, parameters: this.parametersOf(m)}))});
    } catch (error) {
      document.getElementById('says').textContent = error.message;
      return;
    }
    document.getElementById('says').textContent = this.all.map(one => this.sentence(one)).join(' ');
    this.stale = new Set(Object.keys(this.figures));
    this.drawSome(begin);
  }

  /// In turn, those in view first, so that none waits while a slider moves.
  drawSome(begin) {
    const inView = name => { const box = this.figures[name].chart.getDom().getBoundingClientRect(); return box.bottom > 0 && box.top < innerHeight; };
    const turn = [...this.turn.filter(inView), ...this.turn.filter(name => !inView(name))];
    for (const name of turn) {
      if (!this.stale.has(name)) continue;
      if (name === 'map') this.map.draw();
      else this.drawCurve(name);
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

  /// A figure of which more has become known.
  drawAgain(name) {
    this.stale.add(name);
    this.follow();
  }

  drawCurve(name) {
    // a law that defines no equilibrium is a law all the same
    const {state, all} = this, there = all.filter(one => !one.problem || (name === 'toughness' && one.toughness)), names = there.map(one => this.title(one.model));
    const what = {
      area: `Contact area against tangential load at P = ${shown(state.P)} mN`,
      toughness: 'Toughness against phase angle',
      displacement: `Tangential load against displacement at P = ${shown(state.P)} mN`,
      radius: `Contact radius against normal load at T = ${shown(state.T)} mN`,
    }[name];
    this.figures[name].draw(there.flatMap(one => this[name](one, this.title(one.model), color(this.tint(one.model)))),
      `${what} for ${names.join(', ') || 'no model'}`, {legend: {data: names}});
  }

  /// Solid up to the first place where the contact is not stable, dashed from there.
  twoParts(one, name, own, x, y) {
    const turn = one.curve.stable.indexOf(false), end = turn < 0 ? x.length : turn;
    const along = (from, to) => x.slice(from, to).map((value, i) => [value, y[from + i]]);
    return [line(`${one.model}-stable`, name, along(0, end), own), line(`${one.model}-unstable`, name, along(Math.max(end - 1, 0), x.length), own, 'dashed')];
  }

  folds(one, name, own, place) {
    return ['load', 'displacement'].map(control => marks(`${one.model}-${control}`, name, one.folds.filter(fold => fold.control === control).map(fold => ({
      value: place(fold),
      hover: `${this.title(one.model)} jumps under ${control} control:<br>T = ${shown(fold.T)} mN, A = ${shown(fold.A)} mm², u = ${shown(fold.u)} µm<br>to ${fold.jumps_to}`,
    })), own, control === 'load' ? 'triangle' : 'diamond'));
  }

  here(one, name, own, place) {
    return marks(`${one.model}-here`, name, place ? [place] : [], own, 'circle', {itemStyle: {color: own}});
  }

  area(one, name, own) {
    const jump = one.folds.find(fold => fold.control === 'load');
    return [...this.twoParts(one, name, own, one.curve.T, one.curve.A), ...this.folds(one, name, own, fold => [fold.T, fold.A]),
      line(`${one.model}-jump`, name, jump ? [[jump.T, jump.A], [jump.T, jump.area_after]] : [], own, 'dotted'),
      this.here(one, name, own, one.state && [Math.abs(this.state.T), one.state.A])];
  }

  toughness(one, name, own) {
    return [line(`${one.model}-law`, name, one.toughness.map(([psi, f]) => [psi, Math.max(f, 1)]), own),
      this.here(one, name, own, one.state && one.state.psi !== undefined && [one.state.psi, one.state.f])];
  }

  displacement(one, name, own) {
    return [...this.twoParts(one, name, own, one.curve.u, one.curve.T), ...this.folds(one, name, own, fold => [fold.u, fold.T])];
  }

  radius(one, name, own) {
    return [line(`${one.model}-stable`, name, one.radii.stable, own), line(`${one.model}-unstable`, name, one.radii.unstable, own, 'dashed'),
      this.here(one, name, own, one.state && [this.state.P, Math.sqrt(one.state.A / Math.PI)])];
  }

  sentence(one) {
    const named = this.title(one.model).replace(/^./, first => first.toUpperCase());
    if (one.problem) return `${named}: ${one.problem}.`;
    const {state} = this, jump = one.folds.find(fold => fold.control === 'load');
    const beyond = jump ? `beyond its jump, A = ${shown(jump.area_after)} mm² if it slides at that` : 'beyond its last equilibrium';
    const here = one.state ? `A = ${shown(one.state.A)} mm²` : beyond;
    const names = one.model === this.own?.model ? this.own.parameters.map(({name}) => name) : ['λ'];
    const chosen = this.parametersOf(one.model).map((value, i) => `${names[i]} = ${shown(value)}`).join(', ');
    return `${named} (${chosen}): ${here} at T = ${shown(state.T)} mN; ` +
      (jump ? `jumps at T = ${shown(jump.T)} mN from ${shown(jump.A)} to ${shown(jump.area_after)} mm².` : `${one.regime.slice(2)}.`);
  }
}
