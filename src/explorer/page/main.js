import {onTheme} from './charts.js';
import {loadEngine} from './engine.js';
import {Experiment} from './experiment.js';
import {laws, meaning} from './laws.js';
import {Models} from './models.js';
import {read} from './state.js';
import {sample} from './sample.js';

const bytesOf = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));

async function start() {
  const experiment = new Experiment();
  experiment.open(window.early.length ? window.early : [...document.getElementById('file').files]);  // given before this script ran
  document.querySelector('#meanings dl').innerHTML = Object.keys(laws).map(key => `<dt>${key}</dt><dd>${meaning(key)}</dd>`).join('');
  const engine = await loadEngine();
  document.getElementById('version').textContent = engine.version;
  const models = new Models(engine, read());
  experiment.begin(engine, models);
  onTheme(() => {
    models.redraw();
    experiment.figures.draw();
    experiment.cuts.drawAgain();
  });
  document.getElementById('sample').addEventListener('click', () => experiment.take(...sample()));
  // the report's data and the files beside them
  const reported = JSON.parse(document.getElementById('data').textContent) ?? [];
  const take = one => experiment.take([{name: one.name, bytes: bytesOf(one.content)}], {[one.name]: {bytes: bytesOf(one.toml)}}, one);
  if (reported.length) take(reported[0]);
  const choice = document.getElementById('reported');
  choice.hidden = reported.length < 2;
  for (const one of reported) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = one.name;
    button.addEventListener('click', () => take(one));
    choice.append(' ', button);
  }
  performance.mark('ready');
  if (!engine.files.busy) {  // otherwise the user's own files do it
    const [[table], beside] = sample();
    engine.warmUp({[table.name]: table.bytes, [table.name.replace('.csv', '.toml')]: beside[table.name].bytes});
  }
  window.explorer = {engine, models, experiment};  // for use from the browser's console
}

start().catch(error => {
  const told = document.createElement('p');
  told.className = 'banner';
  told.setAttribute('role', 'alert');
  told.textContent = `The engine could not be started: ${error.message}. A browser of 2023 or later is needed.`;
  document.querySelector('main').prepend(told);
});
