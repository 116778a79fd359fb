// The options of the fit and the constants that have no field of their own: as text ("free=modulus; loss=huber"), as remedies
// that are followed, and as what can be undone. An experiment keeps them in `options` and `more`.
import {escape} from './answer.js';

const $ = id => document.getElementById(id);
const texts = {'fit-options': 'options', 'other-constants': 'more'};  // a field's id, and where its values are kept

const ofTheFile = ['shape', 'control', 'load_from'];  // constants that buttons set, and that can be undone like options

const textOf = values => Object.entries(values).map(([name, value]) => `${name}=${value}`).join('; ');

/// {name: value} of a text. A switch is stated by its name alone.
function optionsIn(text) {
  const stated = text.split(/;\s*/).map(one => one.trim()).filter(Boolean).map(one => /^([^=]*?)\s*(?:=\s*(.*))?$/.exec(one));
  return Object.fromEntries(stated.map(([, name, value = 'true']) => [name.replace(/^--/, ''), value.replace(/^"(.*)"$/, '$1')]));
}

/// Writes them into their fields, and a button for each that can be undone.
export function showOptions(experiment) {
  if (!experiment.options.exclude) delete experiment.options.exclude;
  for (const [id, key] of Object.entries(texts)) $(id).value = $(id).dataset.shown = textOf(experiment[key]);
  const stated = {...experiment.options, ...Object.fromEntries(ofTheFile.filter(name => /^(ellipse|approach)$|{P}/.test(experiment.more[name])).map(name => [name, experiment.more[name]]))};
  $('set-options').hidden = !Object.keys(stated).length;
  $('set-options').innerHTML = Object.entries(stated).map(([name, value]) => `<button type="button" data-without="${escape(name)}" aria-label="Undo ${escape(name)}">${escape(`${name} = ${value}`)} ✕</button>`).join(' ');
}

/// Takes what was typed into their fields.
export function takeOptions(experiment) {
  for (const [id, key] of Object.entries(texts)) if ($(id).value !== $(id).dataset.shown) experiment[key] = optionsIn($(id).value);
  showOptions(experiment);
}

/// Sets what a message recommends, and fits again.
export function follow(experiment, {option, value, adds, reads}) {
  takeOptions(experiment);
  const into = reads ? experiment.more : experiment.options, former = into[option];
  into[option] = adds && former ? `${former},${value}` : value;
  showOptions(experiment);
  return experiment.readAgain();
}

export function undo(experiment, option) {
  delete experiment.options[option];
  if (ofTheFile.includes(option)) delete experiment.more[option];
  if (option === 'exclude') experiment.kept = [];  // which are then found again
  showOptions(experiment);
  return experiment.readAgain();
}
