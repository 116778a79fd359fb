// The engine: the page contains its script and its WebAssembly, compressed.

function unpacked(id) {
  const packed = Uint8Array.from(atob(document.getElementById(id).textContent.trim()), c => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip')));
}

/// The engine's functions. Each returns the JSON result as an object, or throws the engine's sentence with the
/// recommended options.
export async function loadEngine() {
  const script = document.createElement('script');
  script.textContent = await unpacked('engine').text();
  document.head.append(script);
  const engine = await window.mixity({wasmBinary: await unpacked('compiled').arrayBuffer()});
  const asked = text => {
    const told = JSON.parse(text);
    if (told.error) throw Object.assign(new Error(told.error), {options: told.options ?? []});
    return told;
  };
  return {
    version: engine.version(),
    define: text => asked(engine.define(text)),
    draw: request => asked(engine.draw(JSON.stringify(request))),
    map: (request, milliseconds) => asked(engine.map(request, milliseconds)),
    definition: name => asked(engine.definition(name)),
    write: (name, bytes) => engine.write(name, bytes),
    read: (name, constants) => asked(engine.read(name, JSON.stringify(constants))),
    fit: (name, constants, options) => asked(engine.fit(name, JSON.stringify(constants), JSON.stringify(options))),
  };
}
