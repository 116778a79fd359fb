// The engine for browsers, in Node, against the program: areas to 1e-12, lambda to 1e-9 of itself, on the shipped sets, on
// runs in several files, workbooks, and the loading runs of logs. Of build/explorer/engine.js, or of the page that is named.
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const {workbookOf} = require('./workbook.js');
const {gunzipSync} = require('zlib');
const {execFileSync} = require('child_process');
const root = path.resolve(__dirname, '../..');
const program = path.join(root, 'build/release/src/mixity');
delete globalThis.fetch;  // Emscripten of Debian 12 takes it for a browser's, which knows data: addresses
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'mixity-numbers-'));
const failures = [];
const expect = (holds, message) => { if (!holds) failures.push(message); };

function run(words) {
  try {
    return execFileSync(program, words, {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
  } catch (ended) { // 1: a fit that cannot be believed
    return ended.stdout;
  }
}

function compareAreas(engine) {
  let worst = 0;
  for (const [model, lambda] of [['a', 0.3], ['b', 0.1], ['c', 0.01], ['c', 0.9]])
    for (const P of [-2, 0, 5, 30]) {
      const T = [0, 0.5, 3, 9, 15, 40], n = T.length;
      const at = engine._malloc(16 * n), parameters = new engine.Doubles();
      parameters.push_back(lambda);
      engine.HEAPF64.set(T, at / 8);
      engine.areas(model, parameters, P, at, at + 8 * n, n);
      const ours = Array.from(engine.HEAPF64.subarray(at / 8 + n, at / 8 + 2 * n));
      const rows = run(['predict', `--model=${model}`, `--lambda=${lambda}`, `--load=${P}`, `--shear=${T}`]).trim().split('\n').slice(1);
      rows.forEach((row, i) => {
        const theirs = row.split(',')[4];
        expect((theirs === '') === Number.isNaN(ours[i]), `${model} ${lambda} P = ${P}, T = ${T[i]}: ${ours[i]} against '${theirs}'`);
        if (theirs !== '') worst = Math.max(worst, Math.abs(ours[i] / Number(theirs) - 1));
      });
      engine._free(at);
      parameters.delete();
    }
  expect(worst < 1e-12, `areas differ by ${worst}`);
  return worst;
}

const fit = (engine, names, constants, options, told = () => {}) => JSON.parse(engine.fit(JSON.stringify(names), JSON.stringify(constants), JSON.stringify(options), told));

/// Compares the fits of the engine with those of the program; returns the largest relative difference of a parameter.
function compare(told, theirs, where) {
  if (told.error) {
    failures.push(`${where}: ${told.error}`);
    return 0;
  }
  let worst = 0;
  const ours = told.fits.datasets[0].fits;
  expect(ours.length === theirs.length, `${where}: ${ours.length} fits, not ${theirs.length}`);
  ours.forEach((fit, i) => {
    const other = theirs[i];
    expect(fit.status === other.status, `${where} ${fit.model}: ${fit.status}, not ${other.status}`);
    for (const [key, parameter] of Object.entries(fit.parameters)) {
      const theirsOf = other.parameters[key];
      if (!theirsOf) { failures.push(`${where} ${fit.model}: no ${key} among ${Object.keys(other.parameters)}`); continue; }
      if (theirsOf.value) worst = Math.max(worst, Math.abs(parameter.value / theirsOf.value - 1));
      expect((parameter.value === null) === (theirsOf.value === null), `${where} ${fit.model} ${key}`);
      for (const end of ['low', 'high'])
        if (parameter.interval && parameter.interval[end])
          expect(Math.abs(parameter.interval[end] / theirsOf.interval[end] - 1) < 1e-6, `${where} ${fit.model}: interval ${end}`);
    }
  });
  return worst;
}

const fitsOf = words => JSON.parse(run(['fit', ...words, '--format=json'])).datasets[0].fits;

function compareFits(engine) {
  let worst = 0, longest = 0;
  for (const name of ['mergel2018', 'waters_guduru2010', 'as4_peek_mmb'])
    for (const objective of name === 'mergel2018' ? ['curve', 'toughness'] : ['toughness']) {
      const file = path.join(root, 'data', name + '.csv');
      const models = name === 'as4_peek_mmb' ? 'bk' : 'a,b,c';
      engine.write(`${name}.toml`, fs.readFileSync(file.replace('.csv', '.toml')));
      engine.write(`${name}.csv`, fs.readFileSync(file));
      const begin = performance.now(), parts = [];
      const told = fit(engine, [`${name}.csv`], {}, {models, objective}, part => parts.push(part));
      longest = Math.max(longest, performance.now() - begin);
      expect(parts.length > 1 && parts.every((part, i) => part >= (parts[i - 1] ?? 0)) && parts.at(-1) === 1, `${name}: the parts done are ${parts}`);
      worst = Math.max(worst, compare(told, fitsOf([file, `--models=${models}`, `--objective=${objective}`]), `${name} ${objective}`));
    }
  expect(worst < 1e-9, `parameters differ by ${worst}`);
  return [worst, longest];
}

const linesOf = file => fs.readFileSync(file, 'utf8').trim().split('\n');

/// A file for each load, the constants beside the first.
function comparePooled(engine) {
  const [head, ...rows] = linesOf(path.join(root, 'data/mergel2018.csv')).filter(row => !row.startsWith('#'));
  const curves = [...new Set(rows.map(row => row.split(',')[0]))], names = curves.map((_, i) => `run_${i + 1}.csv`);
  const toml = fs.readFileSync(path.join(root, 'data/mergel2018.toml'));
  const files = new Map(names.map((name, i) => [name, [head, ...rows.filter(row => row.split(',')[0] === curves[i])].join('\n') + '\n']));
  files.set('run_1.toml', toml);
  for (const [name, content] of files) {
    engine.write(name, Buffer.from(content));
    fs.writeFileSync(path.join(folder, name), content);
  }
  expect(names.length > 2, `only ${names.length} runs`);
  const read = JSON.parse(engine.read(JSON.stringify(names), '{}', false));
  expect(read.runs?.length === names.length && read.files.length === names.length, `several files: ${JSON.stringify(read).slice(0, 200)}`);
  const worst = compare(fit(engine, names, {}, {models: 'b,c'}), fitsOf([...names.map(name => path.join(folder, name)), '--pool', '--models=b,c']), 'several files');
  expect(worst < 1e-9, `several files: parameters differ by ${worst}`);
  return worst;
}

/// A workbook is read as by the program, and so is one that is refused.
function compareWorkbooks(engine) {
  const rows = linesOf(path.join(root, 'data/mergel2018.csv')).filter(row => !row.startsWith('#')).map(row => row.split(','));
  const sheet = workbookOf({'Notes & more': [['nothing here']], 'Run 1': rows}), toml = fs.readFileSync(path.join(root, 'data/mergel2018.toml'));
  const damaged = Buffer.from(sheet);
  damaged[sheet.length >> 1] ^= 0x55;
  const bomb = workbookOf({Data: rows}, {'xl/worksheets/sheet1.xml': Buffer.alloc(70 << 20, 32)});
  const files = {'sheet.xlsx': sheet, 'damaged.xlsx': damaged, 'bomb.xlsx': bomb, 'short.xlsx': sheet.subarray(0, sheet.length - 10), 'old.xls': Buffer.from('\xD0\xCF\x11\xE0 and more', 'latin1')};
  for (const [name, content] of Object.entries(files)) {
    for (const [file, bytes] of [[name, content], [name.replace(/\.xlsx?$/, '.toml'), toml]]) {
      engine.write(file, bytes);
      fs.writeFileSync(path.join(folder, file), bytes);
    }
    if (name === 'sheet.xlsx') continue;
    let theirs = '';
    try {
      execFileSync(program, ['check', name], {cwd: folder, encoding: 'utf8', stdio: 'pipe'});
    } catch (ended) {
      theirs = ended.stderr;
    }
    const ours = JSON.parse(engine.read(JSON.stringify([name]), '{}', false)).error ?? '', general = text => text.replace(/\((?:part '[^']*': )?[^()]*\)/, '()').trim();
    expect(ours !== '' && general(theirs).includes(general(ours)), `${name}: '${ours}', not '${theirs}'`);
  }
  const worst = compare(fit(engine, ['sheet.xlsx'], {}, {}), fitsOf([path.join(folder, 'sheet.xlsx')]), 'a workbook');
  expect(worst < 1e-9, `a workbook: parameters differ by ${worst}`);
  return worst;
}

/// The largest difference of numbers at the same place in two tables, in parts of the column's largest.
function tablesDiffer(one, other, where) {
  const [ours, theirs] = [one, other].map(text => text.trim().split('\n').map(row => row.split(',')));
  expect(ours.length === theirs.length && ours[0].join() === theirs[0].join(), `${where}: ${ours.length} rows of ${ours[0]}, not ${theirs.length} of ${theirs[0]}`);
  let worst = 0;
  theirs[0].forEach((_, k) => {
    const most = Math.max(...theirs.slice(1).map(row => Math.abs(Number(row[k])) || 0));
    theirs.slice(1).forEach((row, i) => {
      const field = ours[i + 1]?.[k];
      if (Number.isNaN(Number(row[k]))) expect(field === row[k], `${where}: '${field}', not '${row[k]}'`);
      else worst = Math.max(worst, Math.abs(Number(field) - Number(row[k])) / (most || 1));
    });
  });
  return worst;
}

/// A log in one file, and with the areas in another, whose clock is ahead: cut and fitted as by `mixity runs` and
/// `mixity fit`.
function compareLogs(engine) {
  const rows = linesOf(path.join(root, 'data/shear_log.csv')), toml = fs.readFileSync(path.join(root, 'data/shear_log.toml'));
  const fields = rows.map(row => row.split(','));
  const forces = fields.map(row => row.slice(0, 3).join(',')).join('\n') + '\n';
  const areas = fields.filter((row, i) => i === 0 || row[3]).map(([t, , , A], i) => `${i === 0 ? t : Number(t) + 0.37},${A}`).join('\n') + '\n';
  let worst = 0;
  for (const files of [{'shear_log.csv': rows.join('\n') + '\n', 'shear_log.toml': toml}, {'areas.csv': areas, 'forces.csv': forces, 'forces.toml': toml}]) {
    for (const [name, content] of Object.entries(files)) {
      engine.write(name, Buffer.from(content));
      fs.writeFileSync(path.join(folder, name), content);
    }
    const names = Object.keys(files).filter(name => name.endsWith('.csv')), where = names.join(' and ');
    expect(JSON.parse(engine.read(JSON.stringify(names), '{}', false)).log === true, `${where}: not taken for a log`);
    const cut = JSON.parse(engine.cut(JSON.stringify(names), 'x', '{}')), out = path.join(folder, 'out');
    if (cut.error) { failures.push(`${where}: ${cut.error}`); continue; }
    run(['runs', ...names.map(name => path.join(folder, name)), `--out=${out}`]);
    const theirs = name => fs.readFileSync(path.join(out, name), 'utf8');
    // both are rounded to seven digits
    for (const [ours, name] of [['runs', 'runs.csv'], ['peaks', 'peaks.csv']]) {
      const differ = tablesDiffer(cut.contents[cut.files[ours]], theirs(name), `${where}, ${name}`);
      expect(differ < 2e-7, `${where}, ${name} differs by ${differ}`);
    }
    const times = text => [...text.matchAll(/^(shear|onset) = "([^ ]*) s"/gm)].map(match => match[2]).join();
    expect(times(theirs('cuts.toml')) !== '' && times(cut.contents[cut.files.cuts]) === times(theirs('cuts.toml')), `${where}: the cuts are not those of the program`);
    expect(cut.runs.length === 3 && cut.figures.length === 3 && cut.runs.every(one => one.onset && one.falls > 0), `${where}: ${JSON.stringify(cut.runs)}`);
    const constants = text => text.split('\n').filter(line => !line.startsWith('source')).join('\n');
    expect(constants(cut.contents[cut.files.constants]) === constants(theirs('runs.toml')), `${where}: constants\n${cut.contents[cut.files.constants]}not\n${theirs('runs.toml')}`);
    worst = Math.max(worst, compare(fit(engine, [cut.data], {}, {peaks: cut.peaks}), fitsOf([path.join(out, 'fit.toml')]), where));
  }
  expect(worst < 1e-9, `logs: parameters differ by ${worst}`);
  return worst;
}

/// The engine of a page (assemble.mjs), in a file of the temporary folder.
function engineOf(page) {
  const html = fs.readFileSync(page, 'utf8');
  const part = id => gunzipSync(Buffer.from(new RegExp(`<script[^>]* id="${id}"[^>]*>([^<]*)</script>`).exec(html)[1], 'base64'));
  const before = 'data:application/octet-stream;base64,', script = part('engine').toString();
  const at = script.lastIndexOf(before) + before.length, file = path.join(folder, 'engine.js');
  fs.writeFileSync(file, script.slice(0, at) + part('compiled').toString('base64') + script.slice(at));
  return file;
}

const page = process.argv[2];
require(page ? engineOf(page) : path.join(root, 'build/explorer/engine.js'))().then(engine => {
  const version = run(['--version']).trim();
  expect(`mixity ${engine.version()}` === version, `the engine is of version ${engine.version()}, the program says '${version}'`);
  if (page) expect(fs.statSync(page).size < 3e6, `${page} has ${fs.statSync(page).size} bytes; 3 MB is the limit`);
  engine.write('x.csv', 'P,T,A\n1,2,x\n');
  const wrong = fit(engine, ['x.csv'], {}, {});
  expect(/:2:5: column 'A': 'x' is not a number/.test(wrong.error), `a wrong file: ${JSON.stringify(wrong)}`);
  const areas = compareAreas(engine), [fits, longest] = compareFits(engine), pooled = comparePooled(engine), sheets = compareWorkbooks(engine), logs = compareLogs(engine);
  console.log(`areas within ${areas.toExponential(1)}, parameters within ${fits.toExponential(1)}, of several files ${pooled.toExponential(1)}, of a workbook ${sheets.toExponential(1)}, of logs ${logs.toExponential(1)}; longest fit of three models ${longest.toFixed(0)} ms`);
  failures.forEach(one => console.log(one));
  fs.rmSync(folder, {recursive: true});
  process.exit(failures.length ? 1 : 0);
});
