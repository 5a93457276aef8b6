"use strict";

const ink = {now: "#c2410c", mean: "#21638f", band: "rgba(33, 99, 143, .16)", quiet: "#5d6670", third: "#3f7d3a"};

/** A plot of uPlot's under a heading, as wide as its place. series: [{label, colour, dashed, points, ...}]. */
function addPlot({heading, xlabel, series, bands = [], scales = {}, values, wholeNumbers = false, height = 185}) {
  const place = document.createElement("div");
  place.className = "plot";
  const title = place.appendChild(document.createElement("h2"));
  title.textContent = heading;
  const legend = place.appendChild(document.createElement("p"));
  legend.className = "legend";
  for (const s of series.filter(s => s.label)) {
    const entry = legend.appendChild(document.createElement("span"));
    entry.textContent = s.label;
    entry.style.setProperty("--colour", s.colour);
    entry.classList.toggle("dashed", Boolean(s.dashed));
  }
  document.getElementById("plots").appendChild(place);
  const axis = {stroke: ink.quiet, grid: {stroke: "#eceef1", width: 1}, ticks: {stroke: "#d9dde2", width: 1, size: 5}};
  const plot = new uPlot({
    width: place.clientWidth, height,
    legend: {show: false},
    cursor: {y: false, points: {show: false}},
    scales: {x: {time: false}, ...scales},
    axes: [{...axis, ...(wholeNumbers ? {incrs: [1, 2, 5, 10, 20, 50, 100]} : {}), label: xlabel, labelSize: 18, size: 34, labelFont: "12px sans-serif", font: "12px sans-serif"},
      {...axis, size: 58, space: 24, font: "12px sans-serif"}],
    series: [{}, ...series.map(s => ({
      stroke: s.colour, width: s.width ?? 2, dash: s.dashed ? [6, 4] : undefined, spanGaps: s.spanGaps ?? false,
      points: {show: Boolean(s.points), size: 6, fill: s.colour}
    }))],
    bands
  }, values, place);
  new ResizeObserver(() => plot.setSize({width: place.clientWidth, height})).observe(place);
  return plot;
}

/** A range that holds all the values, and zero if `zero`. */
function rangeOf(values, zero) {
  const numbers = values.filter(v => Number.isFinite(v));
  let low = zero ? 0 : Infinity, high = zero ? 0 : -Infinity;
  for (const v of numbers) low = Math.min(low, v), high = Math.max(high, v);
  if (!(high > low)) return [low - 1, low + 1];
  const room = 0.05 * (high - low);
  return [zero && low === 0 ? 0 : low - room, high + room];
}

/** A profile across the channel: of the shown frame, and of the record (or of all frames). */
function addProfile(quantity, heading, name) {
  const bins = data.y.length, of = frame => profileOf(frame, quantity);
  const measured = data.record && data.record[name];
  const plus = sign => measured.mean.map((m, b) => m === null ? null : m + sign * (measured.error[b] ?? 0));
  const mean = measured ? measured.mean : data.y.map((_, b) => {
    const there = Array.from({length: data.frames}, (_, f) => of(f)[b]).filter(v => v !== null);
    return there.length > 0 ? there.reduce((a, b) => a + b) / there.length : null;
  });
  const edges = measured ? [plus(-1), plus(+1)] : [];
  const some = Array.from({length: Math.min(data.frames, 40)}, (_, k) =>
    of(Math.floor(k * (data.frames - 1) / 39))).flat();
  const range = rangeOf([...some, ...mean, ...edges.flat()], true);
  const plot = addPlot({
    heading, xlabel: "y/W",
    scales: {x: {time: false, range: [0, 1]}, y: {range}},
    series: [
      {label: measured ? "record: mean ± standard error" : "mean of all frames", colour: ink.mean, dashed: !measured},
      {label: "shown frame", colour: ink.now, points: bins <= 40},
      ...edges.map(() => ({colour: "transparent", width: 0}))
    ],
    bands: measured ? [{series: [4, 3], fill: ink.band}] : [],
    values: [data.y, mean, of(0), ...edges]
  });
  return frame => plot.setData([data.y, mean, of(frame), ...edges], false);
}

