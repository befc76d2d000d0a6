// SPDX-License-Identifier: GPL-3.0-or-later
// Renders formulas.tex to one SVG for each formula, beside it. Needs node and, in this folder,
//   npm install --no-save mathjax-full@3.2.2
// Glyphs become plain paths in currentColor, which Qt's SVG Tiny renderer draws; no fonts, no <use>.
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {mathjax} from 'mathjax-full/js/mathjax.js';
import {TeX} from 'mathjax-full/js/input/tex.js';
import {SVG} from 'mathjax-full/js/output/svg.js';
import {liteAdaptor} from 'mathjax-full/js/adaptors/liteAdaptor.js';
import {RegisterHTMLHandler} from 'mathjax-full/js/handlers/html.js';
import {AllPackages} from 'mathjax-full/js/input/tex/AllPackages.js';

const folder = dirname(fileURLToPath(import.meta.url));
const adaptor = liteAdaptor();
RegisterHTMLHandler(adaptor);
// Vermilion and bluish green of Okabe and Ito, readable on light and dark.
const macros = {bad: ['{\\color{bad}{#1}}', 1], good: ['{\\color{good}{#1}}', 1]};
const colours = '\\definecolor{bad}{RGB}{213,94,0}\\definecolor{good}{RGB}{0,158,115}';
const page = mathjax.document('', {
  InputJax: new TeX({packages: AllPackages, macros}),
  OutputJax: new SVG({fontCache: 'none'}),
});

const pxPerUnit = 0.02;  // 1000 units are the height of the font
const blocks = readFileSync(join(folder, 'formulas.tex'), 'utf8').split(/^%% /m).slice(1);
for (const block of blocks) {
  const end = block.indexOf('\n');
  const id = block.slice(0, end).trim();
  const tex = block.slice(end + 1).trim();
  let svg = adaptor.innerHTML(page.convert(colours + tex, {display: true}));
  if (/merror|<use|<text|<foreignObject/.test(svg)) throw new Error(`${id}: ${svg.slice(0, 400)}`);
  const [, , , width, height] = svg.match(/viewBox="(\S+) (\S+) (\S+) (\S+)"/);
  svg = svg
    .replace(/ style="[^"]*"/g, '')
    .replace(/ (data-[a-z-]+|role|focusable)="[^"]*"/g, '')
    .replace(/(<svg[^>]*) width="[^"]*" height="[^"]*"/,
      `$1 width="${Math.ceil(width * pxPerUnit)}" height="${Math.ceil(height * pxPerUnit)}"`);
  // fill and stroke of a colour stand on groups; stroke width 0 keeps glyphs as thin as they are.
  const hash = createHash('sha256').update(tex).digest('hex');
  writeFileSync(join(folder, `${id}.svg`), `<!-- tex ${hash} -->\n${svg}\n`);
  console.log(id);
}
