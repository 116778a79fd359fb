// Excel workbooks for tests, as a zip file with parts that are packed.
'use strict';
const zlib = require('zlib');

const escaped = text => String(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;');
const cell = value => (value !== '' && Number.isFinite(Number(value)) ? `<c><v>${value}</v></c>` : `<c t="inlineStr"><is><t>${escaped(value)}</t></is></c>`);
const sheetOf = rows => `<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>${rows.map(row => `<row>${row.map(cell).join('')}</row>`).join('')}</sheetData></worksheet>`;

function sumOf(bytes) {
  let sum = -1;
  for (const byte of bytes) {
    sum ^= byte;
    for (let k = 0; k < 8; ++k) sum = sum & 1 ? sum >>> 1 ^ 0xedb88320 : sum >>> 1;
  }
  return ~sum >>> 0;
}

/// Numbers of 2 or 4 bytes: [[value, bytes]].
const numbers = list => Buffer.concat(list.map(([value, n]) => {
  const bytes = Buffer.alloc(n);
  bytes.writeUIntLE(value, 0, n);
  return bytes;
}));

function zipOf(parts) {
  const files = [], directory = [];
  let at = 0;
  for (const [name, content] of Object.entries(parts)) {
    const bytes = Buffer.from(content), packed = zlib.deflateRawSync(bytes), title = Buffer.from(name);
    const about = [[20, 2], [0, 2], [8, 2], [0, 4], [sumOf(bytes), 4], [packed.length, 4], [bytes.length, 4], [title.length, 2], [0, 2]];
    files.push(numbers([[0x04034b50, 4], ...about]), title, packed);
    directory.push(numbers([[0x02014b50, 4], [20, 2], ...about, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]]), title);
    at += 30 + title.length + packed.length;
  }
  const list = Buffer.concat(directory), n = Object.keys(parts).length;
  return Buffer.concat([...files, list, numbers([[0x06054b50, 4], [0, 2], [0, 2], [n, 2], [n, 2], [list.length, 4], [at, 4], [0, 2]])]);
}

/// `sheets`: rows by the name of the sheet; `others`: contents of parts in place of those made here.
exports.workbookOf = (sheets, others = {}) => {
  const names = Object.keys(sheets), office = 'http://schemas.openxmlformats.org/officeDocument/2006/relationships';
  const relations = list => `<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">${list.map(([type, target], i) => `<Relationship Id="r${i + 1}" Type="${office}/${type}" Target="${target}"/>`).join('')}</Relationships>`;
  const parts = {
    '_rels/.rels': relations([['officeDocument', 'xl/workbook.xml']]),
    'xl/workbook.xml': `<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="${office}"><sheets>${names.map((name, i) => `<sheet name="${escaped(name)}" sheetId="${i + 1}" r:id="r${i + 1}"/>`).join('')}</sheets></workbook>`,
    'xl/_rels/workbook.xml.rels': relations(names.map((_, i) => ['worksheet', `worksheets/sheet${i + 1}.xml`])),
  };
  Object.values(sheets).forEach((rows, i) => { parts[`xl/worksheets/sheet${i + 1}.xml`] = sheetOf(rows); });
  return zipOf({...parts, ...others});
};
