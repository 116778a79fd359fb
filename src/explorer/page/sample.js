// The shipped reconstruction of Mergel et al. 2018, put in when the page is made.
/* global SAMPLE_CSV, SAMPLE_TOML */
export function sample() {
  const bytes = text => new TextEncoder().encode(text);
  return [{name: 'mergel2018.csv', bytes: bytes(SAMPLE_CSV)}, {bytes: bytes(SAMPLE_TOML)}];
}
