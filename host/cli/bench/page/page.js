// Fills the page from the results.
const RESULTS = JSON.parse(document.getElementById("results").textContent);
const METRICS = Object.fromEntries(RESULTS.metrics.map(metric => [metric.key, metric]));
// Charts show the distance from the best value, so that less is better in all; where that is infinite, no chart.
const CHARTED = RESULTS.metrics.filter(metric => metric.best !== null).map(metric => metric.key);
const labelOf = key => METRICS[key].best ? `${METRICS[key].best} - ${METRICS[key].label}` : METRICS[key].label;
// Of sweeps over several inputs.
const SWEEP_TITLES = {
  sizes: "sizes (built-in sequence)",
  background: "background (built-in sequence with 0 to 100 % of the rows showing sky)",
};
const byId = id => document.getElementById(id);
const keyOf = run => `${run.input}, ${run.width}x${run.height}`;
const mean = values => values.length ? values.reduce((a, b) => a + b, 0) / values.length : null;
const mainRuns = () => RESULTS.runs.filter(run => !run.sweep && keyOf(run) === byId("input").value);

// A figure of one frame's errors; null where it was not measured.
function figure(frame, key) {
  const value = frame.linear[key] ?? null, {best} = METRICS[key];
  return value !== null && best ? best - value : value;
}

function errorOf(run, metric) {
  if (METRICS[metric].of === "run") return run[metric] ?? null;
  return mean((run.errors || []).map(frame => figure(frame, metric)).filter(value => value !== null));
}

// Which reference the errors of an image metric were measured against.
function referenceText(runs, metric) {
  const frames = METRICS[metric].of === "run" ? [] : runs.flatMap(run => run.errors || []);
  return frames.length ? ` (reference: ${frames[0].linear_reference})` : "";
}

function fill(select, values, names = values) {
  const before = select.value;
  select.replaceChildren(...values.map((value, i) => new Option(names[i], value)));
  if (values.includes(before)) select.value = before;
}

function replace(section, ...nodes) { document.querySelector(section).replaceChildren(...nodes); }

function note(text) {
  const p = document.createElement("p");
  p.textContent = text;
  return p;
}

function paretoOf(runs, metric) {
  const points = runs.map((run, i) => ({
    x: run.frame_ms.median, y: errorOf(run, metric), name: run.run, color: i,
    text: `${run.run}: ${short(run.frame_ms.median)} ms, ${labelOf(metric)} ${errorOf(run, metric)}`,
  })).filter(p => p.y !== null);
  return points.length ? scatter(points, "ms per frame", labelOf(metric) + referenceText(runs, metric)) : note("This sequence has no references.");
}

function showPareto() { replace("#pareto .chart", paretoOf(mainRuns(), byId("metric").value)); }

function stageText(stage, run) {
  const share = stage.skipped_share === undefined ? "" : `, ${Math.round(100 * stage.skipped_share)} % of the tiles skipped`;
  return `${stage.label}: ${short(stage.median_ms)} ms (${short(stage.min_ms)} to ${short(stage.max_ms)}), ` +
      `${short(stage.bytes / 1e6)} MB, ${short(stage.gbs)} GB/s, ${Math.round(100 * stage.copy_share)} % of a copy's ` +
      `bandwidth, at best ${short(stage.bound_ms)} ms${share} (${run.run})`;
}

function stagesOf(runs) {
  return stackedBars(runs.map(run => ({
    name: run.run,
    parts: run.stages.map(stage => ({name: stage.name, value: stage.median_ms, text: stageText(stage, run)})),
  })), "ms");
}

function showStages() {
  const runs = mainRuns();
  replace("#stages .chart", stagesOf(runs));
  showTable(document.querySelector("#stages table"),
            ["stage", "run", "ms", "least", "most", "MB", "GB/s", "of a copy", "at best ms", "flop/B", "skipped"],
            runs.flatMap(run => run.stages.map(stage => [
              stage.label, run.run, cell(stage.median_ms, 3), cell(stage.min_ms, 3), cell(stage.max_ms, 3),
              cell(stage.bytes / 1e6, 3), cell(stage.gbs, 3), percent(stage.copy_share), cell(stage.bound_ms, 3),
              stage.operations && stage.bytes ? cell(stage.operations / stage.bytes, 2) : "-", percent(stage.skipped_share),
            ])));
}

function framesOf(errors, metric) {
  const frames = [...new Set(errors.flatMap(series => series.points.map(point => point[0])))];
  if (frames.length > 1) return lines(errors, "frame", labelOf(metric) + referenceText(mainRuns(), metric));
  return note(frames.length ? `Only frame ${frames[0]} has a reference: its errors are in the first chart.`
                            : "No errors of single frames.");
}

