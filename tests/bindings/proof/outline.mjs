// Reads the curves of an SVG file, simplifies them, moves their outlines apart, unites what overlaps, and writes an SVG file.
// Usage: node outline.mjs drawing.svg outline.svg
import fs from 'node:fs';
import { load, BattenError } from 'batten-core';

const [from, to] = process.argv.slice(2);
const b = await load();
try {
  const drawing = b.readSvg(fs.readFileSync(from, 'utf8'));
  const apart = [];
  for (const object of drawing.objects) {
    for (const curve of object.curves) {
      const simple = curve.simplify(0.05);
      const { curves } = simple.offset(Math.sign(simple.area) * -3, 0.01);
      apart.push(...curves);
    }
  }
  const united = b.combine('union', apart, 0.01);
  const out = b.document();
  out.setPage([0, 0, 120, 80]);
  out.add(b.pathObject(united, { name: 'outline', style: { filled: true, stroked: false } }));
  fs.writeFileSync(to, out.toSvg({ native: false }));
  console.log(`${drawing.count} objects, ${apart.length} outlines, ${united.length} united`);
} catch (error) {
  if (!(error instanceof BattenError)) {
    throw error;
  }
  console.error(`${from}: ${error.message}`);
  process.exitCode = 1;
}
