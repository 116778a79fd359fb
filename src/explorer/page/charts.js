// Figures by Apache ECharts: axes, hover, zoom, drag, SVG and PNG. The data come from the engine.
import * as echarts from 'echarts/core';
import {CustomChart, LineChart, ScatterChart} from 'echarts/charts';
import {DataZoomInsideComponent, GridComponent, LegendComponent, TooltipComponent} from 'echarts/components';
import {CanvasRenderer, SVGRenderer} from 'echarts/renderers';
import {tools} from './tools.js';

echarts.use([CustomChart, LineChart, ScatterChart, DataZoomInsideComponent, GridComponent,
  LegendComponent, TooltipComponent, CanvasRenderer, SVGRenderer]);

const charts = new Set();
const atOnce = 100;  // marks that are drawn one by one; more as one path, which is ten times as fast
export const token = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
export const color = i => token(`--color-${i}`);
export const colorOfModel = {a: 1, b: 2, c: 3, bk: 5}, ownColor = 4;  // of a law of the user's
const looks = ['circle', 'rect', 'triangle', 'diamond', 'arrow'];
/// Colour and mark of a run: 35 pairs, then the same ones filled.
export const lookOfRun = i => ({color: color(i % 7), symbol: looks[i % 5], filled: Math.floor(i / 35) % 2 === 1});

/// The page's fonts. Their names are in quotes that may stand in an attribute of a saved SVG.
export const fonts = () => getComputedStyle(document.body).fontFamily.replaceAll('"', "'");
export const star = 'path://M0-10L2.9-4L9.5-3.1L4.8 1.5L5.9 8.1L0 5L-5.9 8.1L-4.8 1.5L-9.5-3.1L-2.9-4Z';
export const degrees = psi => psi * 180 / Math.PI;
export const shown = (value, digits = 4) => value === 0 ? '0' : Number(value.toPrecision(digits)).toString();
/// mm^2 as mm².
export const squared = text => text.replaceAll('^2', '²');

/// All properties of an axis, since one that changes its type loses earlier settings.
export function axis(name, extra) {
  return {
    type: 'value', name, nameLocation: 'middle', nameGap: 28, scale: true,
    nameTextStyle: {color: token('--ink')}, axisLabel: {color: token('--soft'), hideOverlap: true, formatter: value => shown(value)},
    axisLine: {show: true, lineStyle: {color: token('--soft')}}, axisTick: {show: true},
    splitLine: {lineStyle: {color: token('--line')}}, ...extra,
  };
}

/// The top of the plot: below the key and a row for the text of each dashed line that can be dragged.
const topOf = ({rows = 0}) => 34 + 17 * rows;

/// A figure in the element `id` with axes of these names: {x: {name, min, ...}, y: {...}}. `more.rows`: dashed lines with a text.
export function figure(id, axes, more = {}) {
  const element = document.getElementById(id);
  const chart = echarts.init(element, null, {renderer: 'canvas'});
  const entry = {chart, axes, more, hovers: new Map(), handles: new Map()};  // hovers: what a series says of its points, point => HTML
  const frame = () => ({
    animation: false, textStyle: {fontFamily: fonts()},
    grid: {left: 62, right: 16, top: topOf(more), bottom: 46, ...more.grid},
    legend: {top: 0, formatter: name => brief(name, element.clientWidth), textStyle: {color: token('--ink')}, type: 'scroll', itemGap: 14, itemWidth: 16, itemHeight: 11, pageTextStyle: {color: token('--ink')}, pageIconColor: token('--ink'), pageIconInactiveColor: token('--line'), ...more.legend},
    tooltip: {trigger: 'item', confine: true, formatter: one => entry.hovers.get(one.seriesId)?.(one.dataIndex) ?? told(one)},
    dataZoom: [{type: 'inside', xAxisIndex: 0, zoomOnMouseWheel: 'shift', moveOnMouseWheel: false, filterMode: 'none'},
      {type: 'inside', yAxisIndex: axes.y2 ? [0, 1] : 0, zoomOnMouseWheel: 'shift', moveOnMouseWheel: false, filterMode: 'none'}],
    xAxis: axis(axes.x.name, axes.x), yAxis: axes.y2
      ? [axis(axes.y.name, {nameGap: 44, ...axes.y}), axis(axes.y2.name, {nameGap: 44, ...axes.y2, splitLine: {show: false}})]
      : axis(axes.y.name, {nameGap: 44, ...axes.y}),
  });
  entry.frame = () => chart.setOption(frame());
  entry.frame();
  entry.showAll = () => chart.dispatchAction({type: 'dataZoom', batch: [0, 1].map(i => ({dataZoomIndex: i, start: 0, end: 100}))});
  chart.getZr().on('dblclick', entry.showAll);
  chart.on('datazoom', () => entry.resized?.());
  tools(entry, element);
  new ResizeObserver(() => { chart.resize(); entry.resized?.(); }).observe(element);
  charts.add(entry);
  entry.draw = (series, label, extra = {}) => {
    entry.hovers = new Map(series.map(({id, hover}) => [id, hover]));
    entry.lines = series.filter(({type, yAxisIndex = 0}) => type === 'line' && yAxisIndex === 0);
    entry.names = {x: extra.xAxis?.name ?? axes.x.name, y: (extra.yAxis?.[0] ?? extra.yAxis)?.name ?? axes.y.name, y2: extra.yAxis?.[1]?.name};
    chart.setOption({...extra, series}, {replaceMerge: ['series']});
    element.setAttribute('aria-label', label);
  };
  return entry;
}

