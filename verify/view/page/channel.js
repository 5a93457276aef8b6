"use strict";

const channel = (() => {
  const canvas = document.getElementById("channel"), pen = canvas.getContext("2d");
  const margin = 4;
  let scale = 1;  // pixels of the screen for a width W

  /** Takes the room that there is; a channel that would be too narrow is scrolled along. */
  function fit() {
    const room = canvas.parentElement.clientWidth - 2 * margin, narrowest = Math.min(120, 16000 / data.length);
    scale = Math.max(narrowest, Math.min(room / data.length, Math.max(260, 0.72 * window.innerHeight)));
    const ratio = window.devicePixelRatio || 1;
    const width = scale * data.length + 2 * margin, height = scale + 2 * margin;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  function drawWalls() {
    pen.fillStyle = data.channel ? "#333" : "#ccc";
    for (const y of [margin - 2, margin + scale]) pen.fillRect(margin, y, scale * data.length, 2);
  }

  /** How far the mean flow has come since the first frame. */
  const drift = (() => {
    const come = [0];
    let before = meanFlow(0);
    for (let frame = 1; frame < data.frames; ++frame) {
      const now = meanFlow(frame);
      come.push(come[frame - 1] + data.interval * (before + now) / 2);
      before = now;
    }
    return come;
  })();

  function draw(frame, colouring, along) {
    const state = stateOf(frame);
    if (along)
      state.x = state.x.map(x => x - drift[frame] - data.length * Math.floor((x - drift[frame]) / data.length));
    const values = shownValues(state, colouring), greatest = greatestShown(colouring);
    const classes = Array.from({length: colourClasses}, () => []);
    for (let i = 0; i < data.particles; ++i)
      classes[Math.min(colourClasses - 1, Math.floor(values[i] / greatest * colourClasses))].push(i);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.save();
    pen.beginPath();
    pen.rect(margin, margin, scale * data.length, scale);
    pen.clip();
    const radius = Math.max(0.6, scale * data.diameter / 2), reach = radius / scale;
    classes.forEach((disks, k) => {
      pen.fillStyle = colouring === "one" ? "#246" : colourTable[k];
      pen.beginPath();
      const add = (x, y) => {
        const across = margin + scale * x, down = margin + scale * (1 - y);
        pen.moveTo(across + radius, down);
        pen.arc(across, down, radius, 0, 2 * Math.PI);
      };
      // A disk that reaches over the end of a period is seen at both ends.
      const images = (r, period) => r < reach ? [r, r + period] : r > period - reach ? [r, r - period] : [r];
      for (const i of disks)
        for (const x of images(state.x[i], data.length))
          for (const y of data.channel ? [state.y[i]] : images(state.y[i], 1)) add(x, y);
      pen.fill();
    });
    pen.restore();
    drawWalls();
  }

  return {fit, draw};
})();
