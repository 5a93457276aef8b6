"use strict";

/** Colours are drawn in so many classes, each at one stroke. */
const colourClasses = 48;

const colourTable = Array.from({length: colourClasses}, (_, k) => {
  const place = k / (colourClasses - 1) * (data.palette.length - 1);
  const below = Math.min(Math.floor(place), data.palette.length - 2), part = place - below;
  const mixed = data.palette[below].map((c, i) => Math.round(c + part * (data.palette[below + 1][i] - c)));
  return `rgb(${mixed.join()})`;
});

const meanings = {
  speed: "Colour: speed |v| in the laboratory.",
  fluctuation: "Colour: distance of a disk's velocity from the mean velocity of its bin across the channel.",
  one: ""
};

/** The number that the colour shows, for each disk. */
function shownValues(state, colouring) {
  const n = data.particles, values = new Float64Array(n);
  if (colouring === "one") return values;
  const bins = data.y.length;
  const binOf = i => Math.min(bins - 1, Math.floor(state.y[i] * bins));
  const meanX = new Float64Array(bins), meanY = new Float64Array(bins), number = new Float64Array(bins);
  if (colouring === "fluctuation") {
    for (let i = 0; i < n; ++i) {
      const b = binOf(i);
      meanX[b] += state.vx[i], meanY[b] += state.vy[i], ++number[b];
    }
    for (let b = 0; b < bins; ++b) if (number[b] > 0) meanX[b] /= number[b], meanY[b] /= number[b];
  }
  for (let i = 0; i < n; ++i) {
    const b = binOf(i);
    values[i] = Math.hypot(state.vx[i] - meanX[b], state.vy[i] - meanY[b]);
  }
  return values;
}

/** The greatest value of the scale: 99 of 100 disks in a few frames lie below it. */
const greatestShown = (() => {
  const known = {one: 1};
  return colouring => {
    if (!(colouring in known)) {
      const some = [];
      for (let k = 0; k < 8; ++k)
        some.push(...shownValues(stateOf(Math.floor(k * (data.frames - 1) / 7)), colouring).slice(0, 20000));
      some.sort((a, b) => a - b);
      known[colouring] = some[Math.floor(0.99 * (some.length - 1))] || 1;
    }
    return known[colouring];
  };
})();

function drawLegend(colouring) {
  document.getElementById("legend").style.visibility = colouring === "one" ? "hidden" : "visible";
  document.getElementById("meaning").textContent = meanings[colouring];
  document.getElementById("greatest").textContent = greatestShown(colouring).toPrecision(3);
  const canvas = document.getElementById("scale"), pen = canvas.getContext("2d");
  const step = canvas.width / colourClasses;
  colourTable.forEach((colour, k) => {
    pen.fillStyle = colour;
    pen.fillRect(k * step, 0, step + 1, canvas.height);
  });
}
