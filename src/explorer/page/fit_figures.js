// The figures of the user's file: all runs with the best model, and one run point by point, for cropping.
import {escape, named} from './answer.js';
import {lineText} from './files.js';
import {areas, color, colorOfModel, figure, handle, inTurn, line, marks, removeHandles, shown} from './charts.js';

const $ = id => document.getElementById(id);
/// Runs beyond the seventh have the colours again, and another mark.
const symbolOf = i => ['circle', 'rect', 'diamond', 'roundRect', 'arrow'][Math.floor(i / 7) % 5];
const inBrackets = (name, unit) => unit ? `${name} (${unit.replace('^2', '²')})` : name;

/// `experiment`: what was read (told), which points are kept of each run, what was fitted (result).
export class FitFigures {
  constructor(experiment) {
    this.experiment = experiment;
    this.all = figure('chart-fit', {x: {name: 'T', min: 0}, y: {name: 'A', min: 0}});
    this.run = figure('chart-run', {x: {name: 'point'}, y: {name: 'T'}, y2: {name: 'A'}}, {grid: {right: 62}});
    this.all.resized = () => this.placeEnd();
    this.run.resized = () => this.placeRunHandles();
  }

  showAll() {
    for (const entry of [this.all, this.run]) entry.showAll();
  }

  clear() {
    for (const entry of [this.all, this.run]) {
      entry.draw([], 'Nothing is drawn', {legend: {data: []}});
      removeHandles(entry);
    }
    $('caption-fit').textContent = '';
  }

  draw() {
    inTurn('points', () => this.drawPoints());
    inTurn('run', () => this.drawRun());
  }

  drawPoints() {
    if (!this.experiment.whole) return;
    const {told, kept, result} = this.experiment, best = result?.drawn.models[0], series = [];
    if (!told.runs) return this.drawEnergies(best);
    const {force, area} = told.units;
    told.runs.forEach((run, i) => {
      const own = color(i % 7), [first, last] = kept[i], fitted = best?.runs.find(one => Math.abs(one.P - run.P) <= 1e-9 * Math.abs(run.P));
      const name = `P = ${shown(run.P)}`, numbers = run.T.map((_, k) => k);
      const hover = k => `${escape(lineText(run.lines[k], told.files))}, ${escape(run.name || name)}<br>T = ${shown(run.T[k], 5)} ${escape(force)}, A = ${shown(run.A[k], 5)} ${escape(area)}`;
      const points = (id, shownOnes, tint, extra) => marks(id, name, shownOnes.map(k => [Math.abs(run.T[k]), run.A[k]]), tint, symbolOf(i), {hover: at => hover(shownOnes[at]), ...extra});
      series.push(points(`points-${i}`, numbers.filter(k => k >= first && k <= last), own, {symbolSize: 6}));
      series.push(points(`out-${i}`, numbers.filter(k => k < first || k > last), color(7), {symbolSize: 5, itemStyle: {color: color(7), opacity: .5}}));
      if (!fitted) return;
      series.push(line(`curve-${i}`, name, fitted.curve, own), line(`unstable-${i}`, name, fitted.unstable, own, 'dashed'), marks(`jump-${i}`, name, fitted.folds, own, 'triangle', {symbolSize: 11}));
      if (fitted.band.length > 1) {
        const [band] = areas([{name, outline: [...fitted.band.map(([T, low]) => [T, low]), ...[...fitted.band].reverse().map(([T, , high]) => [T, high])], color: own, opacity: .3}]);
        series.push({...band, id: `band-${i}`});
      }
    });
    this.all.draw(series, `Measured areas of ${told.runs.length} runs against tangential load${best ? named(` and model ${best.model}`) : ''}`,
      {legend: {data: told.runs.map(run => `P = ${shown(run.P)}`)}, xAxis: {name: inBrackets('T', force), type: 'value', min: 0, max: null}, yAxis: {name: inBrackets('A', area), min: 0, max: null}});
    $('caption-fit').textContent = best ? `${told.notice ? 'Reconstructed' : 'Measured'} areas, and ${named(`model ${best.model}`)} with a band of one standard error; triangles mark its jumps. Grey points are left out. Shift and the wheel zoom, a double click shows all.` : `${told.notice ? 'Reconstructed' : 'Measured'} areas.`;
    this.placeEnd();
  }

  drawEnergies(best) {
    const {told, result} = this.experiment, {psi, f} = told.energies;
    const series = [marks('points', told.notice ? 'reconstructed' : 'measured', psi.map((x, i) => [x, f[i]]), color(0), 'circle')];
    const most = 1.5 * Math.max(...f);
    for (const model of result?.drawn.models ?? []) series.push(line(`law-${model.model}`, named(`model ${model.model}`), model.toughness.filter(([, y]) => y <= most), color(colorOfModel[model.model] ?? 4), model === best ? 'solid' : 'dashed'));
    this.all.draw(series, 'Measured toughness against phase angle, and the models',
      {legend: {data: series.map(one => one.name)}, xAxis: {name: 'ψ (rad)', min: 0, max: 1.58}, yAxis: {name: 'Gc/GIc', min: 0, max: null}});
    removeHandles(this.all);
    $('caption-fit').textContent = `${told.notice ? 'Reconstructed' : 'Measured'} toughness and the laws of the models.`;
  }

  drawRun() {
    const {told, kept} = this.experiment, run = told?.runs?.[this.experiment.selected()];
    if (!run) return;
    const [first, last] = kept[this.experiment.selected()], {force, area} = told.units;
    $('crop-first').value = first + 1;
    $('crop-last').value = last + 1;
    $('crop-first').max = $('crop-last').max = run.T.length;
    const of = (id, name, unit, values, own, axis, symbol) => [true, false].map(isKept => {
      const numbers = values.map((_, k) => k).filter(k => (k >= first && k <= last) === isKept);
      return marks(`${id}-${isKept ? 'kept' : 'out'}`, inBrackets(name, unit), numbers.map(k => [k + 1, values[k]]), isKept ? own : color(7), symbol,
        {yAxisIndex: axis, symbolSize: 6, hover: at => `${escape(lineText(run.lines[numbers[at]], told.files))}<br>${name} = ${shown(values[numbers[at]], 5)} ${escape(unit)}`,
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
    return run && kept?.length ? {run, first: kept[at][0], last: kept[at][1]} : null;
  }

  /// Two marks in the figure of the run.
  placeRunHandles() {
    const chosen = this.chosen();
    if (!chosen) return;
    const {first, last} = chosen;
    handle(this.run, 'first', first + .5, x => this.experiment.crop(0, Math.round(x - .5)));
    handle(this.run, 'last', last + 1.5, x => this.experiment.crop(1, Math.round(x - 1.5)));
  }

  /// One for the end of the run in the figure of all runs.
  placeEnd() {
    const chosen = this.chosen();
    if (!chosen) return;
    const {run, last} = chosen;
    // among points at the same T, the one nearer to the last end of the run
    const off = (k, T) => Math.abs(Math.abs(run.T[k]) - T) + 1e-9 * Math.abs(T) * Math.abs(k - last);
    const nearest = T => run.T.reduce((best, _, k) => off(k, T) < off(best, T) ? k : best, last);
    handle(this.all, 'last', Math.abs(run.T[last]), T => this.experiment.crop(1, nearest(T)));
  }
}
