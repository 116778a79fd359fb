// What the page shows of a fit, in headless Chromium: runs told apart, values under the pointer, what is copied and saved,
// remedies as buttons, other models, residuals, ellipses, stored results, and when the page is ready.
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const {root, built, shots, failures, expect, near, run: runIn} = require('./program.js');
const {chromium} = require(path.join(built, 'node_modules/playwright-core'));
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'mixity-figures-'));
const run = (words, where = folder) => runIn(words, where);
const sample = ['csv', 'toml'].map(ending => path.join(root, 'data', `mergel2018.${ending}`));

const fitsOf = words => JSON.parse(run(['fit', ...words, '--format=json'])).datasets[0].fits;

const fitted = page => page.waitForFunction(() => document.getElementById('busy').hidden && window.explorer.experiment.result, undefined, {timeout: 60000});
const fitsOn = page => page.evaluate(() => window.explorer.experiment.result.fits.datasets[0].fits);
async function drop(page, files) {
  await page.evaluate(() => { window.explorer.experiment.result = null; });
  await page.setInputFiles('#file', files);
  await fitted(page);
  await page.waitForTimeout(200);  // until it is drawn: one figure a frame, which a busy machine takes longer for
  await page.evaluate(async () => { for (let i = 0; i < 20; ++i) await new Promise(requestAnimationFrame); });
}
const seriesOf = (page, figure) => page.evaluate(name => window.explorer.experiment.figures[name].chart.getOption().series.map(({id, name: title, color, symbol, data}) => ({id, title, color, symbol, points: data.length})), figure);

/// Parameters and status of the page's fits are the program's.
function same(ours, theirs, where) {
  theirs.forEach((fit, i) => {
    expect(ours[i]?.model === fit.model && ours[i].status === fit.status, `${where}: ${ours[i]?.model} ${ours[i]?.status}, not ${fit.model} ${fit.status}`);
    for (const [name, {value}] of Object.entries(fit.parameters)) expect(near(ours[i]?.parameters[name]?.value, value, 1e-6), `${where} ${fit.model} ${name}: ${ours[i]?.parameters[name]?.value}, not ${value}`);
  });
}

/// Twelve runs, two of them under the same load.
function manyRuns() {
  const words = ['simulate', '--model=c', '--lambda=0.003', '--points=8', '--radius=9.42 mm', '--modulus=2.133 MPa', '--toughness=27 mJ/m^2', '--sigma_A=1%', '--sigma_T=1%', '--force', '--out=many.csv', `--loads=${Array.from({length: 12}, (_, i) => Math.max(i, 1))} mN`];
  run(words);
  return ['many.csv', 'many.toml'].map(name => path.join(folder, name));
}

async function runsToldApart(page) {
  await drop(page, manyRuns());
  const points = (await seriesOf(page, 'all')).filter(({id}) => /^points-/.test(id)), names = points.map(({title}) => title);
  const looks = new Set(points.map(({color, symbol}) => `${color} ${symbol}`));
  expect(points.length >= 11 && looks.size === points.length, `${points.length} runs have ${looks.size} looks`);
  points.slice(1).forEach((one, i) => expect(one.color !== points[i].color && one.symbol !== points[i].symbol, `${one.title} and ${points[i].title} share colour or mark`));
  expect(new Set(names).size === names.length && names.every(name => / mN/.test(name)), `the key says ${names}`);
}

async function underThePointer(page) {
  await drop(page, sample);
  const place = await page.evaluate(() => {
    const entry = window.explorer.experiment.figures.all, box = entry.chart.getDom(), curve = entry.lines.find(({id}) => id === 'curve-1').data;
    box.scrollIntoView({block: 'center'});
    const at = curve[Math.floor(curve.length / 3)], [x, y] = entry.chart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, at), {left, top} = box.getBoundingClientRect();
    return {at, x: left + x, y: top + y};
  });
  await page.mouse.move(place.x, place.y);
  await page.waitForFunction(() => document.querySelector('#chart-fit + .tools output').textContent);
  const said = await page.textContent('#chart-fit + .tools output'), [, T, A] = /^P = 3.815 mN: T = ([\d.]+) mN, A = ([\d.]+) mm²$/.exec(said) ?? [];
  expect(near(Number(T), place.at[0], .02) && near(Number(A), place.at[1], .02), `under the pointer: '${said}', at ${place.at}`);
  await page.mouse.move(place.x, place.y - 400);
  await page.waitForFunction(() => !document.querySelector('#chart-fit + .tools output').textContent);
}

