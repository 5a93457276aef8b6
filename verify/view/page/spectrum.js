"use strict";

const spectrum = (() => {
  const canvas = document.getElementById("spectrum"), pen = canvas.getContext("2d");
  const {most_kx: mostKx, most_ky: mostKy, decades} = data.spectrum;
  const side = 17, left = 26, below = 18, ratio = window.devicePixelRatio || 1;
  const columns = mostKx + 1, rows = 2 * mostKy + 1;
  const width = left + columns * side + 1, height = rows * side + below + 1;
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  pen.scale(ratio, ratio);
  document.getElementById("decades").textContent = decades;

  function draw(frame) {
    pen.clearRect(0, 0, width, height);
    pen.strokeStyle = "#ccc";
    for (let kx = 0; kx <= mostKx; ++kx)
      for (let ky = -mostKy; ky <= mostKy; ++ky) {
        if (kx === 0 && ky === 0) continue;  // the mean
        const grey = 255 - spectra[(frame * columns + kx) * rows + ky + mostKy];
        pen.fillStyle = `rgb(${grey},${grey},${grey})`;
        pen.fillRect(left + kx * side, (mostKy - ky) * side, side, side);
        pen.strokeRect(left + kx * side + .5, (mostKy - ky) * side + .5, side, side);
      }
    pen.fillStyle = "#5d6670";
    pen.font = "11px sans-serif";
    pen.textAlign = "center";
    for (let kx = 0; kx <= mostKx; kx += 2) pen.fillText(kx, left + (kx + .5) * side, height - 5);
    pen.textAlign = "right";
    for (let ky = -mostKy; ky <= mostKy; ky += 2) pen.fillText(ky, left - 6, (mostKy - ky + .5) * side + 4);
  }

  return {draw};
})();
