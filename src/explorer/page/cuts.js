// The loading runs of a log: T and A over time with the cuts, one run at a time, and a table of all.
import {escape} from './answer.js';
import {areas, figure, inTurn, line, marks, shown, token} from './charts.js';

const $ = id => document.getElementById(id);
const inside = {showMinLabel: false, showMaxLabel: false};  // of axes that end where the figure of the report does
const tint = color => token(/--[\w-]+/.exec(color)?.[0] ?? '--ink');
/// "T [mN]" as the axes of the other figures: "T (mN)".
const named = label => label.replace(/ \[(.*)\]$/, (_, unit) => ` (${unit.replace('^2', '²')})`);

export class Cuts {
  /// `name()`: of the log that is read.
  constructor(name) {
    const about = {stem: () => name().replace(/\.[^.]*$/, ''), lines: () => [`${name()}, run ${this.log?.runs[Number($('log-run').value)]?.name ?? ''}`]};
    this.charts = {T: figure('chart-log-T', {x: {name: 't (s)'}, y: {name: 'T'}}, {about}), A: figure('chart-log-A', {x: {name: 't (s)'}, y: {name: 'A'}}, {about})};
    $('log-run').addEventListener('change', () => this.drawAgain());
  }

  /// `log`: what the engine's `cut` returns.
  draw(log) {
    this.log = log;
    $('log').hidden = false;
    $('log-says').textContent = log.text.replaceAll(/\[\[|\]\]/g, '');
    $('log-run').innerHTML = log.runs.map((run, i) => `<option value="${i}">${escape(run.name)}</option>`).join('');
    $('log-runs').innerHTML = table(log);
    this.drawAgain();
  }

  drawAgain() {
    if (!this.log) return;
    const drawn = this.log.figures[Number($('log-run').value)];
    for (const [name, entry] of Object.entries(this.charts)) {
      const {title, x, y, series, caption} = drawn[name];
      inTurn(`log-${name}`, () => entry.draw(series.map(asDrawn), title, {legend: {data: [...new Set(series.map(({label}) => label).filter(Boolean))]},
        xAxis: {name: named(x[0]), min: x[1], max: x[2], axisLabel: inside}, yAxis: {name: named(y[0]), min: y[1], max: y[2], axisLabel: inside}}));
      $(`caption-log-${name}`).textContent = caption;
    }
  }
}

/// A series of a figure of the report. Shaded areas lie below, the readings are small.
function asDrawn({label, look, color, points}, i) {
  const own = tint(color), name = label || ' ';
  if (look === 'band') return {...areas([{name, outline: points, color: own, opacity: label ? .16 : .35}])[0], id: `series-${i}`};
  if (look === 'line') return line(`series-${i}`, name, points, own, 'dashed', {lineStyle: {type: 'dashed', width: 1.5, color: own}});
  return label ? marks(`series-${i}`, name, points, own, look, {symbolSize: 11, z: 3})
    : marks(`series-${i}`, name, points, own, look, {symbolSize: 3, itemStyle: {color: own, opacity: .7}});
}

/// A time, and its 95 % interval with the digits that this has.
function at({time, low, high, stated}) {
  if (stated || !(high > low)) return `${shown(time, 6)}${stated ? ' as stated' : ''}`;
  const digits = Math.min(Math.max(Math.ceil(.9 - Math.log10(high - low)), 0), 9);
  return `${time.toFixed(digits)} (${low.toFixed(digits)} … ${high.toFixed(digits)})`;
}

function table({runs, units}) {
  const row = run => `<tr><th scope="row">${escape(run.name)}</th>
    <td data-label="shear from (s)">${at(run.shear)}</td><td data-label="sliding from (s)">${run.onset ? at(run.onset) : 'not seen'}</td>
    <td data-label="largest T">${shown(run.T)} ${escape(units.force)}</td><td data-label="falls of T">${run.falls}</td><td data-label="points">${run.frames}</td></tr>`;
  return `<table class="fits"><thead><tr><th>run</th><th>shear from (s), 95 %</th><th>sliding from (s), 95 %</th><th>largest T</th><th>falls of T</th><th>points</th></tr></thead>
    <tbody>${runs.map(row).join('')}</tbody></table>`;
}
