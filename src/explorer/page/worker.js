// The engine in a worker: the blob of this script begins with the engine's own (engine.js). Answers {call, args} by the
// engine's text, and tells meanwhile what part is done.
/* global mixity */
const atMost = 20;  // tellings a second

let engine = null;
let known = '';  // the law that is defined here

function started(module) {
  return mixity({instantiateWasm(imports, receive) {
    WebAssembly.instantiate(module, imports).then(instance => receive(instance, module), error => postMessage({failed: error.message}));
    return {};
  }});
}

function teller(id) {
  let last = performance.now();
  return part => {
    if (performance.now() - last < 1000 / atMost) return;
    last = performance.now();
    postMessage({id, part});
  };
}

self.onmessage = async ({data}) => {
  if (data.module) engine = started(data.module);
  const {id, call, args, files, law, told} = data, ready = await engine;
  if (data.module) return postMessage({ready: true});
  for (const [name, bytes] of files) ready.write(name, bytes);
  if (law && law !== known) ready.define(known = law);
  if (call === 'definition') known = '';  // which forgets the laws
  try {
    postMessage({id, text: ready[call](...args, ...(told ? [teller(id)] : []))});
  } catch (error) {  // what the engine does not catch, such as want of memory
    postMessage({id, text: JSON.stringify({error: `the engine stopped: ${error.message ?? error}`}), broken: true});
  }
};
