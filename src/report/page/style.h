// The style sheet of the report's page: light and dark, narrow and wide, printed.
#pragma once

namespace mixity {

inline constexpr char kPageStyle[] = R"css(
:root {
  color-scheme: light dark;
  --ink: #16191d; --paper: #ffffff; --soft: #5b6570; --line: #d7dce1; --sheet: #f5f7f9; --warn: #fff1d6; --alert: #a33c00;
  --color-0: #000000; --color-1: #d55e00; --color-2: #0072b2; --color-3: #009e73;
  --color-4: #cc79a7; --color-5: #e69f00; --color-6: #56b4e9; --color-7: #7f7f7f;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #e8ebee; --paper: #15181c; --soft: #a2acb6; --line: #363d45; --sheet: #1d2227; --warn: #3b2e12; --alert: #ffb07a;
    --color-0: #e8ebee; --color-1: #ff8a3d; --color-2: #4fb3f6; --color-3: #2fd0a2;
    --color-4: #e6a0c8; --color-5: #ffc24d; --color-6: #9bd6fa; --color-7: #a6a6a6;
  }
}
@media screen and (prefers-color-scheme: dark) {
  figure img { filter: invert(.91) hue-rotate(180deg); }  /* black on white becomes the page's ink on its paper */
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1.5rem 1rem 3rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Liberation Sans", sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .2rem; overflow-wrap: anywhere; }
h2 { font-size: 1.35rem; margin: 2.5rem 0 .6rem; break-after: avoid; padding-top: .8rem; border-top: 2px solid var(--ink); overflow-wrap: anywhere; }
h3 { font-size: 1.05rem; margin: 1.8rem 0 .6rem; break-after: avoid; }
p { margin: .4rem 0; max-width: 48rem; overflow-wrap: anywhere; }
ul { margin: .4rem 0; padding-left: 1.2rem; max-width: 48rem; overflow-wrap: anywhere; }
a { color: var(--color-2); }
code { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .9em; overflow-wrap: anywhere; }
.soft { color: var(--soft); }
.banner { background: var(--warn); border-left: 5px solid var(--color-5); padding: .6rem .9rem; margin: .6rem 0; max-width: 48rem; }
.alert { color: var(--alert); font-weight: 600; }
.answer { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: 1.2rem; align-items: start; margin: 1rem 0; }
.answer > div:only-child { grid-column: 1 / -1; }
.result { font-size: clamp(1.2rem, 6vw, 1.7rem); line-height: 1.25; font-weight: 600; margin: 0 0 .5rem; }
.bar { display: flex; height: 1rem; border-radius: 3px; overflow: hidden; }
.bar span, .key span::before { background: var(--part); }
.bar span { min-width: 1px; }
.key { font-size: .88rem; }
.key span { white-space: nowrap; margin-right: .8rem; }
.key span::before { content: ""; display: inline-block; width: .7em; height: .7em; margin-right: .35em; }
.jumps { margin: 1.2rem 0; }
caption { text-align: left; font-weight: 600; padding-bottom: .3rem; }
table { border-collapse: collapse; font-size: .92rem; }
th, td { text-align: left; vertical-align: top; padding: .35rem .8rem .35rem 0; border-bottom: 1px solid var(--line); font-variant-numeric: tabular-nums; }
th { font-weight: 600; }
thead th { vertical-align: bottom; }
.fits { margin: .8rem 0; }
th div + div { font-weight: 400; color: var(--soft); }
.figures { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 1.2rem; }
figure { margin: 0; border: 1px solid var(--line); border-radius: 6px; padding: .6rem; break-inside: avoid; min-width: 0; }
figure.wide { grid-column: 1 / -1; }
figure svg { display: block; width: 100%; height: auto; }
figure svg text, figure svg tspan { font-family: inherit; }
figure img { display: block; width: 100%; height: auto; }
figcaption { font-size: .88rem; color: var(--soft); margin-top: .4rem; }
figcaption strong, .head { color: var(--ink); }
.head { font-weight: 600; margin-top: .6rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: .5rem 0; max-width: 48rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
.part { border-top: 1px solid var(--line); }
.part > summary { font-weight: 600; padding: .6rem 0; break-after: avoid; }
.part[open] { padding-bottom: 1rem; }
summary { cursor: pointer; }
.set { border-top: 1px solid var(--line); }
.set > summary { padding: .5rem 0; overflow-wrap: anywhere; }
.set > summary > * { display: inline-block; border: 0; padding: 0; margin: 0 .6rem 0 0; font-size: 1.05rem; vertical-align: top; }
.set[open] { border-top: 2px solid var(--ink); padding-bottom: 2rem; }
.narrow { display: none; }
@media screen and (max-width: 64rem) {
  .answer { grid-template-columns: minmax(0, 1fr); }
}
@media screen and (max-width: 60rem) {
  .fits, .fits tbody, .fits tr, .fits td, .fits th { display: block; border: 0; padding: 0; }
  .fits thead { display: none; }
  .fits tr { border-top: 1px solid var(--line); padding: .6rem 0; }
  .fits td:not([data-label]) { display: none; }
  .fits td { display: grid; grid-template-columns: 9rem 1fr; gap: 0 .6rem; padding: .15rem 0; overflow-wrap: anywhere; }
  .fits td::before { content: attr(data-label); color: var(--soft); grid-row: 1 / span 9; }
  .fits td div { grid-column: 2; }
}
@media screen and (max-width: 46rem) {
  .figures { grid-template-columns: minmax(0, 1fr); }
  .broad { display: none; }
  .narrow { display: block; }
  .jumps { font-size: .85rem; }
  .jumps th, .jumps td { padding-right: .4rem; }
  dl { grid-template-columns: 1fr; }
  dt { margin-top: .3rem; }
}
@media print {
  :root { --ink: #000; --paper: #fff; --soft: #333; --line: #bbb; --warn: #fff; --color-0: #000000; --color-1: #d55e00;
    --color-2: #0072b2; --color-3: #009e73; --color-4: #cc79a7; --color-5: #e69f00; --color-6: #56b4e9; --color-7: #7f7f7f; }
  @page { margin: 12mm 11mm; }
  /* three figures in a row, captions small: a data set fills five pages at most */
  body { max-width: none; padding: 0; font-size: 8.5pt; line-height: 1.35; }
  p, ul, dl, .banner { max-width: none; }
  .files { display: none; }
  ::details-content { content-visibility: visible; block-size: auto; }
  summary { list-style: none; }
  h1 { font-size: 13pt; }
  h2 { font-size: 12pt; margin: 3mm 0 2mm; padding-top: 1mm; }
  section + section, header:has(.fits) + main > section { break-before: page; }
  h3, h4, .part > summary { break-after: avoid; margin: 3mm 0 1mm; font-size: 9.5pt; }
  .part > summary { padding: 1.5mm 0; }
  .part[open] { padding-bottom: 2mm; }
  .part > summary + * { break-before: avoid; }
  .answer { grid-template-columns: 1fr 1fr; gap: 4mm; margin: 2mm 0; break-inside: avoid; }
  .answer svg { max-height: 85mm; }
  .result { font-size: 14pt; }
  .bar span, .key span::before { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .key { font-size: 7.5pt; }
  dl { grid-template-columns: repeat(4, max-content 1fr); }
  .figures { grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 2.5mm; }
  figure { padding: 1.5mm; border-radius: 0; }
  figure.wide { grid-column: auto; }
  figure.screen, .wide .broad { display: none; }
  /* one alone in the last row has its caption beside it, which makes the row less high */
  .figures > figure:nth-child(3n + 1 of :not(.screen)):nth-last-child(1 of :not(.screen)) { grid-column: 1 / -1; display: grid;
    grid-template-columns: calc((100% - 5mm) / 3) 1fr; gap: 3mm; align-items: start; }
  .wide .narrow { display: block; }
  .wide .narrow svg { max-height: 58mm; }
  .fits td:nth-child(2) { min-width: 60mm; }
  figcaption { font-size: 6.5pt; line-height: 1.25; margin-top: 1mm; }
  table { font-size: 7.5pt; }
  th, td { padding: .8mm 2.5mm .8mm 0; }
  tr { break-inside: avoid; }
}
)css";

}  // namespace mixity
