"use strict";

(() => {
  const element = id => document.getElementById(id);
  const speeds = [5, 10, 20, 30, 60];
  let frame = 0, playing = false, before = 0, due = 0;
  for (const speed of speeds) element("speed").add(new Option(`${speed} frames/s`, speed, speed === 30, speed === 30));
  element("frame").max = data.frames - 1;
  document.querySelector("main").classList.toggle("long", data.length > 2.2);

  function show(wanted) {
    frame = Math.min(data.frames - 1, Math.max(0, wanted));
    channel.draw(frame, element("colouring").value, element("along").checked);
    spectrum.draw(frame);
    for (const plot of plots) plot(frame);
    element("frame").value = frame;
    element("time").textContent = `t = ${timeOf(frame).toFixed(3)} ${timeUnit}, frame ${frame + 1} of ${data.frames}`;
    document.documentElement.dataset.frame = frame;
  }

  function seek(wanted) {
    due = 0;
    show(wanted);
  }

  function play(on) {
    if (on && frame === data.frames - 1) seek(0);
    playing = on;
    element("play").textContent = on ? "Pause" : "Play";
    if (on) requestAnimationFrame(now => {
      before = now;
      requestAnimationFrame(advance);
    });
  }

  function advance(now) {
    if (!playing) return;
    due += (now - before) / 1000 * element("speed").value;
    before = now;
    const steps = Math.floor(due);
    due -= steps;
    if (steps > 0) show(frame + steps);
    if (frame === data.frames - 1) play(false);
    else requestAnimationFrame(advance);
  }

  function changeSpeed(step) {
    const k = element("speed").selectedIndex + step;
    if (k >= 0 && k < speeds.length) element("speed").selectedIndex = k;
  }

  const keys = {
    " ": () => play(!playing),
    ArrowRight: shift => seek(frame + (shift ? 10 : 1)),
    ArrowLeft: shift => seek(frame - (shift ? 10 : 1)),
    ArrowUp: () => changeSpeed(1),
    ArrowDown: () => changeSpeed(-1),
    Home: () => seek(0),
    End: () => seek(data.frames - 1)
  };

  const plots = addPlots(seek);
  element("play").addEventListener("click", () => play(!playing));
  element("frame").addEventListener("input", event => seek(Number(event.target.value)));
  element("colouring").addEventListener("change", event => {
    drawLegend(event.target.value);
    show(frame);
  });
  element("along").addEventListener("change", () => show(frame));
  document.addEventListener("keydown", event => {
    if (!(event.key in keys) || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.target.closest?.("select, summary, button, [type=checkbox]") && !event.key.startsWith("ArrowL") &&
      !event.key.startsWith("ArrowR")) return;
    event.preventDefault();
    keys[event.key](event.shiftKey);
  });
  new ResizeObserver(() => {
    channel.fit();
    show(frame);
  }).observe(element("flow"));
  drawLegend("speed");
  channel.fit();
  show(0);
})();
