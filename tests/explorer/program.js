// What the tests of the page share: where things are, the program beside which the page is judged, and what failed.
'use strict';
const path = require('path');
const {execFileSync} = require('child_process');
const root = path.resolve(__dirname, '../..');
const built = path.join(root, 'build/explorer');
const program = path.join(root, 'build/release/src/mixity');
const shots = process.env.MIXITY_SHOTS;  // a folder for pictures of the page
const failures = [];
const expect = (holds, message) => { if (!holds) failures.push(message); };
const near = (one, other, part) => Math.abs(one - other) <= part * Math.abs(other);

/// What the program prints.
function run(words, where) {
  try {
    return execFileSync(program, words, {cwd: where, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
  } catch (ended) {  // 1: a fit that cannot be believed
    return ended.stdout;
  }
}

module.exports = {root, built, program, shots, failures, expect, near, run};
