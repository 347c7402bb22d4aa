// Charts of d3. Usage: charts.mjs ROOM FOLDER COUNT; d3 and jsdom are installed in ROOM/node_modules.
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import vm from "node:vm";

const [room, folder, count] = process.argv.slice(2);
const { JSDOM } = createRequire(path.join(path.resolve(room), "x.js"))("jsdom");
vm.runInThisContext(fs.readFileSync(path.join(room, "node_modules/d3/dist/d3.min.js"), "utf8"));
const d3 = globalThis.d3;
const colour = d3.scaleOrdinal(d3.schemeTableau10);
const x = d3.scaleLinear([0, 30], [30, 290]);
const y = d3.scaleLinear([0, 1], [180, 10]);
const curves = [d3.curveBasis, d3.curveCatmullRom, d3.curveStep, d3.curveMonotoneX];

function axes(svg) {
  svg.append("g").attr("transform", "translate(0,180)").call(d3.axisBottom(x).ticks(6));
  svg.append("g").attr("transform", "translate(30,0)").call(d3.axisLeft(y).ticks(5));
}

function line(svg, rows, i) {
  axes(svg);
  const data = d3.line((d) => x(d[0]), (d) => y(d[1])).curve(curves[i % 4])(rows);
  svg.append("path").attr("fill", "none").attr("stroke", "steelblue").attr("d", data);
}

function area(svg, rows, i) {
  axes(svg);
  const data = d3.area((d) => x(d[0]), y(0), (d) => y(d[1])).curve(curves[i % 4])(rows);
  svg.append("path").attr("fill", colour(i)).attr("fill-opacity", 0.6).attr("d", data);
}

function dots(svg, rows) {
  axes(svg);
  svg.append("g").selectAll("circle").data(rows).join("circle").attr("cx", (d) => x(d[0])).attr("cy", (d) => y(d[1]))
    .attr("r", 3).style("fill", (d) => d3.interpolateViridis(d[1]));
}

function ring(svg, rows) {
  const arc = d3.arc().innerRadius(40).outerRadius(90).padAngle(0.03).cornerRadius(4);
  svg.append("g").attr("transform", "translate(150,100)").selectAll("path").data(d3.pie()(rows.slice(0, 8).map((d) => d[1])))
    .join("path").attr("fill", (d, k) => colour(k)).attr("stroke", "#fff").attr("d", arc);
}

function treemap(svg, rows) {
  const root = d3.hierarchy({ children: rows.map((d) => ({ v: d[1] })) }).sum((d) => d.v);
  const cell = svg.selectAll("g").data(d3.treemap().size([300, 200]).padding(2)(root).leaves()).join("g")
    .attr("transform", (d) => `translate(${d.x0},${d.y0})`);
  const box = (to) => to.append("rect").attr("width", (d) => d.x1 - d.x0).attr("height", (d) => d.y1 - d.y0);
  box(cell.append("clipPath").attr("id", (d, k) => `c${k}`));
  box(cell).attr("fill", (d, k) => colour(k));
  cell.append("text").attr("clip-path", (d, k) => `url(#c${k})`).attr("y", 10).attr("font-size", 8)
    .text((d) => d.value.toFixed(2));
}

function density(svg, rows) {
  const made = d3.contourDensity().x((d) => 9 * d[0]).y((d) => 200 * d[1]).size([300, 200])(rows);
  svg.append("g").attr("fill", "none").attr("stroke", "#333").selectAll("path").data(made).join("path")
    .attr("stroke-linejoin", "round").attr("d", d3.geoPath());
}

function chords(svg, rows, i) {
  const flow = d3.chord().padAngle(0.05)(d3.range(5).map((a) => d3.range(5).map((b) => rows[5 * a + b][1])));
  const g = svg.append("g").attr("transform", "translate(150,100)");
  g.selectAll(".r").data(flow).join("path").style("mix-blend-mode", i % 2 ? "multiply" : null)
    .attr("fill", (d) => colour(d.target.index)).attr("fill-opacity", 0.7).attr("d", d3.ribbon().radius(80));
  g.selectAll(".a").data(flow.groups).join("path").attr("fill", (d) => colour(d.index))
    .attr("d", d3.arc().innerRadius(82).outerRadius(92));
}

const kinds = [line, area, dots, ring, treemap, density, chords];
for (let i = 0; i < +count; i++) {
  const random = d3.randomLcg(i / 100 + 0.003);
  const svg = d3.select(new JSDOM("").window.document.body).append("svg").attr("xmlns", "http://www.w3.org/2000/svg")
    .attr("viewBox", [0, 0, 300, 200]);
  kinds[i % kinds.length](svg, d3.range(31).map((k) => [k, random()]), i);
  fs.writeFileSync(path.join(folder, `${i}.svg`), svg.node().outerHTML);
}
