// Unpacks the page's script, the engine's script and its WebAssembly at once, and runs the page's script. Until that runs,
// files that are dropped are kept for it.
const decoded = text => Uint8Array.fromBase64?.(text) ?? Uint8Array.from(atob(text), c => c.charCodeAt(0));
const unpacked = id => new Blob([decoded(document.getElementById(id).textContent.trim())]).stream().pipeThrough(new DecompressionStream('gzip'));
const textOf = id => new Response(unpacked(id)).text();

globalThis.early = [];
const keep = event => {
  event.preventDefault();
  if (event.type === 'drop') globalThis.early = [...event.dataTransfer.files];
};
for (const name of ['dragover', 'drop']) addEventListener(name, keep);

const module = WebAssembly.compileStreaming(new Response(unpacked('compiled'), {headers: {'Content-Type': 'application/wasm'}}));
const [page, engine] = ['page', 'engine'].map(textOf);
module.catch(() => {});  // the start of the engine says so

/// Text as a script of the page.
function run(text) {
  const script = document.createElement('script');
  script.textContent = text;
  document.head.append(script);
}
globalThis.packed = {module, engine, run};
page.then(text => {
  run(text);
  for (const name of ['dragover', 'drop']) removeEventListener(name, keep);
});
