// The curves of the models at the sliders' values, and a sentence on each model.
import {color, degrees, line, marks, shown} from './charts.js';

/// Draws the figure `name` of `models`: area, toughness, displacement or radius.
export function drawCurve(models, name) {
  // the toughness is drawn also where a law defines no equilibrium
  const {state, all} = models, there = all.filter(one => !one.problem || (name === 'toughness' && one.toughness)), names = there.map(one => models.title(one.model));
  const what = {
    area: `Contact area against tangential load at P = ${shown(state.P)} mN`,
    toughness: 'Toughness against phase angle',
    displacement: `Tangential load against displacement at P = ${shown(state.P)} mN`,
    radius: `Contact radius against normal load at T = ${shown(state.T)} mN`,
  }[name];
  const behind = name === 'area' ? measuredNear(models.measured, state.P) : null;
  models.figures[name].draw([...there.flatMap(one => series[name](one, models.title(one.model), color(models.tint(one.model)), state)), ...(behind ? [behind] : [])],
    `${what} for ${names.join(', ') || 'no model'}`, {legend: {data: [...names, ...(behind ? [behind.name] : [])]}, ...(name === 'area' ? {xAxis: {max: mostShear(behind, there, state)}} : {})});
}

/// Where points are shown, T ends a little beyond them, the jumps and the slider's T, and not where the last curve ends.
function mostShear(behind, there, {T}) {
  if (!behind) return null;
  const jumps = there.flatMap(one => one.folds.map(fold => fold.T));
  return Number((1.2 * Math.max(Math.abs(T), ...behind.data.map(([at]) => at), ...jumps)).toPrecision(2));
}

/// The points of the user's run with the load nearest to P, if there is one.
function measuredNear(measured, P) {
  const run = measured?.runs.reduce((best, one) => (!best || Math.abs(one.P - P) < Math.abs(best.P - P) ? one : best), null);
  if (!run) return null;
  const name = `${measured.word} at P = ${shown(run.P)} mN`;
  return marks('behind', name, run.T.map((T, k) => [Math.abs(T), run.A[k]]), color(7), 'circle', {z: 0, symbolSize: 6,
    hover: k => `${name}<br>T = ${shown(run.T[k], 5)} mN, A = ${shown(run.A[k], 5)} mm²`});
}

/// What each figure shows of one model, with the model's title and colour.
const series = {
  area(one, title, tint, {T}) {
    const jump = jumpOf(one);
    return [...twoParts(one, title, tint, one.curve.T, one.curve.A), ...folds(one, title, tint, fold => [fold.T, fold.A]),
      line(`${one.model}-jump`, title, jump ? [[jump.T, jump.A], [jump.T, jump.area_after]] : [], tint, 'dotted'),
      ...(one.held ? [line(`${one.model}-held`, `${title}, approach held`, one.held.curve.map(([at, A]) => [at, A]), tint, [8, 3, 2, 3])] : []),
      here(one, title, tint, one.state && [Math.abs(T), one.state.A])];
  },
  toughness(one, title, tint) {
    return [line(`${one.model}-law`, title, one.toughness.map(([psi, f]) => [degrees(psi), Math.max(f, 1)]), tint),
      here(one, title, tint, one.state && one.state.psi !== undefined && [degrees(one.state.psi), one.state.f])];
  },
  displacement(one, title, tint) {
    return [...twoParts(one, title, tint, one.curve.u, one.curve.T), ...folds(one, title, tint, fold => [fold.u, fold.T])];
  },
  radius(one, title, tint, {P}) {
    return [line(`${one.model}-stable`, title, one.radii.stable, tint), line(`${one.model}-unstable`, title, one.radii.unstable, tint, 'dashed'),
      here(one, title, tint, one.state && [P, Math.sqrt(one.state.A / Math.PI)])];
  },
};

/// The fold under load control, if there is one.
const jumpOf = one => one.folds.find(fold => fold.control === 'load');

/// Solid up to the first place where the contact is not stable, then dashed.
function twoParts(one, title, tint, x, y) {
  const turn = one.curve.stable.indexOf(false), end = turn < 0 ? x.length : turn;
  const along = (from, to) => x.slice(from, to).map((value, i) => [value, y[from + i]]);
  return [line(`${one.model}-stable`, title, along(0, end), tint), line(`${one.model}-unstable`, title, along(Math.max(end - 1, 0), x.length), tint, 'dashed')];
}

function folds(one, title, tint, place) {
  return ['load', 'displacement'].map(control => marks(`${one.model}-${control}`, title, one.folds.filter(fold => fold.control === control).map(fold => ({
    value: place(fold),
    hover: `${title} jumps under ${control} control:<br>T = ${shown(fold.T)} mN, A = ${shown(fold.A)} mm², u = ${shown(fold.u)} µm<br>to ${fold.jumps_to}`,
  })), tint, control === 'load' ? 'triangle' : 'diamond'));
}

function here(one, title, tint, place) {
  return marks(`${one.model}-here`, title, place ? [place] : [], tint, 'circle', {itemStyle: {color: tint}});
}

/// "Model c (λ = 0.0023): A = 0.38 mm² at T = 60 mN; jumps at T = ..."
export function sentence(models, one) {
  const named = models.title(one.model).replace(/^./, first => first.toUpperCase());
  if (one.problem) return `${named}: ${one.problem}.`;
  const jump = jumpOf(one);
  const beyond = jump ? `beyond its jump, A = ${shown(jump.area_after)} mm² if it slides at that` : 'beyond its last equilibrium';
  const now = one.state ? `A = ${shown(one.state.A)} mm²` : beyond;
  return `${named} (${models.chosen(one.model)}): ${now} at T = ${shown(models.state.T)} mN; ` +
    (jump ? `jumps at T = ${shown(jump.T)} mN from ${shown(jump.A)} to ${shown(jump.area_after)} mm².` : `${one.regime}.`) + heldText(one.held);
}

/// What the contact does where its approach is held in place of the load.
function heldText(held) {
  if (!held?.curve.length) return '';
  const [[T, A, P] = []] = held.state ?? [], {end} = held;
  const now = held.state ? `A = ${shown(A)} mm² and P = ${shown(P)} mN at T = ${shown(T)} mN` : 'no contact at this T';
  return ` With its approach held at ${shown(held.approach)} µm: ${now}; ${end?.fold ? `jumps at T = ${shown(end.at[0])} mN` : 'does not jump'}.`;
}
