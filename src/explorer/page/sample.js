// The shipped reconstruction of Mergel et al. 2018, inserted when the page is assembled.
/* global SAMPLE_CSV, SAMPLE_TOML */
export function sample() {
  const bytes = text => new TextEncoder().encode(text);
  return [{name: 'mergel2018.csv', bytes: bytes(SAMPLE_CSV)}, {bytes: bytes(SAMPLE_TOML)}];
}
