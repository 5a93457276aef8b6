"use strict";

/** What gpf wrote into the page. */
const data = JSON.parse(document.getElementById("data").textContent);

function unpacked(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < bytes.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes;
}

const positions = new Uint16Array(unpacked(data.positions).buffer);
const velocities = unpacked(data.velocities);
const velocityRanges = new Float32Array(unpacked(data.velocity_ranges).buffer);
const profiles = new Float32Array(unpacked(data.profiles).buffer);
const spectra = unpacked(data.spectra);
const densityModes = new Float32Array(unpacked(data.density_modes).buffer);

const timeOf = frame => data.start + frame * data.interval;
const frameAt = time => Math.min(data.frames - 1, Math.max(0, Math.round((time - data.start) / data.interval)));
const timeUnit = data.gravity === 1 ? "√(W/g)" : "W/v";

/** Positions in W and velocities of a frame; x and y, vx and vy by disk. */
function stateOf(frame) {
  const n = data.particles, from = 2 * n * frame;
  const state = {};
  for (const [k, name, period] of [[0, "x", data.length], [1, "y", 1]])
    state[name] = Float64Array.from(positions.subarray(from + k * n, from + (k + 1) * n),
      part => (part + 0.5) / 65536 * period);
  for (const [k, name] of [[0, "vx"], [1, "vy"]]) {
    const [low, high] = velocityRanges.subarray(4 * frame + 2 * k);
    state[name] = Float64Array.from(velocities.subarray(from + k * n, from + (k + 1) * n),
      step => low + step / 255 * (high - low));
  }
  return state;
}

/** Mean of v_x over all disks of a frame. */
function meanFlow(frame) {
  const n = data.particles, [low, high] = velocityRanges.subarray(4 * frame, 4 * frame + 2);
  let steps = 0;
  for (const step of velocities.subarray(2 * n * frame, 2 * n * frame + n)) steps += step;
  return low + steps / n / 255 * (high - low);
}

/** One quantity's profile in a frame - 0: mean velocity, 1: temperature, 2: area fraction; null where no disk is. */
function profileOf(frame, quantity) {
  const bins = data.y.length, from = (3 * frame + quantity) * bins;
  return Array.from(profiles.subarray(from, from + bins), value => Number.isNaN(value) ? null : value);
}
