// The engine: the page contains its script and its WebAssembly, compressed. One instance is on the page itself, for what
// a slider needs within a frame; one in a worker reads and fits files, another computes maps.
/* global WORKER */
import {asked, Remote} from './remote.js';

/// A law with the key that it has on the page.
const withKey = (model, text) => (/^law_\d+$/.test(model) ? `${model}: ${text}` : text);

/// The engine's functions: those of sliders return their result as an object or throw the engine's sentence with the
/// recommended options, the others promise it.
export async function loadEngine() {
  const [text, module] = await Promise.all([window.packed.engine, window.packed.module]);
  window.packed.run(text);
  const engine = await window.mixity({instantiateWasm(imports, receive) {
    WebAssembly.instantiate(module, imports).then(instance => receive(instance, module));
    return {};
  }});
  const address = URL.createObjectURL(new Blob([text, '\n', WORKER], {type: 'text/javascript'}));
  const [files, maps] = [new Remote(address, module), new Remote(address, module)];
  const laws = law => { files.law = maps.law = law; };
  return {
    version: engine.version(),
    files,
    define(text) {
      const law = asked(engine.define(text));
      laws(withKey(law.model, text));
      return law;
    },
    draw: request => asked(engine.draw(JSON.stringify(request))),
    map: request => maps.call('map', [request]),
    definition: name => files.call('definition', [name]),
    write: (name, bytes) => files.write(name, bytes),
    read: (names, constants, asPoints) => files.call('read', [JSON.stringify(names), JSON.stringify(constants), asPoints]),
    cut: (names, stem, constants) => files.call('cut', [JSON.stringify(names), stem, JSON.stringify(constants)]),
    fit: (names, constants, options, progress) => files.call('fit', [JSON.stringify(names), JSON.stringify(constants), JSON.stringify(options)], progress),
    stop: () => files.stop(),
    /// Fits these files in the worker of maps, for nothing but that: browsers translate well what has run, for all workers.
    warmUp(written) {
      for (const [name, bytes] of Object.entries(written)) maps.write(name, bytes);
      return maps.call('fit', [JSON.stringify(Object.keys(written).slice(0, 1)), '{}', '{}'], () => {}).catch(() => {});
    },
  };
}
