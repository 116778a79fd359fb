// What stands below every figure: the values under the pointer, and buttons that copy and save it. A saved figure begins with
// lines that name its model, lambda and data.
import * as echarts from 'echarts/core';
import {escape} from './answer.js';
import {fonts, shown, token} from './charts.js';
import {copied, offer} from './files.js';

const near = 12;  // px
const lineHeight = 18;

/// "A (mm²)" as {quantity: 'A', unit: ' mm²'}. Degrees follow the number without a blank.
function parts(name) {
  const [, quantity, unit = ''] = /^(.*?)(?: \(([^)]*)\))?$/.exec(name);
  return {quantity, unit: unit && (unit === '°' ? unit : ` ${unit}`)};
}

const equation = (name, value) => {
  const {quantity, unit} = parts(name);
  return `${quantity} = ${shown(value, 4)}${unit}`;
};

/// The place on a curve nearest to a pixel, if there is one: {name, at: [x, y], pixel}.
function onCurve({chart, lines = []}, x, y) {
  let best = null, least = near;
  for (const {name, data} of lines) {
    let last = null;
    for (const at of data) {
      const pixel = chart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, at);
      if (last) {
        const [[x1, y1], [x2, y2]] = [last.pixel, pixel], dx = x2 - x1, dy = y2 - y1, length = dx * dx + dy * dy;
        const part = length > 0 ? Math.min(Math.max(((x - x1) * dx + (y - y1) * dy) / length, 0), 1) : 0;
        const off = Math.hypot(x1 + part * dx - x, y1 + part * dy - y);
        if (off < least) {
          least = off;
          best = {name, at: [0, 1].map(i => last.at[i] + part * (at[i] - last.at[i])), pixel: [x1 + part * dx, y1 + part * dy]};
        }
      }
      last = {at, pixel};
    }
  }
  return best;
}

/// The sentence for the pointer at a pixel, and a dot on the curve that it is of.
function read(entry, dot, x, y) {
  const {chart, names} = entry;
  dot.attr({ignore: true});
  if (!names || !chart.containPixel({gridIndex: 0}, [x, y])) return '';
  const curve = onCurve(entry, x, y);
  if (curve) dot.attr({ignore: false, x: curve.pixel[0], y: curve.pixel[1], style: {fill: 'none', stroke: token('--ink'), lineWidth: 1.5}});
  const [atX, atY] = curve?.at ?? chart.convertFromPixel({xAxisIndex: 0, yAxisIndex: 0}, [x, y]);
  const second = names.y2 && !curve ? `, ${equation(names.y2, chart.convertFromPixel({xAxisIndex: 0, yAxisIndex: 1}, [x, y])[1])}` : '';
  return `${curve ? `${curve.name}: ` : ''}${equation(names.x, atX)}, ${equation(names.y, atY)}${second}`;
}

/// Adds them below the figure in `element`.
export function tools(entry, element) {
  const row = document.createElement('p'), label = element.id.replace('chart-', '');
  row.className = 'tools';
  row.innerHTML = `<output aria-live="off"></output><span>${[['copy', 'Copy'], ['png', 'PNG'], ['svg', 'SVG']]
    .map(([key, text]) => `<button type="button" data-figure="${key}" aria-label="${key === 'copy' ? 'Copy this figure' : `Save this figure as ${text}`}">${text}</button>`).join(' ')}</span>`;
  element.after(row);
  const says = row.querySelector('output'), dot = new echarts.graphic.Circle({shape: {r: 5}, z: 90, silent: true, ignore: true}), zr = entry.chart.getZr();
  zr.add(dot);
  let place = null;
  const show = () => {
    if (place) says.textContent = read(entry, dot, ...place);
    place = null;
  };
  for (const name of ['mousemove', 'click']) zr.on(name, event => {
    if (!place) requestAnimationFrame(show);
    place = [event.offsetX, event.offsetY];
  });
  zr.on('globalout', () => {
    place = null;
    says.textContent = '';
    dot.attr({ignore: true});
  });
  const {stem, lines} = {stem: () => label, lines: () => [], ...entry.more.about};
  const work = {
    copy: () => copied({'image/png': pngOf(entry, lines())}, says),
    png: async () => offer(`${stem()}_${label}.png`, 'image/png', await pngOf(entry, lines())),
    svg: () => offer(`${stem()}_${label}.svg`, 'image/svg+xml', svgOf(entry, lines())),
  };
  for (const button of row.querySelectorAll('button')) button.addEventListener('click', () => work[button.dataset.figure]());
}

/// Lines that fit in a width.
function wrapped(lines, pen, width) {
  return lines.flatMap(text => text.split(' ').reduce((all, word) => {
    const longer = all.length ? `${all.at(-1)} ${word}` : word;
    if (all.length && pen.measureText(longer).width <= width) return [...all.slice(0, -1), longer];
    return [...all, word];
  }, []));
}

function titled(chart, lines) {
  const pen = document.createElement('canvas').getContext('2d'), family = fonts();
  pen.font = `13px ${family}`;
  const all = wrapped(lines.filter(Boolean), pen, chart.getWidth() - 20);
  return {lines: all, head: all.length ? lineHeight * all.length + 10 : 0, family};
}

/// The figure as a file's text, in the page's colours.
function svgOf({chart}, about) {
  const {lines, head, family} = titled(chart, about), [width, height] = [chart.getWidth(), chart.getHeight()];
  const twin = echarts.init(null, null, {renderer: 'svg', ssr: true, width, height});
  twin.setOption({...chart.getOption(), backgroundColor: token('--paper'), animation: false});
  const text = twin.renderToSVGString().replace(/^<svg /, `<svg y="${head}" `);
  twin.dispose();
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height + head}" viewBox="0 0 ${width} ${height + head}">` +
    `<rect width="100%" height="100%" fill="${token('--paper')}"/>` +
    lines.map((one, i) => `<text x="10" y="${lineHeight * (i + 1)}" font-size="13" font-family="${family}" fill="${token('--ink')}">${escape(one)}</text>`).join('') + text + '</svg>';
}

/// The same as the bytes of a picture, three times as fine as the screen.
function pngOf({chart, handles}, about) {
  const ratio = 3, {lines, head, family} = titled(chart, about), hidden = on => [...handles.values()].forEach(line => [line, line.getTextContent()].forEach(one => one.attr({invisible: on})));
  hidden(true);
  const drawn = chart.renderToCanvas({pixelRatio: ratio, backgroundColor: token('--paper')});
  hidden(false);
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [drawn.width, drawn.height + ratio * head];
  const pen = canvas.getContext('2d');
  pen.fillStyle = token('--paper');
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(drawn, 0, ratio * head);
  pen.fillStyle = token('--ink');
  pen.font = `${13 * ratio}px ${family}`;
  lines.forEach((one, i) => pen.fillText(one, 10 * ratio, lineHeight * (i + 1) * ratio));
  return new Promise((resolve, reject) => canvas.toBlob(blob => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png'));
}
