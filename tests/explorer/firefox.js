// Firefox without a window, driven through Marionette, which Firefox itself speaks: no driver program, no package.
'use strict';
const fs = require('fs');
const net = require('net');
const os = require('os');
const path = require('path');
const {spawn} = require('child_process');

/// Messages are their length, a colon, and JSON: [0, id, command, parameters] and [1, id, error, result].
class Marionette {
  constructor(socket) {
    Object.assign(this, {socket, waiting: new Map(), last: 0, bytes: Buffer.alloc(0)});
    socket.on('data', bytes => {
      this.bytes = Buffer.concat([this.bytes, bytes]);
      for (let colon = this.bytes.indexOf(':'); colon > 0; colon = this.bytes.indexOf(':')) {
        const end = colon + 1 + Number(this.bytes.subarray(0, colon));
        if (this.bytes.length < end) return;
        this.take(JSON.parse(this.bytes.subarray(colon + 1, end)));
        this.bytes = this.bytes.subarray(end);
      }
    });
  }

  take(message) {
    if (!Array.isArray(message)) return;  // the greeting
    const [, id, error, result] = message, {resolve, reject} = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) reject(new Error(`${error.error}: ${error.message}`));
    else resolve(result);
  }

  send(command, parameters = {}) {
    const id = ++this.last, text = JSON.stringify([0, id, command, parameters]);
    this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject}));
  }
}

const freePort = () => new Promise(resolve => {
  const server = net.createServer().listen(0, '127.0.0.1', () => {
    const {port} = server.address();
    server.close(() => resolve(port));
  });
});

const connected = port => new Promise((resolve, reject) => {
  const socket = net.connect(port, '127.0.0.1', () => resolve(socket));
  socket.on('error', reject);
});

/// Starts `program`; an object with open(address), evaluate(function, ...arguments), until(function, ...), files(selector,
/// paths), screenshot(width, height) and close().
exports.firefox = async program => {
  const port = await freePort(), profile = fs.mkdtempSync(path.join(os.tmpdir(), 'mixity-firefox-'));
  fs.writeFileSync(path.join(profile, 'user.js'), [['marionette.port', port], ['browser.shell.checkDefaultBrowser', false], ['app.update.disabledForTesting', true],
    ['datareporting.policy.dataSubmissionEnabled', false]].map(one => `user_pref(${JSON.stringify(one[0])}, ${JSON.stringify(one[1])});\n`).join(''));
  const child = spawn(program, ['--headless', '--marionette', '--no-remote', '--profile', profile], {stdio: 'ignore', env: {...process.env, HOME: profile}});
  const ended = new Promise(resolve => child.on('exit', resolve));
  let socket = null;
  for (const begin = Date.now(); !socket; await new Promise(resolve => setTimeout(resolve, 200))) {
    socket = await connected(port).catch(() => null);
    if (!socket && (Date.now() - begin > 60000 || child.exitCode !== null)) throw new Error(`${program} does not answer`);
  }
  const driver = new Marionette(socket);
  await driver.send('WebDriver:NewSession', {capabilities: {alwaysMatch: {acceptInsecureCerts: false}}});
  const evaluate = async (work, ...args) => (await driver.send('WebDriver:ExecuteScript', {script: `return (${work})(...arguments);`, args, sandbox: null})).value;
  return {
    evaluate,
    open: url => driver.send('WebDriver:Navigate', {url}),
    async until(work, ...args) {
      for (const begin = Date.now(); Date.now() - begin < 60000; await new Promise(resolve => setTimeout(resolve, 50)))
        if (await evaluate(work, ...args)) return;
      throw new Error(`in vain: ${work}`);
    },
    async files(selector, paths) {
      const {value} = await driver.send('WebDriver:FindElement', {using: 'css selector', value: selector});
      await driver.send('WebDriver:ElementSendKeys', {id: Object.values(value)[0], text: paths.join('\n')});
    },
    async screenshot(file) {
      fs.writeFileSync(file, Buffer.from((await driver.send('WebDriver:TakeScreenshot', {full: true, id: null})).value, 'base64'));
    },
    resize: (width, height) => driver.send('WebDriver:SetWindowRect', {width, height}),
    async close() {
      await driver.send('Marionette:Quit', {flags: ['eForceQuit']}).catch(() => child.kill());
      socket.destroy();
      await ended;
      fs.rmSync(profile, {recursive: true, force: true});
    },
  };
};
