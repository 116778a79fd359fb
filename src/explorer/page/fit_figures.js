// The figures of the user's file: all runs with the best model, and one run point by point, for cropping.
import {escape, named} from './answer.js';
import {areas, color, colorOfModel, figure, handle, line, marks, shown} from './charts.js';

const $ = id => document.getElementById(id);
const inBrackets = (name, unit) => unit ? `${name} (${unit.replace('^2', '²')})` : name;

/// `experiment`: what was read (told), which points are kept of each run, what was fitted (result).
export class FitFigures {
  constructor(experiment) {
    this.experiment = experiment;
    this.all = figure('chart-fit', {x: {name: 'T', min: 0}, y: {name: 'A', min: 0}});
    this.run = figure('chart-run', {x: {name: 'point'}, y: {name: 'T'}, y2: {name: 'A'}}, {grid: {right: 62}});
    this.all.resized = this.run.resized = () => this.placeHandles();
  }

  showAll() {
    for (const entry of [this.all, this.run]) entry.showAll();
  }

  clear() {
    for (const entry of [this.all, this.run]) {
      entry.draw([], 'Nothing is drawn', {legend: {data: []}});
      entry.chart.setOption({graphic: []}, {replaceMerge: ['graphic']});
    }
    $('caption-fit').textContent = '';
  }

  draw() {
    if (!this.experiment.whole) return;
    this.drawPoints();
    this.drawRun();
  }

  drawPoints() {
    const {told, kept, result} = this.experiment, best = result?.drawn.models[0], series = [];
    if (!told.runs) return this.drawEnergies(best);
    const {force, area} = told.units;
    told.runs.forEach((run, i) => {
      const own = color(i % 7), [first, last] = kept[i], fitted = best?.runs.find(one => Math.abs(one.P - run.P) <= 1e-9 * Math.abs(run.P));
      const name = inBrackets(`P = ${shown(run.P)}`, '');
      const hover = k => `line ${run.lines[k]}, ${escape(run.name || name)}<br>T = ${shown(run.T[k], 5)}, A = ${shown(run.A[k], 5)}`;
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
    this.all.draw(series, `Measured areas of ${told.runs.length} runs against tangential load${best ? named(` and model ${best.model}`) : ''}`,
      {legend: {data: told.runs.map(run => `P = ${shown(run.P)}`)}, xAxis: {name: inBrackets('T', force), type: 'value', min: 0, max: null}, yAxis: {name: inBrackets('A', area), min: 0, max: null}});
    $('caption-fit').textContent = best ? `${told.notice ? 'Reconstructed' : 'Measured'} areas, and ${named(`model ${best.model}`)} with a band of one standard error; triangles mark its jumps. Grey points are left out. Shift and the wheel zoom, a double click shows all.` : `${told.notice ? 'Reconstructed' : 'Measured'} areas.`;
    this.placeHandles();
  }

  drawEnergies(best) {
    const {told, result} = this.experiment, {psi, f} = told.energies;
    const series = [marks('points', told.notice ? 'reconstructed' : 'measured', psi.map((x, i) => [x, f[i]]), color(0), 'circle')];
    const most = 1.5 * Math.max(...f);
    for (const model of result?.drawn.models ?? []) series.push(line(`law-${model.model}`, named(`model ${model.model}`), model.toughness.filter(([, y]) => y <= most), color(colorOfModel[model.model] ?? 4), model === best ? 'solid' : 'dashed'));
    this.all.draw(series, 'Measured toughness against phase angle, and the models',
      {legend: {data: series.map(one => one.name)}, xAxis: {name: 'ψ (rad)', min: 0, max: 1.58}, yAxis: {name: 'Gc/GIc', min: 0, max: null}});
    this.all.chart.setOption({graphic: []}, {replaceMerge: ['graphic']});
    $('caption-fit').textContent = `${told.notice ? 'Reconstructed' : 'Measured'} toughness and the laws of the models.`;
  }

  drawRun() {
    const {told, kept} = this.experiment, run = told?.runs?.[this.experiment.selected()];
    if (!run) return;
    const [first, last] = kept[this.experiment.selected()], {force, area} = told.units;
    $('crop-first').value = first + 1;
    $('crop-last').value = last + 1;
    $('crop-first').max = $('crop-last').max = run.T.length;
    const style = (k, own) => k < first || k > last ? {color: color(7), borderColor: color(7), opacity: .5} : {color: 'transparent', borderColor: own};
    const series = (id, name, values, own, axis, symbol) => marks(id, name, values.map((y, k) => ({value: [k + 1, y], itemStyle: style(k, own), hover: `line ${run.lines[k]}<br>${name} = ${shown(y, 5)}`})), own, symbol, {yAxisIndex: axis, symbolSize: 6});
    this.run.draw([series('T', inBrackets('T', force), run.T, color(1), 0, 'rect'), series('A', inBrackets('A', area), run.A, color(2), 1, 'circle')],
      `Tangential load and area of run ${run.name} point by point`,
      {legend: {data: [inBrackets('T', force), inBrackets('A', area)]}, xAxis: {name: 'point, in the order of the file', min: 0, max: run.T.length + 1},
        yAxis: [{name: inBrackets('T', force)}, {name: inBrackets('A', area)}]});
    this.placeHandles();
  }

  /// Adds two marks to the figure of the run, and one for its end to the figure of all runs.
  placeHandles() {
    const {told, kept} = this.experiment, run = told?.runs?.[this.experiment.selected()];
    if (!run || !kept?.length) return;
    const [first, last] = kept[this.experiment.selected()];
    // among points at the same T, the one nearer to the last end of the run
    const off = (k, T) => Math.abs(Math.abs(run.T[k]) - T) + 1e-9 * Math.abs(T) * Math.abs(k - last);
    const nearest = T => run.T.reduce((best, _, k) => off(k, T) < off(best, T) ? k : best, last);
    this.run.chart.setOption({graphic: [handle(this.run, 'first', first + .5, x => this.experiment.crop(0, Math.round(x - .5))), handle(this.run, 'last', last + 1.5, x => this.experiment.crop(1, Math.round(x - 1.5)))]});
    this.all.chart.setOption({graphic: [handle(this.all, 'last', Math.abs(run.T[last]), T => this.experiment.crop(1, nearest(T)))]});
  }
}
