// The figures of the user's file: all runs with a model, its residuals and axes, and one run point by point, for cropping.
import {escape, named} from './answer.js';
import {among, lineText} from './files.js';
import {areas, color, colorOfModel, degrees, figure, handle, inTurn, line, lookOfRun, marks, ownColor, removeHandles, shown, squared, star} from './charts.js';
import {laws} from './laws.js';

const $ = id => document.getElementById(id);
const every = 'all';  // the choice of all models at once
const inBrackets = (name, unit) => unit ? `${name} (${squared(unit)})` : name;
const withUnit = (value, unit) => `${value}${unit && ` ${squared(unit)}`}`;

/// `experiment`: what was read (told), which points are kept of each run, what was fitted (result).
export class FitFigures {
  constructor(experiment) {
    this.experiment = experiment;
    const about = {stem: () => experiment.stem(), lines: () => this.about()};
    this.all = figure('chart-fit', {x: {name: 'T', min: 0}, y: {name: 'A', min: 0}}, {rows: 1, about});
    this.residuals = figure('chart-residuals', {x: {name: 'T', min: 0}, y: {name: 'residual'}}, {about, legend: {show: false}, grid: {top: 14}});
    this.axes = figure('chart-axes', {x: {name: 'T', min: 0}, y: {name: 'a/b'}}, {about});
    this.pullOff = figure('chart-pull-off', {x: {name: 'T', min: 0}, y: {name: 'P'}}, {about});
    this.run = figure('chart-run', {x: {name: 'point'}, y: {name: 'T'}, y2: {name: 'A'}}, {rows: 2, grid: {right: 62}, about});
    this.all.resized = () => this.placeEnd();
    this.run.resized = () => this.placeRunHandles();
    this.model = $('drawn-model');
    this.model.addEventListener('change', () => this.draw());
    this.all.chart.on('click', ({seriesId}) => {
      const run = /^(?:points|out)-(\d+)$/.exec(seriesId)?.[1];
      if (run) experiment.select(run);
    });
  }

  showAll() {
    for (const entry of [this.all, this.run, this.residuals, this.axes, this.pullOff]) entry.showAll();
  }

  clear() {
    for (const entry of [this.all, this.run, this.residuals, this.axes, this.pullOff]) {
      entry.draw([], 'Nothing is drawn', {legend: {data: []}});
      removeHandles(entry);
    }
    $('caption-fit').textContent = '';
    this.offered = '';
  }

  /// Offers the fitted models, the best one first.
  offer() {
    const models = this.experiment.result?.drawn.models.map(({model}) => model) ?? [], text = models.join();
    if (text === this.offered) return;
    this.offered = text;
    const all = models.length > 1 ? [[every, 'all models']] : [];
    this.model.replaceChildren(...[...models.map((model, i) => [model, `${named(`model ${model}`)}${i === 0 && models.length > 1 && !this.experiment.result.answer.doubt ? ', the best' : ''}`]), ...all].map(([value, label]) => new Option(label, value)));
  }

  /// The models that are drawn: all, or the chosen one.
  chosenModels() {
    const models = this.experiment.result?.drawn.models ?? [];
    if (this.model.value === every) return models;
    return models.filter(({model}, i) => (this.model.value ? model === this.model.value : i === 0));
  }

  draw() {
    this.offer();
    inTurn('points', () => this.drawPoints());
    inTurn('run', () => this.drawRun());
    inTurn('residuals', () => this.drawResiduals());
    inTurn('axes', () => this.drawAxes());
    inTurn('pull-off', () => this.drawPullOff());
  }

  /// The lines at the top of a saved figure: data, model, parameters and constants.
  about() {
    const {experiment} = this, {result, told} = experiment, fits = result?.fits.datasets[0].fits ?? [];
    const of = fits.filter(fit => this.chosenModels().some(({model}) => model === fit.model)).map(fit => `${this.title(fit)}${laws[fit.model] ? `, ${laws[fit.model].name}` : ''}: ` +
      result.parameters[fit.model].join(', ') + ` (${fit.status.replaceAll('_', ' ')})`);
    const constants = Object.entries({R: 'radius', 'E*': 'modulus', G_Ic: 'toughness'}).filter(([, name]) => told?.constants[name]).map(([short, name]) => `${short} = ${squared(told.constants[name].shown)}`);
    return [experiment.name + (told?.notice ? ' (reconstructed, not measured)' : ''), ...of, constants.join(', ')];
  }

