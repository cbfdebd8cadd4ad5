// Charts as plain SVG.

// The first six are Okabe and Ito's, told apart with every kind of colour vision; more follow for long lists.
const COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00",
                "#7f7f7f", "#b2df8a", "#8c564b", "#9467bd", "#bcbd22", "#f7b6d2",
                "#17becf", "#a6761d", "#e7298a", "#1b4f3a", "#aec7e8", "#ffe14d"];
const colorOf = index => COLORS[index % COLORS.length];

function element(name, attributes, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

const tooltip = text => element("title", {}, text);
const short = value => Number(value.toPrecision(3)).toString();

// Round steps of 1, 2 or 5 times a power of ten that cover [0, most].
function ticks(most) {
  if (!(most > 0)) return [0, 1];
  const raw = most / 5, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(f => f * power).find(s => s >= raw);
  return Array.from({length: Math.ceil(most / step) + 1}, (_, i) => i * step);
}

// An empty chart with axes from 0; x and y map values to its coordinates.
function frame({width = 960, height = 340, left = 70, right = 150, mostX, mostY, labelX, labelY, ticksX}) {
  const svg = element("svg", {viewBox: `0 0 ${width} ${height}`, role: "img"});
  const bottom = height - 42, end = width - right;
  const xs = ticksX || ticks(mostX), ys = ticks(mostY);
  const highX = Math.max(...xs), lowX = ticksX ? Math.min(...xs) : 0, highY = Math.max(...ys);
  const x = value => left + (value - lowX) / (highX - lowX || 1) * (end - left);
  const y = value => bottom - value / highY * (bottom - 12);
  for (const value of xs)
    svg.append(element("text", {x: x(value), y: bottom + 16, "text-anchor": "middle"}, short(value)));
  for (const value of ys) {
    svg.append(element("line", {class: "grid", x1: left, x2: end, y1: y(value), y2: y(value)}),
               element("text", {x: left - 6, y: y(value) + 4, "text-anchor": "end"}, short(value)));
  }
  svg.append(element("line", {class: "axis", x1: left, x2: end, y1: bottom, y2: bottom}),
             element("text", {x: (left + end) / 2, y: height - 6, "text-anchor": "middle"}, labelX),
             element("text", {transform: `translate(14 ${(bottom + 12) / 2}) rotate(-90)`, "text-anchor": "middle"},
                     labelY));
  return {svg, x, y};
}

// A chart with the names of its colours below, in as many lines as they need.
function withLegend(svg, names) {
  const figure = document.createElement("figure"), legend = document.createElement("figcaption");
  names.forEach((name, i) => {
    const item = document.createElement("span"), swatch = document.createElement("i");
    swatch.style.background = colorOf(i);
    item.append(swatch, name);
    legend.append(item);
  });
  figure.append(svg, legend);
  return figure;
}

// points: [{x, y, name, color, text}]; those that no other beats are joined.
function scatter(points, labelX, labelY) {
  const chart = frame({right: 170, mostX: Math.max(...points.map(p => p.x)), mostY: Math.max(...points.map(p => p.y)),
                       labelX, labelY});
  const best = points.filter(p => !points.some(q => q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y)))
                   .sort((a, b) => a.x - b.x);
  chart.svg.append(element("polyline", {class: "front", points: best.map(p => `${chart.x(p.x)},${chart.y(p.y)}`).join(" ")}));
  for (const p of points)
    chart.svg.append(element("circle", {cx: chart.x(p.x), cy: chart.y(p.y), r: 6, fill: colorOf(p.color)}, tooltip(p.text)));
  for (const label of placeLabels(points.map(p => ({x: chart.x(p.x) + 9, y: chart.y(p.y) + 4, text: p.name}))))
    chart.svg.append(element("text", {x: label.x, y: label.y}, label.text));
  return chart.svg;
}

// Moves labels down that would cover one placed before.
function placeLabels(labels) {
  const lineHeight = 13, letterWidth = 6.2, placed = [];
  const covers = (a, b) => Math.abs(a.y - b.y) < lineHeight && a.x < b.x + b.text.length * letterWidth &&
      b.x < a.x + a.text.length * letterWidth;
  for (const label of [...labels].sort((a, b) => a.y - b.y)) {
    while (placed.some(other => covers(label, other))) label.y += 1;
    placed.push(label);
  }
  return placed;
}

// series: [{name, points: [[x, y]]}]
function lines(series, labelX, labelY) {
  const all = series.flatMap(s => s.points);
  const xs = [...new Set(all.map(p => p[0]))].sort((a, b) => a - b);
  const every = Math.ceil(xs.length / 12);
  const chart = frame({height: 280, right: 20, mostY: Math.max(...all.map(p => p[1])), labelX, labelY,
                       ticksX: xs.filter((_, i) => i % every === 0 || i === xs.length - 1)});
  series.forEach((s, i) => {
    const at = s.points.map(([x, y]) => `${chart.x(x)},${chart.y(y)}`).join(" ");
    chart.svg.append(element("polyline", {points: at, fill: "none", stroke: colorOf(i), "stroke-width": 2}));
    for (const [x, y] of s.points)
      chart.svg.append(element("circle", {cx: chart.x(x), cy: chart.y(y), r: 3, fill: colorOf(i)},
                               tooltip(`${s.name}: ${short(y)} at ${short(x)}`)));
  });
  return withLegend(chart.svg, series.map(s => s.name));
}

// rows: [{name, parts: [{name, value, text}]}]
function stackedBars(rows, label) {
  const names = [...new Set(rows.flatMap(r => r.parts.map(p => p.name)))];
  const left = 285, width = 960, end = 940, bar = 26;
  const height = rows.length * (bar + 8) + 56;
  const svg = element("svg", {viewBox: `0 0 ${width} ${height}`, role: "img"});
  const steps = ticks(Math.max(...rows.map(r => r.parts.reduce((sum, p) => sum + p.value, 0))));
  const x = value => left + value / steps[steps.length - 1] * (end - left);
  for (const step of steps)
    svg.append(element("line", {class: "grid", x1: x(step), x2: x(step), y1: 6, y2: height - 42}),
               element("text", {x: x(step), y: height - 26, "text-anchor": "middle"}, short(step)));
  rows.forEach((row, i) => {
    const y = 10 + i * (bar + 8);
    svg.append(element("text", {x: left - 8, y: y + 17, "text-anchor": "end"},
                       row.name.length > 40 ? row.name.slice(0, 39) + "…" : row.name, tooltip(row.name)));
    let from = 0;
    for (const part of row.parts) {
      svg.append(element("rect", {x: x(from), y, width: Math.max(0, x(from + part.value) - x(from) - 1), height: bar,
                                  fill: colorOf(names.indexOf(part.name))}, tooltip(part.text)));
      from += part.value;
    }
  });
  svg.append(element("text", {x: (left + end) / 2, y: height - 6, "text-anchor": "middle"}, label));
  return withLegend(svg, names);
}
