// The page in Firefox without a window: it opens, draws, reads, fits to the program's numbers, stops, and says nothing on
// its console. 77: there is no Firefox.
'use strict';
const fs = require('fs');
const path = require('path');
const {firefox} = require('./firefox.js');
const {root, shots, failures, expect, near, run} = require('./program.js');
const browser = process.env.FIREFOX ?? '/usr/bin/firefox-esr';

async function main(page) {
  const address = 'file://' + path.join(root, 'build/explorer/explorer.html');
  const times = [];
  for (let i = 0; i < 3; ++i) {
    await page.open(address);
    await page.until(() => Boolean(window.explorer));
    times.push(await page.evaluate(() => [performance.getEntriesByType('paint')[0]?.startTime ?? 0, performance.getEntriesByName('ready')[0].startTime]));
  }
  await page.evaluate(() => {
    window.told = [];
    addEventListener('error', event => window.told.push(event.message));
    addEventListener('unhandledrejection', event => window.told.push(String(event.reason)));
    addEventListener('securitypolicyviolation', event => window.told.push(event.violatedDirective));
  });
  expect(/Model c \(λ = /.test(await page.evaluate(() => document.getElementById('says').textContent)), 'the sliders say nothing');

  // a file of one's own, its points and its fit
  await page.files('#file', ['csv', 'toml'].map(ending => path.join(root, 'data', `mergel2018.${ending}`)));
  await page.until(() => Boolean(window.explorer.experiment.result));
  const fits = await page.evaluate(() => window.explorer.experiment.result.fits.datasets[0].fits.map(({model, status, parameters}) => ({model, status, value: parameters.lambda.value})));
  const known = JSON.parse(run(['fit', path.join(root, 'data/mergel2018.csv'), '--models=a,b,c', '--format=json'])).datasets[0].fits;
  known.forEach((fit, i) => expect(fits[i].status === fit.status && near(fits[i].value, fit.parameters.lambda.value, 1e-9), `${fit.model}: ${fits[i].value} ${fits[i].status}, not ${fit.parameters.lambda.value} ${fit.status}`));

  // the figures are drawn, the saved one is XML, the map is there
  await page.until(() => window.explorer.experiment.figures.all.chart.getOption().series.length > 20);
  const ink = await page.evaluate(() => {
    const canvas = document.querySelector('#chart-fit canvas'), {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let drawn = 0;
    for (let i = 3; i < data.length; i += 4) drawn += data[i] > 0;
    return drawn / canvas.width / canvas.height;
  });
  expect(ink > .005, `the figure has ink on ${ink} of its pixels`);
  await page.until(() => { const {map} = window.explorer.models; return map.known.has(map.wanted().text); });

  // another file, and a stop
  await page.files('#file', ['csv', 'toml'].map(ending => path.join(root, 'data', `shear_log.${ending}`)));
  await page.until(() => /^shear_log.csv: a log with 3 loading runs/.test(document.getElementById('read-title').textContent));
  await page.until(() => !document.getElementById('busy').hidden && /^Fitting/.test(document.getElementById('busy-says').textContent) || Boolean(window.explorer.experiment.result));
  await page.evaluate(() => document.getElementById('stop').click());
  await page.until(() => document.getElementById('busy').hidden);
  await page.evaluate(() => document.querySelector('#constants > button').click());
  await page.until(() => document.getElementById('busy').hidden && Boolean(window.explorer.experiment.result));

  for (const width of [500, 1280]) {  // the narrowest window that Firefox opens
    await page.resize(width, 900);
    await page.until(wanted => Math.abs(innerWidth - wanted) < 60, width).catch(() => expect(false, `no window of ${width} px`));
    await page.until(() => document.documentElement.scrollWidth <= innerWidth).catch(() => expect(false, `${width} px: the page is wider`));
    if (shots) await page.screenshot(path.join(shots, `firefox_${width}.png`));
  }
  const told = await page.evaluate(() => window.told);
  expect(told.length === 0, `the console says: ${told.join('; ')}`);
  const [paint, ready] = [0, 1].map(k => times.map(one => one[k]).sort((x, y) => x - y)[1]);
  expect(paint < 1500 && ready < 3000, `painted after ${paint} ms, ready after ${ready} ms`);
  console.log(`Firefox: painted after ${paint.toFixed(0)} ms, ready after ${ready.toFixed(0)} ms`);
}

if (!fs.existsSync(browser)) {
  console.log(`tests/explorer: SKIPPED: there is no ${browser} (tools/setup explorer)`);
  process.exit(77);
}
firefox(browser).then(page => main(page).catch(error => failures.push(error.stack)).then(() => page.close())).catch(error => failures.push(error.stack)).then(() => {
  failures.forEach(one => console.log(one));
  process.exit(failures.length ? 1 : 0);
});