  /// The name of a run in keys: its load or held approach, and its own name where another run has the same load.
  runName(i) {
    const {told} = this.experiment, {name: held, unit} = told.held, name = k => withUnit(`${held} = ${shown(told.runs[k].P)}`, unit);
    const twice = told.runs.some((_, k) => k !== i && name(k) === name(i));
    return twice && told.runs[i].name ? `${name(i)} (${told.runs[i].name})` : name(i);
  }

  /// The same with the run's own name, unless that is the load, too.
  runTitle(i) {
    const {name} = this.experiment.told.runs[i], title = this.runName(i);
    return !name || title.endsWith(`(${name})`) || /^P ?= ?[-\d.e]+ \S/.test(name) ? title : `${title} (${name})`;
  }

  /// What is said of the point k of the run i.
  hover(i, k) {
    const {told} = this.experiment, run = told.runs[i], {force, area} = told.units;
    return `${escape(lineText(run.lines[k], told.files))}, ${escape(run.name || this.runName(i))}<br>T = ${escape(withUnit(shown(run.T[k], 5), force))}, A = ${escape(withUnit(shown(run.A[k], 5), area))}`;
  }

  /// Whether a point of the run i is fitted.
  keeps(i) {
    const {told, kept, options} = this.experiment, out = among(options.exclude ?? '', told.files), [first, last] = kept[i];
    return k => k >= first && k <= last && !out(told.runs[i].lines[k]);
  }

  drawPoints() {
    if (!this.experiment.whole) return;
    const {told, result} = this.experiment, models = this.chosenModels(), series = [], several = models.length > 1;
    if (!told.runs) return this.drawEnergies(models);
    const {force, area} = told.units, selected = this.experiment.selected();
    told.runs.forEach((run, i) => {
      const look = lookOfRun(i), {symbol, filled} = look, own = several ? color(0) : look.color, keeps = this.keeps(i), name = this.runName(i), numbers = run.T.map((_, k) => k);
      const points = (id, shownOnes, tint, extra) => marks(id, name, shownOnes.map(k => [Math.abs(run.T[k]), run.A[k]]), tint, symbol, {hover: at => this.hover(i, shownOnes[at]), ...extra});
      series.push(points(`points-${i}`, numbers.filter(keeps), own, {symbolSize: i === selected ? 8 : 6, ...(filled ? {itemStyle: {color: own}} : {})}));
      series.push(points(`out-${i}`, numbers.filter(k => !keeps(k)), color(7), {symbolSize: 5, itemStyle: {color: color(7), opacity: .5}}));
      for (const model of models) {
        const tint = several ? this.tint(model) : own, key = several ? `${i}-${model.model}` : i, label = several ? this.title(model) : name;
        const fitted = model.runs.find(one => Math.abs(one.P - run.P) <= 1e-9 * Math.abs(run.P));
        if (!fitted) continue;
        series.push(line(`curve-${key}`, label, fitted.curve, tint), line(`unstable-${key}`, label, fitted.unstable, tint, 'dashed'),
          marks(`jump-${key}`, label, fitted.folds, tint, star, {symbolSize: 13, itemStyle: {color: tint}}));
        if (several || fitted.band.length < 2) continue;
        const [band] = areas([{name, outline: [...fitted.band.map(([T, low]) => [T, low]), ...[...fitted.band].reverse().map(([T, , high]) => [T, high])], color: own, opacity: .3}]);
        series.push({...band, id: `band-${i}`});
      }
    });
    const titles = models.map(one => this.title(one));
    this.all.draw(series, `Measured areas of ${told.runs.length} runs against tangential load${titles.length ? ` and ${titles.join(', ')}` : ''}`,
      {legend: {data: [...(several ? titles : []), ...told.runs.map((_, i) => this.runName(i))]},
        xAxis: {name: inBrackets('T', force), type: 'value', min: 0, max: several && told.runs.length ? Number((1.5 * Math.max(...told.runs.flatMap(({T}) => T.map(Math.abs)))).toPrecision(2)) : null}, yAxis: {name: inBrackets('A', area), min: 0, max: null}});
    const word = told.notice ? 'Reconstructed' : 'Measured';
    $('caption-fit').textContent = result ? `${word} areas and ${titles.join(', ')}${several ? '' : ' with a band of one standard error'}. Stars mark jumps. Grey points are left out. Click a point to select its run. Shift and the wheel zoom, a double click shows all.` : `${word} areas.`;
    this.placeEnd();
  }

  title({model}) { return named(`model ${model}`); }
  tint({model}) { return color(colorOfModel[model.replace(/-ellipse.*/, '')] ?? ownColor); }

