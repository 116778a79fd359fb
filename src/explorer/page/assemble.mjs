// Assembles the page in one file: node assemble.mjs ENGINE.js OUT.html, with node_modules beside OUT.html.
import {createHash} from 'node:crypto';
import {createRequire} from 'node:module';
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';

const [engine, out] = process.argv.slice(2).map(path => resolve(path));
const here = dirname(fileURLToPath(import.meta.url)), root = resolve(here, '../../..');
const text = path => readFileSync(resolve(here, path), 'utf8');
const modules = resolve(dirname(out), 'node_modules');
const esbuild = createRequire(resolve(modules, 'x.js'))('esbuild');

const bundle = async (entry, define = {}) => (await esbuild.build({
  entryPoints: [resolve(here, entry)], bundle: true, minify: true, write: false, format: 'iife', target: 'es2022',
  nodePaths: [modules], legalComments: 'inline', define,
})).outputFiles[0].text;
const bundled = await bundle('main.js', {
  WORKER: JSON.stringify(await bundle('worker.js')),
  SAMPLE_CSV: JSON.stringify(text('../../../data/mergel2018.csv')), SAMPLE_TOML: JSON.stringify(text('../../../data/mergel2018.toml')),
});
// the page uses the report's style: light, dark and printed
const style = /R"css\(([\s\S]*?)\)css"/.exec(text('../../report/page/style.h'))[1] + text('style.css');
// the WebAssembly is separate: as text within the script it would be a third longer
const script = readFileSync(engine, 'utf8'), before = 'data:application/octet-stream;base64,';
const from = script.lastIndexOf(before) + before.length, compiled = script.slice(from, script.indexOf(script[from - before.length - 1], from));
// The page runs only these three scripts and the WebAssembly, in workers too, which are blobs of the page; it fetches nothing
// from outside.
const engineScript = script.replace(compiled, ''), loader = await bundle('loader.js');
const hash = content => `'sha256-${createHash('sha256').update(content).digest('base64')}'`;
const policy = `default-src 'none'; script-src ${hash(loader)} ${hash(bundled)} ${hash(engineScript)} 'wasm-unsafe-eval'; worker-src blob:; style-src 'unsafe-inline'; ` +
  "img-src data: blob:; connect-src data:; base-uri 'none'; form-action 'none'";
const packed = bytes => gzipSync(bytes, {level: 9}).toString('base64');
const parts = {
  STYLE: style,
  LOADER: loader,
  SCRIPT: packed(bundled),
  CONTACT: text('../../../docs/contact.svg'),
  ENGINE: packed(engineScript),
  POLICY: policy,
  COMPILED: packed(Buffer.from(compiled, 'base64')),
};
const page = text('index.html').replace(/\/\*(STYLE|LOADER|SCRIPT|CONTACT|ENGINE|COMPILED|POLICY)\*\//g, (_, name) => parts[name]);
writeFileSync(out, page);
console.log(`${out}: ${(page.length / 1e6).toFixed(2)} MB`);