async function copiedAndSaved(page) {
  const clipboard = () => page.evaluate(() => navigator.clipboard.readText());
  await page.click('.result .copy');
  await page.waitForFunction(() => document.querySelector('.result .copy').textContent === 'Copied');
  const result = await clipboard();
  expect(result === (await page.evaluate(() => window.explorer.experiment.result.answer.result)), `copied: ${result}`);
  await page.click('.jumps + .copy');
  await page.waitForTimeout(100);
  const rows = (await clipboard()).split('\n').map(row => row.split('\t'));
  expect(rows.length === 9 && rows.every(row => row.length === rows[0].length), `the copied table: ${rows}`);
  await page.evaluate(() => { document.getElementById('others').open = true; });
  const lambda = (await fitsOn(page)).find(fit => fit.model === 'c').parameters.lambda;
  await page.click('[aria-label^="Copy lambda of model c"]');
  await page.waitForTimeout(100);
  expect(await clipboard() === `${lambda.value}\t${lambda.stderr}`, `copied of model c: ${await clipboard()}`);
  await page.click('#chart-fit + .tools [data-figure=copy]');
  await page.waitForFunction(() => document.querySelector('#chart-fit + .tools output').textContent === 'Copied');
  const types = await page.evaluate(async () => (await navigator.clipboard.read()).flatMap(({types: all}) => all));
  expect(types.includes('image/png'), `the copied figure is ${types}`);

  const saved = async (figure, key) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#${figure} + .tools [data-figure=${key}]`)]);
    const file = path.join(folder, download.suggestedFilename());
    await download.saveAs(file);
    return fs.readFileSync(file);
  };
  const svg = (await saved('chart-fit', 'svg')).toString();
  expect(/^<svg[^]*mergel2018.csv[^]*model c, Papangelo-Ciavarella 2019[^]*λ = 0\.0022[^]*R = 9.42 mm[^]*<path/.test(svg), `a saved figure names: ${svg.slice(0, 600)}`);
  expect((await page.evaluate(text => new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror')?.textContent, svg)) === undefined, 'a saved SVG is XML');
  const png = await saved('chart-fit', 'png'), tall = await page.evaluate(() => window.explorer.experiment.figures.all.chart.getHeight());
  expect(png.subarray(1, 4).toString() === 'PNG' && png.readUInt32BE(20) > 3 * tall + 50, `a saved picture is ${png.readUInt32BE(20)} high, its figure ${3 * tall}`);
  const models = (await saved('chart-toughness', 'svg')).toString();
  expect(/model a, Johnson 1996[^]*P = [\d.]+ mN, T = [\d.]+ mN, R = 9.42 mm/.test(models), `a saved figure of the models names: ${models.slice(0, 600)}`);
}

async function crop(page) {
  const says = () => page.evaluate(() => [...window.explorer.experiment.figures.all.handles.values()].map(({says: text, style}) => [text, style.stroke]));
  await page.selectOption('#run', '0');
  await page.waitForTimeout(200);
  const [[first, tint]] = await says();
  await page.selectOption('#run', '2');
  await page.waitForTimeout(200);
  const [[third, other]] = await says();
  expect(first === 'cuts P = 7.732 mN' && third === 'cuts P = 2.925 mN' && tint !== other, `the crop line says ${first}, ${third}`);
  const named = await page.evaluate(() => [...document.getElementById('run').options].map(({text}) => text));
  expect(named[0] === 'P = 7.732 mN (P=30.4)', `the first of the runs to cut is called ${named[0]}`);
  const above = await page.evaluate(() => [window.explorer.experiment.figures.all, window.explorer.experiment.figures.run].flatMap(({chart, handles}) => {
    const plot = chart.getModel().getComponent('grid').coordinateSystem.getRect().y;
    return [...handles.values()].map(line => {
      const text = line.getTextContent(), box = text.getBoundingRect().clone();
      box.applyTransform(text.getComputedTransform());
      return [box.y, box.y + box.height, plot];
    });
  }));
  expect(above.length === 3 && above.every(([top, end, plot]) => top > 0 && end < plot + 1), `the texts of the crop lines lie from and to, the plot from ${JSON.stringify(above)}`);
  const at = await page.evaluate(() => {
    const {measured, state} = window.explorer.models;
    return [state.P, measured.runs[2].P];
  });
  expect(near(at[0], at[1], 1e-4), `the sliders are at P = ${at[0]}, the run at ${at[1]}`);
}

/// The user's points in the sliders' figure are those of the file.
async function behindTheSliders(page) {
  const drawn = await page.evaluate(() => window.explorer.models.figures.area.chart.getOption().series.find(({id}) => id === 'behind'));
  const rows = fs.readFileSync(sample[0], 'utf8').split('\n').filter(row => row.startsWith('P=11.5,')).map(row => row.split(',').slice(2).map(Number));
  expect(drawn?.name === 'reconstructed at P = 2.925 mN' && drawn.data.length === rows.length, `behind the sliders: ${drawn?.name}, ${drawn?.data.length} points`);
  drawn?.data.forEach(([T, A], i) => expect(near(T, rows[i][0], 1e-9) && near(A, rows[i][1], 1e-9), `point ${i} behind the sliders: ${T}, ${A}`));
}

async function inDegrees(page) {
  const [name, most, here, psi] = await page.evaluate(() => {
    const {models} = window.explorer, {chart} = models.figures.toughness, {xAxis: [axis], series} = chart.getOption();
    return [axis.name, axis.max, series.find(({id}) => id === 'c-here').data[0][0], models.all.find(({model}) => model === 'c').state.psi];
  });
  expect(name === 'ψ (°)' && most === 90 && near(here, psi * 180 / Math.PI, 1e-12) && here > 2, `phase angles: ${name} to ${most}, ${here} for ${psi} rad`);
  await drop(page, ['csv', 'toml'].map(ending => path.join(root, 'data', `waters_guduru2010.${ending}`)));
  const [axis, angles, known] = await page.evaluate(() => {
    const {figures, told} = window.explorer.experiment, {xAxis, series} = figures.all.chart.getOption();
    return [xAxis[0].name, series[0].data.map(([x]) => x), told.energies.psi];
  });
  expect(axis === 'ψ (°)' && angles.every((x, i) => near(x, known[i] * 180 / Math.PI, 1e-12)), `phase angles of a file: ${axis}, ${angles.slice(0, 3)}`);
  expect(!/\(rad\)/.test(await page.textContent('main')), 'an axis in radians');
}

/// Names and laws at the boxes are the program's, and the ends of λ do what they say.
async function explained(page) {
  const plain = text => text.replaceAll('lambda', 'λ').replaceAll('−', '-').replaceAll(/[\s()^]/g, '').replaceAll('psi', 'ψ').replaceAll('sin2', 'sin²').replaceAll('tan2', 'tan²').replaceAll('eta', 'η');
  const all = await page.$$eval('#meanings dd', terms => terms.map(({textContent}) => textContent));
  const headings = [...run(['fit', sample[0], '--models=a,b,c,bk']).matchAll(/\[\[Model \w+\]\] (.*?): (f = .*)/g)];
  expect(headings.length === 4, `the program names ${headings.length} models`);
  headings.forEach(([, model_name, formula], i) => {
    const [, who, law] = /^(.*?): (f = .*?)\. /.exec(all[i]) ?? [];
    expect(who === model_name && plain(law) === plain(formula), `at its box: ${all[i]}; the program: ${model_name}: ${formula} (${plain(law ?? '')}, ${plain(formula)})`);
  });
  const at = (model, lambda, T) => Number(run(['predict', `--model=${model}`, `--lambda=${lambda}`, '--load=5', `--shear=${T}`]).trim().split('\n')[1].split(',')[4]);
  for (const [model, most] of [['a', 1], ['b', 2], ['c', 1]]) {
    expect(near(at(model, 1e-12, 3), at(model, 1e-12, 0), 1e-6), `model ${model}: at λ = 0 the area falls`);
    expect(near(at(model, most, 3), at('a', 1, 3), 1e-9) && at(model, most, 3) < at(model, .5 * most, 3), `model ${model}: at λ = ${most} the area is not that of a constant toughness`);
  }
  expect(/A sphere pressed on a soft half-space/.test(await page.textContent('.contact svg title')), 'the contact is drawn');
}

/// The held approach against `mixity predict --approach`.
async function heldApproach(page) {
  await page.check('#held');
  await page.waitForFunction(() => window.explorer.models.all.every(({held}) => held));
  const {state, held} = await page.evaluate(() => ({state: window.explorer.models.state, held: window.explorer.models.all.find(({model}) => model === 'c').held}));
  const places = [...held.curve.filter((_, i) => i % 10 === 0), ...held.state], T = places.map(([at]) => at);
  expect(T.length === 12 && near(T.at(-1), state.T, 1e-12), `a held approach at T = ${T}`);
  const rows = run(['predict', '--model=c', `--lambda=${state.c}`, `--approach=${held.approach} um`, `--shear=${T.join(',')} mN`, `--radius=${state.R} mm`, `--modulus=${state.E} MPa`, `--toughness=${state.G} mJ/m^2`]).trim().split('\n');
  const heading = rows[0].split(','), at = name => heading.findIndex(one => one.startsWith(name));
  rows.slice(1).map(row => row.split(',')).forEach((row, i) => {
    const [, A, P] = places[i];
    expect(near(A, Number(row[at('A')]), 1e-6) && near(P, Number(row[at('P')]), 1e-5), `a held approach at T = ${T[i]}: A = ${A}, P = ${P}, the program: ${row} (${heading})`);
  });
  expect(near(held.curve[0][2], state.P, 1e-6), `without shear P = ${held.curve[0][2]}, not ${state.P}`);
  expect(/With its approach held at [\d.]+ µm: A = [\d.]+ mm² and P = [\d.]+ mN at T = [\d.]+ mN; does not jump/.test(await page.textContent('#says')), `of a held approach: ${await page.textContent('#says')}`);
  expect((await page.evaluate(() => window.explorer.models.figures.area.chart.getOption().series.filter(({id}) => /-held$/.test(id)).length)) === 3, 'a held approach is not drawn');
  await page.waitForFunction(() => /held=1/.test(location.hash));
  await page.uncheck('#held');
}

async function otherModels(page) {
  await drop(page, sample);
  const curves = async () => (await seriesOf(page, 'all')).filter(({id}) => /^curve-/.test(id)).map(({title}) => title);
  expect((await curves()).length === 8 && (await seriesOf(page, 'all')).some(({id}) => /^band-/.test(id)), 'the best model with its band');
  const scatter = (await fitsOn(page)).map(({rmse}) => rmse), byModel = await page.evaluate(() => Object.fromEntries(window.explorer.experiment.result.drawn.models.map(({model, residuals}) => [model, residuals.map(one => one[2])])));
  ['a', 'b', 'c'].forEach((model, i) => {
    const rms = Math.sqrt(byModel[model].reduce((sum, one) => sum + one * one, 0) / byModel[model].length);
    expect(near(rms, scatter[i], 1e-6), `residuals of model ${model}: ${rms}, the fit says ${scatter[i]}`);
  });
  const before = (await seriesOf(page, 'residuals')).map(({points}) => points);
  expect(before.slice(0, -1).reduce((sum, one) => sum + one, 0) === 200, `residuals of ${before} points`);
  await page.selectOption('#drawn-model', 'b');
  await page.waitForTimeout(300);
  expect(/model b with a band/.test(await page.textContent('#caption-fit')) && /model b\./.test(await page.textContent('#caption-residuals')), `model b: ${await page.textContent('#caption-fit')}`);
  expect((await seriesOf(page, 'all')).some(({id}) => /^band-/.test(id)), 'model b has a band, too');
  await page.selectOption('#drawn-model', 'all');
  await page.waitForTimeout(300);
  expect(new Set(await curves()).size === 3, `all models: ${new Set(await curves()).size} names`);
  const key = await page.evaluate(() => window.explorer.experiment.figures.all.chart.getOption().legend[0].data);
  expect(['model a', 'model b', 'model c'].every(name => key.slice(0, 3).includes(name)), `the key of all models: ${key}`);
  if (shots) await page.screenshot({path: path.join(shots, 'all_models.png'), fullPage: true});
  await page.selectOption('#drawn-model', 'c');
}

const twoWays = 'P [mN];T [mN];A [mm^2]\n1,250;100;2,250\n1,250;200;2,100\n1,250;300;2,050\n';

/// A suspect answer is in front; its remedies are buttons, whose fit is that of the program with the same option.
async function remedies(page) {
  const only = async models => {
    for (const box of await page.$$('input[name=model]')) if (await box.isVisible()) await box.setChecked(models.includes(await box.inputValue()));
    await fitted(page);
  };
  await only(['c']);
  await page.fill('[name=radius]', '10 mm');
  await page.click('#constants > button');
  await page.waitForFunction(() => document.querySelector('#told .doubt'));
  expect(await page.evaluate(() => document.querySelector('#told').firstElementChild.classList.contains('doubt')), 'the doubt is not in front');
  const text = await page.textContent('.doubt');
  expect(/radius looks wrong/.test(text) && !/--|in the program/.test(text), `suspect: ${text}`);
  if (shots) await page.screenshot({path: path.join(shots, 'suspect.png'), fullPage: true});
  await page.click('.doubt button:has-text("Fit radius too")');
  await page.waitForFunction(() => /free = radius/.test(document.getElementById('set-options').textContent) && window.explorer.experiment.result?.fits.datasets[0].fits[0].parameters.radius);
  await fitted(page);
  same(await fitsOn(page), fitsOf([sample[0], '--models=c', '--radius=10 mm', '--free=radius']), 'with its remedy');
  await page.click('#set-options button');
  await page.waitForFunction(() => document.getElementById('set-options').hidden && window.explorer.experiment.result && !window.explorer.experiment.result.fits.datasets[0].fits[0].parameters.radius);
  await page.evaluate(() => { document.getElementById('more-fit').open = true; });
  await page.fill('#fit-options', 'free=modulus; loss=huber');
  await page.click('#constants > button');
  await page.waitForFunction(() => window.explorer.experiment.result?.fits.datasets[0].fits[0].parameters.modulus);
  same(await fitsOn(page), fitsOf([sample[0], '--models=c', '--radius=10 mm', '--free=modulus', '--loss=huber']), 'with typed options');

  // a file that can be read in two ways: each is a button
  await page.setInputFiles('#file', {name: 'two.csv', mimeType: 'text/csv', buffer: Buffer.from(twoWays)});
  await page.click('#trouble button:has-text("as the decimal sign")');
  await page.waitForFunction(() => /radius/.test(document.getElementById('trouble').textContent) && /^two.csv: 3 of 3 rows/.test(document.getElementById('read-title').textContent));

  // an ellipse: its axes are drawn, and the remedy fits both
  run(['simulate', '--model=c-ellipse', '--lambda_II=0.004', '--lambda_III=0.008', '--loads=1,2,4,8 mN', '--points=15', '--radius=9.42 mm', '--modulus=2.133 MPa', '--toughness=27 mJ/m^2', '--poisson_ratio=0.5', '--sigma_A=1%', '--out=ellipse.csv', '--force']);
  await drop(page, ['ellipse.csv', 'ellipse.toml'].map(name => path.join(folder, name)));
  const axes = await seriesOf(page, 'axes');
  expect(await page.isVisible('#axes') && axes.length === 4 && axes.every(({points}) => points === 15), `axes: ${JSON.stringify(axes)}`);
  await page.click('.doubt button:has-text("Fit an ellipse")');
  await page.waitForFunction(() => window.explorer.experiment.result?.fits.datasets[0].fits[0].model === 'c-ellipse');
  const ellipse = fitsOf(['ellipse.csv', '--models=c', '--shape=ellipse']);
  same(await fitsOn(page), ellipse, 'an ellipse');
  await page.waitForTimeout(300);
  expect((await seriesOf(page, 'axes')).length === 8, 'the ellipse of the model is not drawn');
  expect(/^λ<sub>II<\/sub> = [\d.]+ ± [\d.]+, λ<sub>III<\/sub> = /.test(await page.innerHTML('.result')), `the couplings: ${await page.innerHTML('.result')}`);
  const listed = await page.textContent('#models');
  expect(/λII = [\d.]+ ± [\d.]+ /.test(listed) && !/e-\d/.test(listed), `all models: ${listed}`);
  if (shots) await page.screenshot({path: path.join(shots, 'ellipse.png'), fullPage: true});
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-save=toml]')]), definition = path.join(folder, 'ellipse_fit.toml');
  await download.saveAs(definition);
  same(fitsOf([definition]), ellipse, 'the saved definition of an ellipse');
  await drop(page, [definition, ...['ellipse.csv', 'ellipse.toml'].map(name => path.join(folder, name))]);
  same(await fitsOn(page), ellipse, 'the definition of an ellipse on the page');
  await drop(page, sample);  // without the ellipse, which takes half a minute with all models
  await only(['a', 'b', 'c']);
}

/// Points past the onset of sliding: the remedy is a button, which cuts the runs there.
async function slidingCut(page) {
  run(['simulate', '--model=c', '--lambda=0.15', '--loads=2,5,10 mN', '--points=25', '--radius=9.42 mm', '--modulus=2.133 MPa', '--toughness=27 mJ/m^2', '--sigma_A=0.3%', '--sigma_T=0.3%', '--out=slides.csv', '--force']);
  const [head, ...rows] = fs.readFileSync(path.join(folder, 'slides.csv'), 'utf8').trim().split('\n').map(row => row.split(','));
  const [T, A] = ['T [mN]', 'A [mm^2]'].map(name => head.indexOf(name));
  rows.forEach((row, i) => { if (i % 25 > 22) { row[T] *= 1.25; row[A] *= .8; } });
  fs.writeFileSync(path.join(folder, 'slides.csv'), [head, ...rows].map(row => row.join(',')).join('\n') + '\n');
  await drop(page, ['slides.csv', 'slides.toml'].map(name => path.join(folder, name)));
  expect(/cut the runs/.test(await page.textContent('.doubt')), `sliding: ${await page.textContent('#told')}`);
  await page.click('.doubt button:has-text("Leave out lines 25-26,50-51,75-76")');
  await page.waitForFunction(() => /exclude = 25-26/.test(document.getElementById('set-options').textContent) && window.explorer.experiment.result && !window.explorer.experiment.result.answer.doubt);
  same(await fitsOn(page), fitsOf(['slides.csv', '--models=a,b,c', '--exclude=25-26,50-51,75-76']), 'cut at the onset of sliding');
}

/// A held approach: asked for by a button, named δ in the figures, fitted as by the program, with its zero and the machine.
async function approachData(page) {
  run(['simulate', '--control=approach', '--model=c', '--lambda=0.05', '--loads=3,8,15 um', '--points=15', '--radius=9.42 mm', '--modulus=2.133 MPa', '--toughness=27 mJ/m^2', '--out=approach.csv', '--force']);
  await page.setInputFiles('#file', path.join(folder, 'approach.csv'));
  await page.click('#trouble button:has-text("Read delta as the approach that is held")');
  await page.waitForFunction(() => /radius/.test(document.getElementById('trouble').textContent) && /control = approach/.test(document.getElementById('set-options').textContent));
  for (const [name, value] of [['radius', '9.42 mm'], ['modulus', '2.133 MPa'], ['toughness', '27 mJ/m^2']]) await page.fill(`[name=${name}]`, value);
  await page.click('#constants > button');
  await page.waitForFunction(() => window.explorer.experiment.result);
  await fitted(page);
  const program = words => fitsOf(['approach.csv', '--models=a,b,c', ...words]);
  same(await fitsOn(page), program([]), 'a held approach');
  const names = (await seriesOf(page, 'all')).map(({title}) => title);
  expect(names.includes('δ = 15 um') && !names.some(name => name.startsWith('P =')), `runs of a held approach: ${names}`);
  expect(/^delta/.test(await page.textContent('.jumps th')), `jumps of a held approach: ${await page.textContent('.jumps')}`);
  await page.evaluate(() => { document.getElementById('more').open = true; });
  await page.fill('[name=approach_offset]', '0 +/- 0.2 um');
  await page.fill('[name=normal_stiffness]', '1.2 kN/m');
  await page.click('#constants > button');
  await page.waitForFunction(() => window.explorer.experiment.result?.fits.datasets[0].fits[0].parameters.approach_offset);
  await fitted(page);
  same(await fitsOn(page), program(['--approach_offset=0 +/- 0.2 um', '--normal_stiffness=1.2 kN/m']), 'a held approach with its zero');
}

/// Pull-off loads are drawn with the curve of the model, on which a load of the program lies.
async function pullOff(page) {
  const rows = [[-1.1, 0], [-1, 5], [-.9, 10], [-.7, 14], [-.5, 18], [-.2, 22]];
  fs.writeFileSync(path.join(folder, 'pull.csv'), 'P_c [mN],T [mN]\n' + rows.map(row => row.join(',')).join('\n') + '\n');
  fs.writeFileSync(path.join(folder, 'pull.toml'), 'radius = "9.42 mm"\nmodulus = "2.133 MPa"\ntoughness = "27 mJ/m^2"\n');
  await drop(page, ['pull.csv', 'pull.toml'].map(name => path.join(folder, name)));
  same(await fitsOn(page), fitsOf(['pull.csv', '--models=a,b,c']), 'pull-off loads');
  expect(/^pull.csv: 6 of 6 rows, all of them pull-off loads/.test(await page.textContent('#read-title')), `of pull-off loads: ${await page.textContent('#read-title')}`);
  const [points, curve] = await seriesOf(page, 'pullOff');
  expect(await page.isVisible('#pull-off') && !await page.isVisible('#figure-fit') && points.points === 6 && curve.points > 50, `pull-off loads: ${JSON.stringify([points, curve])}`);
  const start = await page.evaluate(() => window.explorer.experiment.figures.pullOff.lines[0].data[0]);
  expect(near(start[1], -1.5 * Math.PI * 9.42 * .027, 1e-6), `without shear the model pulls off at ${start}`);
  await drop(page, sample);
  expect(!await page.isVisible('#pull-off') && await page.isVisible('#figure-fit'), 'pull-off loads stay');
}

/// Measured toughnesses are drawn over the one that was fitted, so that they lie about the law.
async function fittedToughness(page) {
  const definition = {name: 'im7_fit.toml', mimeType: 'application/toml', buffer: Buffer.from('data = "im7_8552_mmb.csv"\nmodels = ["c"]\nobjective = "toughness"\nweighted = true\nfree = ["toughness"]\n')};
  const [data, constants] = ['csv', 'toml'].map(ending => path.join(root, `data/im7_8552_mmb.${ending}`));
  await drop(page, [...[data, constants].map(file => ({name: path.basename(file), mimeType: 'text/plain', buffer: fs.readFileSync(file)})), definition]);
  const [{parameters}] = await fitsOn(page);
  const [drawn, ratios] = await page.evaluate(() => [
    window.explorer.experiment.figures.all.chart.getOption().series.find(({id}) => id === 'points').data.map(([, f]) => f), window.explorer.experiment.told.energies.f]);
  // stated in N/mm, found in J/m^2
  expect(drawn.length === 6 && drawn.every((f, i) => near(f, ratios[i] * 324 / parameters.toughness.value, 1e-9)), `points over the toughness ${parameters.toughness.value}: ${drawn}`);
  expect(/Points are over the toughness that model c found/.test(await page.textContent('#caption-fit')), `the caption says: ${await page.textContent('#caption-fit')}`);
}

/// On paper each picture lies within its figure.
async function printed(page) {
  await drop(page, sample);
  await page.emulateMedia({media: 'print'});
  const beyond = await page.$$eval('figure .chart canvas', all => all.map(one => [one.getBoundingClientRect(), one.closest('figure').getBoundingClientRect()])
    .filter(([picture]) => picture.width > 0).map(([picture, around]) => [picture.right - around.right, picture.bottom - around.bottom]));
  expect(beyond.length >= 8 && beyond.every(([right, below]) => right < 0 && below < 0), `printed pictures end beyond their figures by ${JSON.stringify(beyond)}`);
  await page.emulateMedia({media: null});
}

/// Pictures that were drawn on a dark screen are dark on light paper.
async function printedFromADarkScreen(page) {
  await drop(page, sample);
  await page.emulateMedia({colorScheme: 'dark'});
  await page.waitForFunction(() => document.documentElement.classList.contains('drawn-dark'));
  await page.evaluate(() => new Promise(done => { setTimeout(done, 500); }));  // models are drawn when the engine answers
  const canvas = '#chart-area canvas';
  await page.evaluate(async name => { window.picture = await createImageBitmap(document.querySelector(name)); }, canvas);
  await page.emulateMedia({media: 'print', colorScheme: 'dark'});
  const [light, darkest] = await page.evaluate(name => {
    const {picture} = window, pen = Object.assign(document.createElement('canvas'), {width: picture.width, height: picture.height}).getContext('2d');
    pen.fillStyle = 'white';
    pen.fillRect(0, 0, picture.width, picture.height);
    pen.filter = getComputedStyle(document.querySelector(name)).filter;
    pen.drawImage(picture, 0, 0);
    // of the key, where no lines of the grid are
    const {data} = pen.getImageData(0, 0, picture.width, 30), tones = [];
    for (let i = 0; i < data.length; i += 4) tones.push((data[i] + data[i + 1] + data[i + 2]) / 3);
    return [tones.filter(tone => tone > 230).length / tones.length, tones.reduce((least, tone) => Math.min(least, tone), 255)];
  }, canvas);
  expect(light > .8 && darkest < 100, `printed from a dark screen, a picture is light in ${(100 * light).toFixed(0)} % of its points; its ink has ${darkest}`);
  await page.emulateMedia({media: null, colorScheme: null});
}

async function storedResults(page) {
  const stored = path.join(folder, 'stored.json');
  fs.writeFileSync(stored, run(['fit', sample[0], '--models=c', '--radius=9.3 mm', '--format=json']));
  await page.setInputFiles('#file', [stored]);
  await page.waitForFunction(() => /Stored results of stored.json/.test(document.getElementById('stored').textContent));
  const was = JSON.parse(fs.readFileSync(stored, 'utf8')).datasets[0].fits[0].parameters.lambda.value;
  await drop(page, sample);
  const cells = await page.$$eval('#stored tbody tr:first-child td', all => all.map(({textContent}) => textContent));
  const now = (await fitsOn(page)).find(({model}) => model === 'c').parameters.lambda.value;
  expect(near(parseFloat(cells[1]), was, 1e-4) && near(parseFloat(cells[2]), now, 1e-4) && !near(was, now, 1e-3), `stored and now: ${cells}`);
  await page.setInputFiles('#file', {name: 'other.json', mimeType: 'application/json', buffer: Buffer.from('{"a": 1}')});
  await page.waitForFunction(() => /other.json is no table/.test(document.getElementById('trouble').textContent));
}

/// First paint and readiness of a page that is opened for the first time: the middle of five.
async function opening(browser, address) {
  const all = [];
  for (let i = 0; i < 5; ++i) {
    const page = await browser.newPage();
    await page.goto(address);
    await page.waitForFunction(() => window.explorer && performance.getEntriesByType('paint').length);
    all.push(await page.evaluate(() => [performance.getEntriesByType('paint')[0].startTime, performance.getEntriesByName('ready')[0].startTime]));
    await page.close();
  }
  return [0, 1].map(k => all.map(one => one[k]).sort((x, y) => x - y)[2]);
}

async function main() {
  const browser = await chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox']});
  const address = 'file://' + path.join(built, 'explorer.html');
  const [paint, ready] = await opening(browser, address);
  // the claims are 0.5 s and 1 s on a machine that is free; a test that runs beside others takes three times as long
  expect(paint < 1500 && ready < 3000, `painted after ${paint} ms, ready after ${ready} ms`);
  const context = await browser.newContext({viewport: {width: 1280, height: 900}, acceptDownloads: true, permissions: ['clipboard-read', 'clipboard-write']});
  const page = await context.newPage(), told = [];
  page.on('console', message => told.push(message.text()));
  page.on('pageerror', error => told.push(error.message));
  await page.goto(address);
  await page.waitForFunction(() => window.explorer);
  for (const part of [runsToldApart, underThePointer, copiedAndSaved, crop, behindTheSliders, heldApproach, inDegrees, explained, otherModels, remedies, slidingCut, approachData, pullOff, fittedToughness, printed, printedFromADarkScreen, storedResults])
    await part(page).catch(error => failures.push(`${part.name}: ${error.stack}`));
  expect(told.length === 0, `the console says: ${told.join('; ')}`);
  console.log(`painted after ${paint.toFixed(0)} ms, ready after ${ready.toFixed(0)} ms`);
  await browser.close();
}

main().catch(error => failures.push(error.stack)).then(() => {
  failures.forEach(one => console.log(one));
  fs.rmSync(folder, {recursive: true});
  process.exit(failures.length ? 1 : 0);
});
