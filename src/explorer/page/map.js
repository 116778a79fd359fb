// The map of regimes of a contact over normal load and one parameter of a model.
import {areas, axis, color, marks, shown} from './charts.js';
import {byDecades, quantities} from './state.js';

const tintOfRegime = {'shrinks, never to Hertz': 6, 'shrinks to Hertz': 3, jumps: 1};
const mostKept = 40;                            // maps

export class RegimeMap {
  /// `models` has the state and the laws, `figure` draws.
  constructor(engine, models, figure) {
    Object.assign(this, {engine, models, figure, known: new Map()});
    this.says = document.getElementById('map-says');
    this.model = document.getElementById('map-model');
    this.axis = document.getElementById('map-axis');
    this.model.addEventListener('change', () => { models.state.map = this.model.value; this.offer(); models.redraw(); });
    this.axis.addEventListener('change', () => { models.state.over = this.axis.value; models.redraw(); });
  }

  /// The parameters of the map's model.
  parameters() {
    const {state, own} = this.models;
    if (state.map === 'own') return own.parameters.map(one => ({...one, logarithmic: byDecades(one)}));
    return [{name: 'λ', lower: 1e-5, upper: quantities.find(q => q.key === state.map).high, logarithmic: true}];
  }

  /// Offers the available models and parameters.
  offer() {
    const {state, own} = this.models;
    if (state.map === 'own' && !own) state.map = 'b';
    const names = this.parameters().map(({name}) => name), single = names.length === 1;
    if (!names.includes(state.over)) state.over = names[0];
    const fill = (select, options, chosen) => {
      select.replaceChildren(...options.map(([value, text]) => new Option(text, value)));
      select.value = chosen;
    };
    fill(this.model, [...['a', 'b', 'c'].map(key => [key, `model ${key}`]), ...(own ? [['own', 'your own law']] : [])], state.map);
    fill(this.axis, names.map(name => [name, name]), state.over);
    this.axis.hidden = single;
    document.getElementById('map-over').textContent = `by load and ${single ? names[0] : ''}`;
  }

  /// The request to the engine, and its key. Loads are over R G_Ic, and reach up to twice what P needs, so that a map
  /// serves every sphere and every value on its axis.
  wanted() {
    const {state, own} = this.models, parameters = this.parameters(), chosen = parameters.findIndex(({name}) => name === state.over);
    const {name, lower, upper, logarithmic} = parameters[chosen], model = state.map === 'own' ? own.model : state.map;
    const unit = state.R * state.G * 1e-3, least = 6 * Math.PI, P_most = Math.max(2 * state.P / unit, least), values = this.models.parametersOf(model);
    const request = {model, law: state.map === 'own' ? state.law : '', axis: chosen, low: lower, high: upper, logarithmic, P_low: -.999 * 1.5 * Math.PI};
    const family = JSON.stringify(request);  // equal except for the other parameters and the loads
    request.P_high = least * 2 ** Math.max(Math.ceil(Math.log2(1.06 * P_most / least)), 0);
    request.parameters = values.map((value, i) => (i === chosen ? lower : value));
    const others = parameters.flatMap((one, i) => (i === chosen ? [] : [`${one.name} = ${shown(values[i])}`]));
    return {...request, name, unit, P_most, value: values[chosen], others: others.join(', '), family, text: JSON.stringify(request)};
  }

  /// Has the map of the sliders' values made, in a worker. What is asked meanwhile is made after it.
  async compute() {
    if (this.waiting) return;
    const {text} = this.wanted();
    this.waiting = true;
    this.problem = null;
    try {
      const {regions} = await this.engine.map(text);
      this.known.set(text, regions);
      if (this.known.size > mostKept) this.known.delete(this.known.keys().next().value);
    } catch (error) {
      this.problem = {text, sentence: error.message};
    }
    this.waiting = false;
    this.models.drawAgain('map');
  }

  draw() {
    const wanted = this.wanted(), regions = this.known.get(wanted.text);
    if (regions) this.last = {regions, family: wanted.family};
    else if (this.problem?.text !== wanted.text) this.compute();
    // until the map is ready, shows that of earlier values of the other parameters, paler
    const drawn = this.last?.family === wanted.family ? this.last.regions : [];
    const regimes = [...new Set(drawn.map(one => one.regime))], single = regimes.length === 1;
    this.says.textContent = this.sentence(wanted, single ? regimes[0] : '', regions);
    this.figure.chart.getDom().hidden = single;
    if (!single) this.drawRegions(wanted, drawn, regimes, regions ? .25 : .1);
  }

  sentence({name, others, text}, only, known) {
    const where = others && `, with ${others}`;
    if (!known) return this.problem?.text === text ? `${where}: ${this.problem.sentence}.` : `${where} …`;
    if (!only) return `${where}.`;
    return `${where}: ${only.startsWith('n') ? `${only}, whatever the load and ${name}` : `one regime everywhere, ${only}`}.`;
  }

  drawRegions({model, name, value, unit, low, high, logarithmic, P_low, P_most}, regions, regimes, opacity) {
    const {state} = this.models, title = this.models.title(model), tint = regime => color(tintOfRegime[regime] ?? 7);
    const outlines = areas(regions.map(({regime, outline}) => ({name: regime, outline: outline.map(([P, at]) => [P * unit, at]), color: tint(regime), opacity})));
    const here = marks('here', `${title} here`, state.off.has(model) ? [] : [[state.P, value]], color(0), 'circle', {itemStyle: {color: color(0)}});
    this.figure.draw([...outlines, here], `Regimes of ${title} by load and ${name}: ${regimes.join(', ')}`, {
      legend: {data: regimes}, xAxis: {min: P_low * unit, max: Number((P_most * unit).toPrecision(2)), axisLabel: {showMinLabel: false}},
      yAxis: axis(name, {nameGap: 44, type: logarithmic ? 'log' : 'value', min: low, max: high}),
    });
  }
}