/// On a narrow figure the last of four models would be hidden.
const brief = (name, width) => (width < 460 ? name.replace(/^model /, '') : name);

function told({seriesName, value, data}) {
  if (data && data.hover) return data.hover;
  return Array.isArray(value) ? `${seriesName}<br>${value.map(v => shown(v, 5)).join(', ')}` : seriesName;
}

export const line = (id, name, data, color, type = 'solid', extra = {}) =>
  ({id, name, type: 'line', data, showSymbol: false, silent: true, color, lineStyle: {type, width: 2, color}, ...extra});
export const marks = (id, name, data, color, symbol, extra = {}) =>
  ({id, name, type: 'scatter', data, large: true, largeThreshold: atOnce, symbol, symbolSize: 9, color, itemStyle: {color: 'transparent', borderColor: color, borderWidth: 1.6}, ...extra});

/// Filled outlines: [{name, outline, color, opacity}].
export function areas(list) {
  return list.map(({name, outline, color, opacity = .25}, i) => ({
    id: `area-${i}`, name, type: 'custom', silent: true, color, data: [[outline[0][0], outline[0][1]]], encode: {x: 0, y: 1}, z: 0, clip: true,
    renderItem: (_, api) => ({type: 'polygon', shape: {points: outline.map(p => api.coord(p))}, style: {fill: color, opacity}}),
  }));
}

const queue = new Map();

/// Does one drawing a frame, so that the page can do other things between them. A later one of the same name replaces one
/// that waits.
export function inTurn(name, work) {
  if (!queue.size) requestAnimationFrame(drawNext);
  queue.set(name, work);
}

function drawNext() {
  const [name, work] = queue.entries().next().value;
  queue.delete(name);
  if (queue.size) requestAnimationFrame(drawNext);
  work();
}

/// A dashed line at x that can be dragged; calls `moved(x)` unless it hardly moved. `says`: the text beside it. It is no
/// part of the figure, so that moving it draws nothing else again. A line that is being dragged stays where it is.
export function handle(entry, id, x, moved, says = '', tint = token('--alert')) {
  const {chart, handles} = entry, place = chart.convertToPixel({xAxisIndex: 0}, x), bottom = 46, top = topOf(entry.more);
  let line = handles.get(id);
  if (line?.held) return;
  if (!line) {
    handles.set(id, line = new echarts.graphic.Line({draggable: 'horizontal', z: 100, cursor: 'ew-resize'}));
    line.setTextContent(new echarts.graphic.Text({z: 101, silent: true}));
    line.on('dragstart', () => { line.held = true; });
    line.on('dragend', () => {
      line.held = false;
      line.dropped();
    });
    chart.getZr().add(line);
  }
  line.attr({x: place, y: 0, ignore: !Number.isFinite(place), shape: {x1: 0, y1: top, x2: 0, y2: chart.getHeight() - bottom},
    style: {stroke: tint, lineWidth: 2, lineDash: [5, 4], lineCap: 'butt'}});
  const right = place > chart.getWidth() / 2;
  line.says = says;
  line.getTextContent().attr({style: {text: says, fill: tint, font: `12px ${fonts()}`, backgroundColor: token('--paper'),
    padding: [1, 3], align: right ? 'right' : 'left', verticalAlign: 'top'}});
  // above the plot, where no points are, each in a row of its own: on a phone two do not stand beside each other
  line.setTextConfig({position: [right ? -6 : 6, -17 * ([...handles.keys()].indexOf(id) + 1)], local: true});
  line.dropped = () => {
    if (Math.abs(line.x - place) < 3) entry.resized?.();
    else moved(chart.convertFromPixel({xAxisIndex: 0}, line.x));
  };
}

export function removeHandles({chart, handles}) {
  for (const line of handles.values()) chart.getZr().remove(line);
  handles.clear();
}

const dark = matchMedia('(prefers-color-scheme: dark)');
const drawnDark = () => document.documentElement.classList.toggle('drawn-dark', dark.matches);
drawnDark();

/// Called when the colours change: light, dark. Not by printing, which does not wait for pictures: the style sheet inverts
/// those that were drawn dark.
export function onTheme(redraw) {
  let printing = false, changed = false;
  const changes = () => {
    changed = printing;
    if (printing) return;
    drawnDark();
    for (const entry of charts) entry.frame();
    redraw();
  };
  dark.addEventListener('change', changes);
  addEventListener('beforeprint', () => { printing = true; });
  addEventListener('afterprint', () => {
    printing = false;
    if (changed && document.documentElement.classList.contains('drawn-dark') !== dark.matches) changes();
    changed = false;
  });
}
