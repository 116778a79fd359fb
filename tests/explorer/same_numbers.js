// The engine for browsers, in Node, against the program: areas to 1e-12, lambda to 1e-9 of itself, on the shipped sets.
'use strict';
const fs = require('fs');
const path = require('path');
const {execFileSync} = require('child_process');
const root = path.resolve(__dirname, '../..');
const program = path.join(root, 'build/release/src/mixity');
delete globalThis.fetch;  // Emscripten of Debian 12 takes it for a browser's, which knows data: addresses
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

function compareFits(engine) {
  let worst = 0, longest = 0;
  for (const name of ['mergel2018', 'waters_guduru2010', 'as4_peek_mmb'])
    for (const objective of name === 'mergel2018' ? ['curve', 'toughness'] : ['toughness']) {
      const file = path.join(root, 'data', name + '.csv');
      const models = name === 'as4_peek_mmb' ? 'bk' : 'a,b,c';
      const theirs = JSON.parse(run(['fit', file, `--models=${models}`, `--objective=${objective}`, '--format=json']));
      engine.write(`${name}.toml`, fs.readFileSync(file.replace('.csv', '.toml')));
      engine.write(`${name}.csv`, fs.readFileSync(file));
      const begin = performance.now();
      const told = JSON.parse(engine.fit(`${name}.csv`, '{}', JSON.stringify({models, objective})));
      longest = Math.max(longest, performance.now() - begin);
      if (told.error) { failures.push(`${name}: ${told.error}`); continue; }
      told.fits.datasets[0].fits.forEach((fit, i) => {
        const other = theirs.datasets[0].fits[i];
        expect(fit.status === other.status, `${name} ${objective} ${fit.model}: ${fit.status}, not ${other.status}`);
        for (const [key, parameter] of Object.entries(fit.parameters)) {
          const theirsOf = other.parameters[key];
          if (!theirsOf) { failures.push(`${name} ${objective} ${fit.model}: no ${key} among ${Object.keys(other.parameters)}`); continue; }
          if (theirsOf.value) worst = Math.max(worst, Math.abs(parameter.value / theirsOf.value - 1));
          expect((parameter.value === null) === (theirsOf.value === null), `${name} ${fit.model} ${key}`);
          for (const end of ['low', 'high'])
            if (parameter.interval && parameter.interval[end])
              expect(Math.abs(parameter.interval[end] / theirsOf.interval[end] - 1) < 1e-6, `${name} ${fit.model}: interval ${end}`);
        }
      });
    }
  expect(worst < 1e-9, `parameters differ by ${worst}`);
  return [worst, longest];
}

require(path.join(root, 'build/explorer/engine.js'))().then(engine => {
  engine.write('x.csv', 'P,T,A\n1,2,x\n');
  const wrong = JSON.parse(engine.fit('x.csv', '{}', '{}'));
  expect(/:2:5: column 'A': 'x' is not a number/.test(wrong.error), `a wrong file: ${JSON.stringify(wrong)}`);
  const areas = compareAreas(engine), [fits, longest] = compareFits(engine);
  console.log(`areas within ${areas.toExponential(1)}, parameters within ${fits.toExponential(1)}, longest fit of three models ${longest.toFixed(0)} ms`);
  failures.forEach(one => console.log(one));
  process.exit(failures.length ? 1 : 0);
});