function showFrames() {
  const metric = byId("metric").value, runs = mainRuns();
  const times = runs.filter(run => run.frame_medians_ms.length)
                    .map(run => ({name: run.run, points: run.frame_medians_ms.map((ms, i) => [i, ms])}));
  replace("#frame-times", times.length ? lines(times, "frame", "ms") : note("This device's events carry no times."));
  const errors = METRICS[metric].of === "run" ? [] : runs.map(run => ({
    name: run.run,
    points: (run.errors || []).map(frame => [frame.frame, figure(frame, metric)]).filter(p => p[1] !== null),
  })).filter(s => s.points.length);
  replace("#frame-errors", framesOf(errors, metric));
}

// Settings that take different values within a sweep.
function variedSettings(runs) {
  const settings = [...new Set(runs.flatMap(run => Object.keys(run.assignments)))];
  return settings.filter(setting => new Set(runs.map(run => run.assignments[setting])).size > 2);
}

// Of runs of the sweep `weight`; the newest frame of the longest history has 1 / historyFrames (the sweep sees to it that
// this holds for what is at rest, too).
const WEIGHTS = ["irradianceLeastWeight", "noisyLeastWeight"];
function leastWeight(run) {
  const weight = WEIGHTS.map(setting => run.assignments[setting]).find(value => value !== undefined);
  return weight !== undefined ? Number(weight) : 1 / Number(run.assignments.historyFrames);
}

// The share of a run's frame that is skipped by those of `runs` that skip, on the same frames.
function shareSkipped(run, runs) {
  const shares = runs.filter(other => keyOf(other) === keyOf(run)).flatMap(other => other.stages.map(s => s.skipped_share ?? 0));
  return Math.max(0, ...shares);
}

// The x axis of a sweep: the size, or the values of its longest setting (numbers, or their place in the list); null
// where a sweep only compares a few choices.
function sweepAxis(runs, sweep) {
  if (sweep === "background")
    return {name: "share of the frame that is skipped", of: run => shareSkipped(run, runs), varied: []};
  if (sweep === "weight")
    return {name: "least weight of the newest sample", of: leastWeight, varied: ["historyFrames", ...WEIGHTS]};
  if (sweep === "sizes") return {name: "megapixels", of: run => run.width * run.height / 1e6, varied: []};
  const varied = variedSettings(runs);
  const values = [...new Set(runs.map(run => varied.map(setting => run.assignments[setting]).find(v => v !== undefined)))];
  if (values.length < 4) return null;
  const valueOf = run => varied.map(setting => run.assignments[setting]).find(v => v !== undefined);
  const numeric = values.every(value => value !== undefined && !isNaN(value));
  return {
    name: numeric ? varied.join(", ") : values.map((value, i) => `${i + 1}: ${value}`).join("   "),
    of: run => numeric ? Number(valueOf(run)) : values.indexOf(valueOf(run)) + 1,
    varied,
  };
}

function sweepSeries(runs, axis, value) {
  const series = {};
  for (const run of runs) {
    const others = Object.entries(run.assignments).filter(([setting]) => !axis.varied.includes(setting));
    const name = [run.method, ...others.map(pair => pair.join("="))].join(" ");
    if (value(run) !== null) (series[name] ??= []).push([axis.of(run), value(run)]);
  }
  return Object.entries(series).map(([name, points]) => ({name, points: points.sort((a, b) => a[0] - b[0])}));
}

// Lines over the values of a setting, or one dot for each choice.
function sweepCharts(runs, sweep, metric) {
  const axis = sweepAxis(runs, sweep);
  if (!axis) return runs.some(run => errorOf(run, metric) !== null) ? [paretoOf(runs, metric)] : [stagesOf(runs)];
  const perPixel = sweep === "sizes";
  const time = run => run.frame_ms.median / (perPixel ? axis.of(run) : 1);
  const charts = [lines(sweepSeries(runs, axis, time), axis.name, perPixel ? "ms per megapixel" : "ms per frame")];
  const errors = sweepSeries(runs, axis, run => errorOf(run, metric));
  if (errors.length) charts.push(lines(errors, axis.name, labelOf(metric)));
  return charts;
}

