// 50 names that try to run a script or to fetch something, of runs, a column, a file, in texts and in the address of the
// page: nothing of them runs, and nothing is fetched. What they would do is harmless: set the title, or ask a server of
// this test.
'use strict';
const fs = require('fs');
const http = require('http');
const path = require('path');
const root = path.resolve(__dirname, '../..');
const built = path.join(root, 'build/explorer');
const {chromium} = require(path.join(built, 'node_modules/playwright-core'));
const {elements, before} = JSON.parse(fs.readFileSync(path.join(root, 'tests/report/page/hostile_names.json'), 'utf8'));
const failures = [];
const expect = (holds, message) => { if (!holds) failures.push(message); };

function namesFor(url) {
  const made = (text, i) => text.replaceAll('{run}', "document.title='ran'").replaceAll('{url}', `${url}/name${i}`);
  return Array.from({length: 50}, (_, i) => before[i % before.length] + made(elements[i % elements.length], i));
}

/// Runs with these names; the heading of their column is one of them, too.
function dataOf(names) {
  const quoted = text => '"' + text.replaceAll('"', '""') + '"';
  const rows = names.flatMap((name, i) => [0, 2, 4].map(T => [quoted(name), 1 + .1 * i, T, 19.5 + .3 * i - .02 * T * T].join(',')));
  return ['curve,P,T,A,' + quoted(names[2]), ...rows.map(row => row + ',1')].join('\n') + '\n';
}

async function main() {
  const asked = [];
  const server = http.createServer((request, response) => { asked.push(request.url); response.writeHead(404).end(); });
  await new Promise(ready => server.listen(0, '127.0.0.1', ready));
  const names = namesFor(`http://127.0.0.1:${server.address().port}`);
  const browser = await chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox']});
  const page = await browser.newPage({viewport: {width: 1280, height: 900}});

  // Without a defence the title is set and the server is asked: the test can fail.
  await page.setContent('<title>control</title>' + names.slice(0, 4).join(''));
  await page.waitForFunction(() => document.title === 'ran');
  await page.waitForTimeout(200);
  expect(asked.length > 0, 'the browser fetches nothing at all');
  asked.length = 0;

  const seen = async where => {
    await page.waitForTimeout(100);
    expect(await page.title() !== 'ran', `${where}: a script ran`);
  };
  // Names are text in the page: its policy has nothing to stop.
  page.on('console', message => expect(!/Content Security Policy/.test(message.text()), message.text()));
  const address = 'file://' + path.join(built, 'explorer.html');
  await page.goto(address);
  await page.waitForFunction(() => window.explorer);
  const buffer = text => Buffer.from(text);
  const toml = `source = '''${names[1]}'''\nnote = '''${names[3]}'''\n`;
  const stem = names[1].replaceAll('/', '');
  await page.setInputFiles('#file', [{name: stem + '.csv', mimeType: 'text/csv', buffer: buffer(dataOf(names))}, {name: stem + '.toml', mimeType: 'application/toml', buffer: buffer(toml)}]);
  await page.waitForFunction(() => window.explorer.experiment.result?.fits.datasets[0].fits.length > 0, undefined, {timeout: 60000});
  const listed = await page.$$eval('#run option', options => options.map(one => one.textContent));
  expect(names.every(name => listed.some(text => text.includes(name.trim()))), `the names of runs are not listed as they are: ${listed.slice(0, 3)}`);
  await seen('read');
  for (let i = 0; i < names.length; i += 7) {  // what each figure says of the point below the pointer
    await page.selectOption('#run', String(i));
    for (const chart of await page.$$('[id^=chart]')) {
      if (!(await chart.isVisible())) continue;
      await chart.scrollIntoViewIfNeeded();
      const box = await chart.boundingBox();
      for (const [x, y] of [[.3, .4], [.5, .5], [.7, .6]]) await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    }
  }
  await seen('under the pointer');
  for (const name of names) {  // a refusal names what it refuses
    const wrong = 'P [mN],T [mN],"A [' + name.replaceAll('"', '""') + ']"\n1,2,x\n';
    await page.setInputFiles('#file', {name: 'wrong.csv', mimeType: 'text/csv', buffer: buffer(wrong)});
    await page.waitForFunction(() => !document.getElementById('trouble').hidden);
    await page.fill('#law', name);
    await page.press('#law', 'Enter');
  }
  await seen('refused');
  for (const name of names) await page.evaluate(text => { location.hash = `law=${encodeURIComponent(text)}&map=${encodeURIComponent(text)}&c=${encodeURIComponent(text)}`; }, name);
  await seen('in the address');
  await page.goto('about:blank');
  await page.goto(`${address}#law=${encodeURIComponent(names[0])}`);
  await page.waitForFunction(() => window.explorer);
  await seen('opened with an address');
  expect(asked.length === 0, `fetched: ${asked.slice(0, 5)}`);
  await browser.close();
  server.close();
}

main().catch(error => failures.push(error.stack)).then(() => {
  failures.forEach(one => console.log(one));
  process.exit(failures.length ? 1 : 0);
});