/** The energy of the run and of the frames, with a cursor at the shown time; seek(frame) when it is clicked. */
function addEnergy(seek) {
  const frameTimes = Array.from({length: data.frames}, (_, f) => timeOf(f));
  const history = data.record ? data.record.history : {time: [], energy: [], temperature: []};
  const joined = uPlot.join([[frameTimes, data.energy, data.temperature],
    [history.time, history.energy, history.temperature]]);
  const plot = addPlot({
    heading: "Kinetic energy and its random part, per disk", xlabel: `time, ${timeUnit}`,
    series: [
      {label: "energy of the frames", colour: ink.now, spanGaps: true},
      {label: "its random part", colour: ink.third, spanGaps: true},
      ...(data.record ? [{label: "energy in the record", colour: ink.mean, width: 1.5, spanGaps: true},
        {label: "its random part", colour: ink.quiet, width: 1.5, spanGaps: true}] : [])
    ],
    scales: {y: {distr: 3}},
    values: joined.slice(0, data.record ? 5 : 3)
  });
  const marker = plot.over.appendChild(document.createElement("div"));
  marker.className = "now";
  let shown = 0;
  const place = () => {
    const left = plot.valToPos(timeOf(shown), "x");
    marker.style.left = `${left}px`;
    marker.style.display = left >= 0 && left <= plot.over.clientWidth ? "block" : "none";
  };
  plot.hooks.draw = [place];
  if (data.record) {
    // The frames, and as much again before them: in the whole run they are short.
    const [first, last] = [timeOf(0), timeOf(data.frames - 1)];
    const all = [Math.min(first, history.time[0] ?? first), Math.max(last, history.time.at(-1) ?? last)];
    const whole = document.createElement("input");
    whole.type = "checkbox";
    const label = plot.root.parentElement.querySelector(".legend").appendChild(document.createElement("label"));
    label.append(whole, " whole run");
    const zoom = () => plot.setScale("x", whole.checked ? {min: all[0], max: all[1]}
      : {min: Math.max(all[0], 2 * first - last), max: last});
    whole.addEventListener("change", zoom);
    if (data.frames > 1) zoom();
  }
  plot.over.addEventListener("click", () => {
    if (plot.cursor.left >= 0 && plot.select.width === 0) seek(frameAt(plot.posToVal(plot.cursor.left, "x")));
  });
  return frame => {
    shown = frame;
    place();
  };
}

/** Power of the density modes along the channel over their noise, by parity. */
function addModes() {
  const names = ["even (slugs)", "odd (waves)", "varicose"], colours = [ink.mean, ink.now, ink.third];
  const k = Array.from({length: data.modes}, (_, i) => i + 1);
  const least = 1e-3;
  const positive = values => values.map(v => v > least ? v : least);
  const of = frame => names.map((_, s) => {
    const from = (3 * frame + s) * data.modes;
    return positive(Array.from(densityModes.subarray(from, from + data.modes)));
  });
  const means = data.record && data.record.density_modes ? data.record.density_modes.map(positive) : [];
  let most = 10;
  for (const v of densityModes) most = Math.max(most, v);
  const sorted = Float32Array.from(densityModes).sort();
  const low = Math.max(least, Math.min(0.1, sorted[Math.floor(0.05 * sorted.length)]));
  const plot = addPlot({
    heading: "Density modes: power / noise", xlabel: "wavenumber k along the channel",
    scales: {x: {time: false, range: [0.5, data.modes + 0.5]}, y: {distr: 3, range: [low, 2 * most]}},
    series: [...names.map((label, s) => ({label, colour: colours[s], points: true})),
      ...means.map((_, s) => ({label: s === 0 ? "means of the record" : "", colour: colours[s], dashed: true, width: 1.5}))],
    wholeNumbers: true,
    values: [k, ...of(0), ...means]
  });
  return frame => plot.setData([k, ...of(frame), ...means], false);
}

/** All plots; each is a function that shows a frame. */
function addPlots(seek) {
  const plots = [
    addProfile(0, "Mean velocity U", "mean_velocity"),
    addProfile(1, "Granular temperature T", "granular_temperature"),
    addProfile(2, "Area fraction", "area_fraction"),
    addEnergy(seek)
  ];
  if (data.modes > 0) plots.push(addModes());
  return plots;
}