function showSweeps() {
  const nodes = [];
  for (const sweep of [...new Set(RESULTS.runs.map(run => run.sweep).filter(Boolean))]) {
    const runs = RESULTS.runs.filter(run => run.sweep === sweep);
    const title = document.createElement("h3");
    title.textContent = SWEEP_TITLES[sweep] ?? `${sweep} (${keyOf(runs[0])})`;
    nodes.push(title, ...sweepCharts(runs, sweep, byId("metric").value));
  }
  byId("sweeps").hidden = !nodes.length;
  replace("#sweeps .chart", ...nodes);
}

function showTable(table, head, rows) {
  const row = (cells, tag) => {
    const tr = document.createElement("tr");
    for (const cell of cells) tr.append(Object.assign(document.createElement(tag), {textContent: cell}));
    return tr;
  };
  table.replaceChildren(row(head, "th"), ...rows.map(cells => row(cells, "td")));
}

function showSkipped() {
  byId("skipped").hidden = !RESULTS.skipped.length;
  showTable(document.querySelector("#skipped table"), ["run", "sequence", "size", "reason"],
            RESULTS.skipped.map(run => [run.run, run.input, `${run.width}x${run.height}`, run.reason]));
}

const percent = value => value === null || value === undefined ? "-" : `${Math.round(100 * value)} %`;
const cell = (value, digits = 4) => value === null || value === undefined ? "-" : Number(value).toPrecision(digits);

function showRuns() {
  showTable(document.querySelector("#table table"),
            ["run", "sequence", "size", "frame ms", "least", "most", "copies", "MiB", "cold build ms", "cached build ms",
             ...Object.keys(METRICS).map(labelOf)],
            RESULTS.runs.map(run => [
              run.run, run.input, `${run.width}x${run.height}`, cell(run.frame_ms.median), cell(run.frame_ms.min),
              cell(run.frame_ms.max), cell(run.frame_ms.median / RESULTS.copy_ms, 3), (run.memory_bytes / 2 ** 20).toFixed(0),
              cell(run.build_ms?.cold, 3), cell(run.build_ms?.cached, 3),
              ...Object.keys(METRICS).map(metric => cell(errorOf(run, metric))),
            ]));
}

function showModel() {
  const model = RESULTS.model;
  byId("model").hidden = !model.rows.length;
  byId("model-note").textContent = model.note;
  showTable(document.querySelector("#model table"), ["run at 1280x720", ...model.gpus.map(gpu => gpu.name)],
            model.rows.map(row => [row.run, ...row.ms.map((ms, i) => row.published[i] ? `${ms.toFixed(2)} ms\npublished: ${row.published[i].replace("; ", "\n")}`
                                                                                      : `${ms.toFixed(2)} ms`)]));
}

let comparer = null;

function showPictures() {
  const input = byId("input").value.replace(/, \d+x\d+$/, "");
  const pictures = RESULTS.pictures.filter(picture => picture.input === input);
  byId("pictures").hidden = !pictures.length;
  if (!pictures.length) return;
  const names = pictures.map(picture => picture.name);
  const first = byId("left").options.length === 0;
  fill(byId("left"), names);
  fill(byId("right"), names);
  if (first) byId("right").value = names.find(name => name !== "noisy" && name !== "reference") || names[0];
  const url = name => pictures.find(picture => picture.name === name).png;
  comparer ??= new Comparer(byId("comparer"));
  comparer.show(url(byId("left").value), url(byId("right").value), url("reference"), byId("difference").checked);
}

function showFacts() {
  const run = RESULTS.runs[0];
  const rate = RESULTS.fma_gflops ? `, multiply-adds ${RESULTS.fma_gflops.toFixed(1)} GFLOP/s` : "";
  const {version, compiler, assertions} = RESULTS.build;
  byId("facts").textContent = `${run.device}, driver ${run.driver}; Quell ${version}, compiled by ${compiler} ` +
      `${assertions ? "with" : "without"} assertions; ${RESULTS.repeat} rounds after a warm-up; ` +
      `copy bandwidth ${RESULTS.copy_gbs.toFixed(1)} GB/s (one copy: ${RESULTS.copy_ms.toFixed(3)} ms)${rate}`;
}

function showInput() {
  showPareto();
  showStages();
  showFrames();
  showPictures();
}

fill(byId("input"), [...new Set(RESULTS.runs.filter(run => !run.sweep).map(keyOf))]);
fill(byId("metric"), CHARTED, CHARTED.map(labelOf));
byId("metric").value = RESULTS.headline;
byId("input").addEventListener("change", showInput);
byId("metric").addEventListener("change", () => { showPareto(); showFrames(); showSweeps(); });
for (const id of ["left", "right", "difference"]) byId(id).addEventListener("change", showPictures);
showFacts();
showInput();
showSweeps();
showModel();
showRuns();
showSkipped();
