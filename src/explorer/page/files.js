// Dropped and saved files, and line numbers as text.

import {storedIn} from './stored.js';

const textOf = file => new TextDecoder().decode(file.bytes);
const isToml = file => /\.toml$/i.test(file.name);
/// The name of the TOML beside a file.
export const besideOf = name => name.replace(/(\.[A-Za-z]\w*)?$/, '.toml');

/// Sorts dropped files: {data: [file], beside: {name of a data file: its TOML}, definition: of a fit, stored: results,
/// problem: why they are not used}. A TOML whose name is that of no data file states constants of all, as one beside the first does.
export async function parted(files) {
  const all = await Promise.all(files.map(async file => ({name: file.name.replaceAll('/', '_'), bytes: new Uint8Array(await file.arrayBuffer())})));
  const tomls = all.filter(isToml), definition = tomls.find(file => /^\s*(data\s*=|\[\[runs\]\])/m.test(textOf(file)));
  const results = all.filter(({name}) => /\.json$/i.test(name)).map(file => [file, storedIn(file)]).filter(([, stored]) => stored), stored = results.at(-1)?.[1];
  const data = all.filter(file => !isToml(file) && !results.some(([result]) => result === file)), other = data.find(({name}) => /\.(json|html?|svg|png|jpe?g|gif|pdf|docx?)$/i.test(name));
  const beside = {}, stray = [];
  for (const toml of tomls.filter(file => file !== definition)) {
    const of = data.find(({name}) => besideOf(name) === toml.name);
    if (of) beside[of.name] = toml;
    else stray.push(toml);
  }
  if (data.length && !beside[data[0].name] && stray.length) beside[data[0].name] = stray.shift();
  const problem = other ? `${other.name} is no table: drop the data as CSV, text or .xlsx, and with them a TOML if there is one.`
    : stray.length && data.length ? `${stray[0].name} has the name of no file of data: name it as the file that it belongs to.`
    : data.length || definition || stored ? '' : 'That is a TOML alone: drop the data with it.';
  return {data: data.sort((one, other) => one.name.localeCompare(other.name, 'en', {numeric: true})), beside, definition, stored, problem};
}

/// The file of a line that is counted through all `files` of a data set, and its number there; no name if there is one.
function placed(n, files = []) {
  const file = files.filter(({first_line}) => first_line < n).at(-1);
  return file ? {name: file.name, line: n - file.first_line} : {name: '', line: n};
}

/// "line 7", or "run_2.csv line 7".
export function lineText(n, files) {
  const {name, line} = placed(n, files);
  return name ? `${name} line ${line}` : `line ${line}`;
}

/// "4,7-9" of line numbers; "run_2.csv:4" of several files.
export function ranges(lines, files) {
  const parts = [];
  for (const n of [...lines].sort((x, y) => x - y)) {
    const {name, line} = placed(n, files), last = parts.at(-1);
    if (last && name === last.name && line === last.end + 1) last.end = line;
    else parts.push({name, begin: line, end: line});
  }
  return parts.map(({name, begin, end}) => `${name && `${name}:`}${begin === end ? begin : `${begin}-${end}`}`).join(',');
}

/// Whether a line is among those of such a text.
export function among(text, files) {
  const parts = text.split(',').filter(Boolean).map(part => /^(?:(.*):)?(\d+)(?:-(\d+))?$/.exec(part.trim())).filter(Boolean)
    .map(([, name = '', begin, end = begin]) => ({name, begin: Number(begin), end: Number(end)}));
  return n => {
    const {name, line} = placed(n, files);
    return parts.some(part => part.name === name && line >= part.begin && line <= part.end);
  };
}

/// What remains of runs without these lines: [first, last] of each, and the lines to leave out between them.
export function cropped(runs, text, files) {
  const out = among(text, files), kept = runs.map(({lines}) => {
    let first = 0, last = lines.length - 1;
    while (first < last && out(lines[first])) ++first;
    while (last > first && out(lines[last])) --last;
    return [first, last];
  });
  return {kept, between: ranges(runs.flatMap(({lines}, i) => lines.filter((n, k) => k >= kept[i][0] && k <= kept[i][1] && out(n))), files)};
}

/// Offers a file for download.
export function offer(name, type, content) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], {type}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/// Puts content on the clipboard, {type: bytes or a promise of them}, and says so in the element `says` for a while.
export async function copied(content, says) {
  const before = says.matches('button') ? says.textContent : '';
  try {
    await navigator.clipboard.write([new ClipboardItem(content)]);
    says.textContent = 'Copied';
  } catch (error) {
    says.textContent = `Not copied: the browser does not allow it (${error.message})`;
  }
  setTimeout(() => { says.textContent = before; }, 2000);
}
