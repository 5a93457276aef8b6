"use strict";

// Texts of a record are shown as they are, never as HTML: textContent only.
for (const {heading, rows} of data.tables) {
  const part = document.getElementById("tables").appendChild(document.createElement("div"));
  part.appendChild(document.createElement("h3")).textContent = heading;
  const table = part.appendChild(document.createElement("table"));
  for (const cells of rows) {
    const row = table.insertRow();
    for (const text of cells) row.insertCell().textContent = text;
  }
}
document.getElementById("summary").textContent = `${data.particles} disks, L/W = ${data.length.toPrecision(4)}, W/d = ` +
  `${(1 / data.diameter).toPrecision(4)}; ${data.frames} frames ${data.interval.toPrecision(3)} ${timeUnit} apart` +
  (data.gravity > 0 ? "; gravity to the right" : "");