  drawEnergies(models) {
    const {told} = this.experiment, {psi} = told.energies, word = told.notice ? 'reconstructed' : 'measured', over = models[0]?.over ?? [];
    const f = told.energies.f.map((ratio, i) => ratio * (over[i] ?? 1)), by = over.some(factor => factor !== 1) ? ` Points are over the toughness that ${this.title(models[0])} found.` : '';
    const series = [marks('points', word, psi.map((x, i) => [degrees(x), f[i]]), color(0), 'circle', {hover: k => `${escape(lineText(told.energies.lines[k], told.files))}<br>ψ = ${shown(degrees(psi[k]), 4)}°, Gc/GIc = ${shown(f[k], 4)}`})];
    const most = 1.5 * Math.max(...f);
    for (const model of models) series.push(line(`law-${model.model}`, this.title(model), model.toughness.filter(([, y]) => y <= most).map(([x, y]) => [degrees(x), y]), this.tint(model)));
    this.all.draw(series, 'Measured toughness against phase angle, and the models',
      {legend: {data: series.map(one => one.name)}, xAxis: {name: 'ψ (°)', min: 0, max: 90}, yAxis: {name: 'Gc/GIc', min: 0, max: null}});
    removeHandles(this.all);
    $('caption-fit').textContent = `${word.replace(/^./, first => first.toUpperCase())} toughness and the laws of the models.${by}`;
  }

  drawResiduals() {
    const models = this.chosenModels(), {told} = this.experiment, points = models.flatMap(model => model.residuals.map(one => [model, ...one]));
    $('residuals').hidden = !points.length;
    if (!points.length) return;
    const x = value => (told.runs ? Math.abs(value) : degrees(value)), several = models.length > 1, groups = new Map();
    for (const one of points) {
      const key = several ? one[0].model : one[1];
      groups.set(key, [...(groups.get(key) ?? []), one]);
    }
    const name = told.runs ? inBrackets('T', told.units.force) : 'ψ (°)', unit = models[0].residual_unit;
    const series = [...groups].map(([key, all], n) => {
      const look = several ? {color: this.tint(all[0][0]), symbol: 'circle'} : lookOfRun(told.runs ? key : n);
      const title = several ? this.title(all[0][0]) : told.runs ? this.runName(key) : this.title(all[0][0]);
      return marks(`residuals-${key}`, title, all.map(([, , at, residual]) => [x(at), residual]), look.color, look.symbol, {symbolSize: 6,
        hover: k => `${escape(lineText(all[k][4], told.files))}, ${escape(title)}<br>${told.runs ? escape(`T = ${withUnit(shown(x(all[k][2]), 4), told.units.force)}`) : `ψ = ${shown(x(all[k][2]), 4)}°`}, residual ${shown(all[k][3], 3)} (${unit})`});
    });
    const most = Math.max(...points.map(([, , at]) => x(at)));
    this.residuals.draw([...series, line('zero', 'zero', [[0, 0], [most, 0]], color(7), 'dashed')], `Residuals of ${models.map(one => this.title(one)).join(', ')}`,
      {xAxis: {name, min: 0, max: null}, yAxis: {name: `residual (${unit})`}});
    $('caption-residuals').textContent = `Residuals, model minus data, of ${models.map(one => this.title(one)).join(', ')}. They should scatter about zero without a trend.`;
  }

  /// The ratio of the axes of elliptic contacts: measured, and of a model of ellipses.
  drawAxes() {
    const {told} = this.experiment, runs = told?.runs ?? [], models = this.chosenModels().filter(({runs: all}) => all?.some(({axes}) => axes));
    const there = runs.some(({axes}) => axes) || models.length > 0;
    $('axes').hidden = !there;
    if (!there) return;
    const series = runs.flatMap((run, i) => {
      const {color: own, symbol} = lookOfRun(i), numbers = run.T.map((_, k) => k).filter(k => run.axes && run.axes[k] !== null);
      const fitted = models[0]?.runs.find(one => Math.abs(one.P - run.P) <= 1e-9 * Math.abs(run.P));
      return [marks(`axes-${i}`, this.runName(i), numbers.map(k => [Math.abs(run.T[k]), run.axes[k]]), own, symbol, {symbolSize: 6, hover: at => `${this.hover(i, numbers[at])}<br>a/b = ${shown(run.axes[numbers[at]], 4)}`}),
        ...(fitted?.axes ? [line(`axes-curve-${i}`, this.runName(i), fitted.axes, own)] : [])];
    });
    this.axes.draw(series, 'Ratio of the axes of the contact against tangential load', {legend: {data: runs.map((_, i) => this.runName(i))}, xAxis: {name: inBrackets('T', told.units.force), min: 0, max: null}});
    $('caption-axes').textContent = `Axes of the contact along (a) and across (b) the shear${models.length ? `: measured, and of ${this.title(models[0])}` : ', as measured. “Fit an ellipse” under “More of the fit” fits both'}.`;
  }

