// The published models at their boxes: who proposed them, the law, and what its parameter means.
export const laws = {
  a: {name: 'Johnson 1996', law: 'f = 1 + (1−λ) tan²ψ', brittle: 1},
  b: {name: 'Waters-Guduru 2010', law: 'f = 1 + tan²((1−λ/2) ψ)', brittle: 2},
  c: {name: 'Papangelo-Ciavarella 2019', law: 'f = 1/(1 + (λ−1) sin²ψ)', brittle: 1},
  bk: {name: 'Benzeggagh-Kenane 1996', law: 'f = 1 + (r−1) B<sup>η</sup>, B = sin²ψ'},
};

/// What the ends of λ mean, as HTML.
export function meaning(model) {
  const {name, law, brittle} = laws[model];
  const who = `${name}: ${law}.`;
  if (!brittle) return `${who} r is the toughness in shear over G<sub>Ic</sub>; η sets how fast f rises to it.`;
  return `${who} λ = 0: shear does not help to open the contact, and its area stays as without shear. λ = ${brittle}: all energy helps, the toughness stays G<sub>Ic</sub>, and the area falls most.`;
}
