// The shipped reconstruction of Mergel et al. 2018, inserted when the page is assembled.
/* global SAMPLE_CSV, SAMPLE_TOML */
export function sample() {
  const bytes = text => new TextEncoder().encode(text);
  const name = 'mergel2018.csv';
  return [[{name, bytes: bytes(SAMPLE_CSV)}], {[name]: {bytes: bytes(SAMPLE_TOML)}}];
}
