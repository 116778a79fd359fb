// The engine: its script and what was compiled are in the page, compressed.

function unpacked(id) {
  const packed = Uint8Array.from(atob(document.getElementById(id).textContent.trim()), c => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip')));
}

/// The engine's functions, each with a text of JSON answered as an object, or throwing the engine's sentence.
export async function loadEngine() {
  const script = document.createElement('script');
  script.textContent = await unpacked('engine').text();
  document.head.append(script);
  const engine = await window.mixity({wasmBinary: await unpacked('compiled').arrayBuffer()});
  const asked = text => {
    const told = JSON.parse(text);
    // what is said of flags is said of fields here
    if (told.error) throw new Error(told.error.replace(/: state it in .* or by a flag \(--\w+=\.\.\.\)/, '').replace(/^--(\w+): /, ''));
    return told;
  };
  return {
    version: engine.version(),
    define: text => asked(engine.define(text)),
    draw: request => asked(engine.draw(JSON.stringify(request))),
    map: (request, milliseconds) => asked(engine.map(request, milliseconds)),
    write: (name, bytes) => engine.write(name, bytes),
    read: (name, constants) => asked(engine.read(name, JSON.stringify(constants))),
    fit: (name, constants, options) => asked(engine.fit(name, JSON.stringify(constants), JSON.stringify(options))),
  };
}
