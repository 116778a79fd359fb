// Dropped and saved files, and line numbers as text.

const textOf = file => new TextDecoder().decode(file.bytes);
const isToml = file => /\.toml$/i.test(file.name);

/// Sorts dropped files: {data, beside: TOML of the data, definition: of a fit, problem: why they are not used}.
export async function parted(files) {
  const all = await Promise.all(files.map(async file => ({name: file.name.replaceAll('/', '_'), bytes: new Uint8Array(await file.arrayBuffer())})));
  const tomls = all.filter(isToml), definition = tomls.find(file => /^\s*(data\s*=|\[\[runs\]\])/m.test(textOf(file)));
  const data = all.filter(file => !isToml(file)), other = data.find(({name}) => /\.(json|html?|svg|png|jpe?g|gif|pdf|docx?)$/i.test(name));
  const problem = other ? `${other.name} is no table: drop the data as CSV or text, and with them a TOML if there is one.`
    : data.length > 1 ? 'One file of data at a time: the program pools several (mixity fit run_*.csv --pool).'
    : data.length || definition ? '' : 'That is a TOML alone: drop the data with it.';
  return {data: data[0], definition, beside: tomls.find(file => file !== definition), problem};
}

/// "4,7-9" of line numbers.
export function ranges(lines) {
  const parts = [];
  for (const n of [...lines].sort((x, y) => x - y)) {
    const last = parts.at(-1);
    if (last && n === last[1] + 1) last[1] = n;
    else parts.push([n, n]);
  }
  return parts.map(([first, last]) => first === last ? `${first}` : `${first}-${last}`).join(',');
}

/// Whether a line is among "4,7-9".
export function among(text) {
  const parts = text.split(',').filter(Boolean).map(part => part.split('-').map(Number));
  return n => parts.some(([first, last = first]) => n >= first && n <= last);
}

/// What remains of runs without these lines: [first, last] of each, and the lines to leave out between them.
export function cropped(runs, text) {
  const out = among(text), kept = runs.map(({lines}) => {
    let first = 0, last = lines.length - 1;
    while (first < last && out(lines[first])) ++first;
    while (last > first && out(lines[last])) --last;
    return [first, last];
  });
  return {kept, between: ranges(runs.flatMap(({lines}, i) => lines.filter((n, k) => k >= kept[i][0] && k <= kept[i][1] && out(n))))};
}

/// Offers a file for download.
export function offer(name, type, content) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], {type}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