  /// Loads at which sheared contacts were pulled off: measured, and of the models.
  drawPullOff() {
    const {told, whole} = this.experiment, all = whole && told.pull_off;
    $('pull-off').hidden = !all;
    $('figure-fit').hidden = Boolean(all) && !told.points;
    if (!all) return;
    const word = told.notice ? 'reconstructed' : 'measured', {points, held, unit} = all, {force} = told.units;
    const series = [marks('pull-off', word, points.map(([shear, P]) => [shear, P]), color(0), 'circle', {hover: k => `${escape(lineText(points[k][2], told.files))}<br>${held} = ${escape(withUnit(shown(points[k][0], 5), unit))}, P = ${escape(withUnit(shown(points[k][1], 5), force))}`}),
      ...this.chosenModels().filter(({pull_off: curve}) => curve).map(model => line(`pull-off-${model.model}`, this.title(model), model.pull_off, this.tint(model)))];
    this.pullOff.draw(series, 'Pull-off load against shear, and the models', {legend: {data: series.map(({name}) => name)},
      xAxis: {name: inBrackets(held, unit), min: 0}, yAxis: {name: inBrackets('P', force)}});
    $('caption-pull-off').textContent = 'Loads at which the contact was pulled off; compression is positive. Below the curve there is no contact.';
  }

  drawRun() {
    const {told, kept} = this.experiment, at = this.experiment.selected(), run = told?.runs?.[at];
    if (!run || !kept.length) return;
    const [first, last] = kept[at], keeps = this.keeps(at), {force, area} = told.units;
    $('crop-first').value = first + 1;
    $('crop-last').value = last + 1;
    $('crop-first').max = $('crop-last').max = run.T.length;
    const of = (id, name, unit, values, own, axis, symbol) => [true, false].map(isKept => {
      const numbers = values.map((_, k) => k).filter(k => keeps(k) === isKept);
      return marks(`${id}-${isKept ? 'kept' : 'out'}`, inBrackets(name, unit), numbers.map(k => [k + 1, values[k]]), isKept ? own : color(7), symbol,
        {yAxisIndex: axis, symbolSize: 6, hover: k => `${escape(lineText(run.lines[numbers[k]], told.files))}<br>${name} = ${escape(withUnit(shown(values[numbers[k]], 5), unit))}`,
          ...(isKept ? {} : {itemStyle: {color: color(7), opacity: .5}})});
    });
    this.run.draw([...of('T', 'T', force, run.T, color(1), 0, 'rect'), ...of('A', 'A', area, run.A, color(2), 1, 'circle')],
      `Tangential load and area of run ${run.name} point by point`,
      {legend: {data: [inBrackets('T', force), inBrackets('A', area)]}, xAxis: {name: 'point, in the order of the file', min: 0, max: run.T.length + 1},
        yAxis: [{name: inBrackets('T', force)}, {name: inBrackets('A', area)}]});
    this.placeRunHandles();
  }

  /// The chosen run and the points that are kept of it; null if there is none.
  chosen() {
    const {told, kept, whole} = this.experiment, at = this.experiment.selected(), run = whole && told?.runs?.[at];
    return run && kept?.length ? {run, first: kept[at][0], last: kept[at][1], name: this.runName(at), tint: lookOfRun(at).color} : null;
  }

  /// Two marks in the figure of the run.
  placeRunHandles() {
    const chosen = this.chosen();
    if (!chosen) return;
    const {first, last, name, tint} = chosen;
    handle(this.run, 'first', first + .5, x => this.experiment.crop(0, Math.round(x - .5)), `${name} from here`, tint);
    handle(this.run, 'last', last + 1.5, x => this.experiment.crop(1, Math.round(x - 1.5)), 'to here', tint);
  }

  /// One for the end of the run in the figure of all runs.
  placeEnd() {
    const chosen = this.chosen();
    if (!chosen) return;
    const {run, last, name, tint} = chosen;
    // among points at the same T, the one nearer to the last end of the run
    const off = (k, T) => Math.abs(Math.abs(run.T[k]) - T) + 1e-9 * Math.abs(T) * Math.abs(k - last);
    const nearest = T => run.T.reduce((best, _, k) => off(k, T) < off(best, T) ? k : best, last);
    handle(this.all, 'last', Math.abs(run.T[last]), T => this.experiment.crop(1, nearest(T)), `cuts ${name}`, tint);
  }
}
