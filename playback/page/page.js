// SPDX-License-Identifier: GPL-3.0-or-later
// The page: graph, figures and pad in front of the engine. What is felt is computed by engine and worklet alone.
"use strict";

(() => {
  const byId = (id) => document.getElementById(id);
  const root = document.documentElement;
  const data = JSON.parse(byId("data").textContent);
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const numbers = data.buttons.map((b) => new Float64Array(bytes(b.numbers).buffer));
  const perNewton = { N: 1, gf: 1 / 0.00980665, cN: 100 };
  const decimals = { N: 2, gf: 1, cN: 1 };
  let chosen = 0, unit = "N", held = false, audio = null, node = null, gain = null, engine = null;

  const force = (n) => (n * perNewton[unit]).toFixed(decimals[unit]) + "\u00a0" + unit;
  const say = (text) => { byId("status").textContent = text; };

  // -- graph ------------------------------------------------------------------------------------------------------
  const left = 56, right = 470, top = 10, bottom = 280;
  const svg = (name, attributes, text) => {
    const e = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
    if (text !== undefined) e.textContent = text;
    return e;
  };
  const step = (span) => {
    const rough = span / 5, power = 10 ** Math.floor(Math.log10(rough));
    return power * [1, 2, 5, 10].find((m) => m * power >= rough);
  };
  let scale = null;
  const at = (x_mm, f_N) => [left + (x_mm - scale.x0) / (scale.x1 - scale.x0) * (right - left),
                             bottom - (f_N - scale.f0) / (scale.f1 - scale.f0) * (bottom - top)];
  const path = (points) => points.map((p, i) => (i ? "L" : "M") + at(p[0], p[1]).map((v) => v.toFixed(2)).join(" ")).join("");

  function drawGraph() {
    const graph = byId("graph"), b = data.buttons[chosen];
    graph.replaceChildren();
    const all = b.states.flatMap((s) => [...s.press, ...s.release]);
    const xs = all.map((p) => p[0]), fs = all.map((p) => p[1]);
    scale = { x0: Math.min(0, ...xs), x1: Math.max(...xs), f0: Math.min(0, ...fs), f1: Math.max(...fs) * 1.05 || 1 };
    graph.setAttribute("aria-label", `Force graph of ${b.name}: force in ${unit} over displacement in mm; press and release`);
    const sx = step(scale.x1 - scale.x0), sf = step((scale.f1 - scale.f0) * perNewton[unit]) / perNewton[unit];
    for (let x = Math.ceil(scale.x0 / sx) * sx; x <= scale.x1 * 1.0001; x += sx) {
      const [px] = at(x, scale.f0);
      graph.append(svg("line", { class: "grid", x1: px, x2: px, y1: top, y2: bottom }),
                   svg("text", { x: px, y: bottom + 16, "text-anchor": "middle" }, +x.toPrecision(6)));
    }
    for (let f = Math.ceil(scale.f0 / sf) * sf; f <= scale.f1; f += sf) {
      const [, py] = at(scale.x0, f);
      graph.append(svg("line", { class: "grid", x1: left, x2: right, y1: py, y2: py }),
                   svg("text", { x: left - 6, y: py + 4, "text-anchor": "end" }, +(f * perNewton[unit]).toPrecision(6)));
    }
    graph.append(svg("text", { x: (left + right) / 2, y: bottom + 34, "text-anchor": "middle" }, "Displacement in mm"),
                 svg("text", { x: 11, y: (top + bottom) / 2, "text-anchor": "middle", transform: `rotate(-90 11 ${(top + bottom) / 2})` }, `Force in ${unit}`));
    for (const s of b.states) {
      graph.append(svg("path", { class: "press", d: path(s.press) }));
      if (s.release.length) graph.append(svg("path", { class: "release", d: path(s.release) }));
    }
    graph.append(svg("text", { class: "press", x: right - 8, y: bottom - 28, "text-anchor": "end" }, "press"));
    if (b.states.some((s) => s.release.length)) graph.append(svg("text", { class: "release", x: right - 8, y: bottom - 8, "text-anchor": "end" }, "release"));
    graph.append(svg("circle", { class: "here", id: "here", r: 5, cx: -20, cy: -20 }));
    const speeds = b.speeds_mm_per_s, told = byId("speeds");
    told.hidden = !speeds;
    if (speeds) told.textContent = `Graph and figures at ${+b.drawn_mm_per_s.toPrecision(3)}\u00a0mm/s; pressed, it feels as at the speed of your press, ${+speeds[0].toPrecision(3)} to ${+speeds.at(-1).toPrecision(3)}\u00a0mm/s.`;
  }

  function showPosition(v) {
    const [x_mm, f_N, , , , pressJumps, releaseJumps] = v;
    const [px, py] = at(Math.min(Math.max(x_mm, scale.x0), scale.x1), Math.min(Math.max(f_N, scale.f0), scale.f1));
    byId("here").setAttribute("cx", px);
    byId("here").setAttribute("cy", py);
    byId("reading").textContent = `${x_mm.toFixed(2)} mm, ${force(f_N)}`;
    // A phone's motor knows on and off only: one short buzz stands for each jump.
    if (navigator.vibrate && navigator.userActivation?.hasBeenActive && pressJumps + releaseJumps > showPosition.jumps) navigator.vibrate(12);
    showPosition.jumps = pressJumps + releaseJumps;
  }
  showPosition.jumps = 0;

  // -- figures ----------------------------------------------------------------------------------------------------
  function fillFigures() {
    // Roles are named: a table that is laid out in lines (page.css) stays one for screen readers.
    const cell = (tag, role, text) => {
      const made = Object.assign(document.createElement(tag), { textContent: text });
      made.setAttribute("role", role);
      return made;
    };
    const head = cell("tr", "row", "");
    head.append(cell("td", "cell", ""), ...data.buttons.map((b) => cell("th", "columnheader", b.name)));
    byId("figures").classList.toggle("several", data.buttons.length > 1);
    byId("figures").tHead.replaceChildren(head);
    const told = ({ value, unit: of }) => value === undefined ? "–" : of === "N" ? force(value) : of === "N/mm" ? force(value) + "/mm"
      : of ? value.toFixed(2) + "\u00a0" + of : (100 * value).toFixed(0) + "\u00a0%";
    const rows = data.buttons[0].figures.map((f, i) => data.buttons.map((b) => b.figures[i]));
    byId("figures").tBodies[0].replaceChildren(...rows.filter((row) => row.some((f) => f.value !== undefined)).map((row) => {
      const line = cell("tr", "row", "");
      line.append(cell("th", "rowheader", row[0].name), ...row.map((f, i) => {
        const value = cell("td", "cell", told(f));
        value.dataset.of = `${i + 1} ${data.buttons[i].name}`;
        return value;
      }));
      return line;
    }));
  }

  // -- pressing ---------------------------------------------------------------------------------------------------
  const send = (message) => { if (node) node.port.postMessage(message); };
  const wake = () => { if (audio && audio.state !== "running") audio.resume(); };
  const fullPress_N = () => data.buttons[chosen].fullPress_N;

  function hold(on) {
    held = on;
    byId("pad").toggleAttribute("data-held", on);
  }
  function down() { if (!held) { wake(); hold(true); send({ down: true }); } }
  function up() { if (held) { hold(false); send({ down: false }); } }

  function bindPad() {
    const pad = byId("pad");
    const byForce = (e) => e.pointerType === "pen" || byId("drive").value === "drag";
    const forceOf = (e) => {
      if (e.pointerType === "pen") return e.pressure * fullPress_N();
      const box = pad.getBoundingClientRect();
      return Math.min(Math.max((e.clientY - box.top) / box.height, 0), 1) * fullPress_N();
    };
    pad.addEventListener("pointerdown", (e) => {
      if (e.button !== 0) return;
      pad.setPointerCapture(e.pointerId);
      if (!byForce(e)) return down();
      wake(); hold(true); send({ force_N: forceOf(e) });
    });
    pad.addEventListener("pointermove", (e) => { if (held && byForce(e)) send({ force_N: forceOf(e) }); });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) pad.addEventListener(end, up);
    pad.addEventListener("contextmenu", (e) => e.preventDefault());
    const isKey = (e) => e.code === "Space" || e.code === "Enter";
    const elsewhere = (e) => e.target.closest && e.target.closest("select,input,a,#buttons,#sensor");
    addEventListener("keydown", (e) => {
      if (/^Digit[1-9]$/.test(e.code) && !elsewhere(e) && !e.ctrlKey && !e.altKey && !e.metaKey && +e.key <= data.buttons.length) return choose(+e.key - 1);
      if (!isKey(e) || elsewhere(e)) return;
      e.preventDefault();
      if (!e.repeat) down();
    });
    addEventListener("keyup", (e) => { if (isKey(e) && held) { e.preventDefault(); up(); } });
    // A finger that cannot be seen any more has let go.
    addEventListener("blur", up);
    document.addEventListener("visibilitychange", () => { if (document.hidden) up(); });
  }

  function choose(i) {
    up();
    chosen = i;
    [...byId("buttons").children].forEach((b, k) => { b.setAttribute("aria-checked", k === i); b.tabIndex = k === i ? 0 : -1; });
    byId("pad").setAttribute("aria-label", `Press ${data.buttons[i].name}`);
    send({ use: i });
    drawGraph();
  }

  function listButtons() {
    const list = byId("buttons");
    data.buttons.forEach((b, i) => {
      const e = Object.assign(document.createElement("button"), { type: "button", textContent: `${i + 1}  ${b.name}` });
      e.setAttribute("role", "radio");
      e.addEventListener("click", () => choose(i));
      list.append(e);
    });
    list.addEventListener("keydown", (e) => {
      const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[e.key];
      if (!by) return;
      e.preventDefault();
      choose((chosen + by + data.buttons.length) % data.buttons.length);
      list.children[chosen].focus();
    });
    list.hidden = data.buttons.length < 2;
  }

  // -- force sensor (docs/reference/serial-protocol.md) ----------------------------------------------------------------------
  const sensor = { coefficients: null, circuit: "newtons", fullScale: 1023, recent: [], rest: null };
  const steadyFor_ms = 400, fewestReadings = 5, steadyWithin = 0.05;  // the last: of full scale

  function readProfile(text) {
    const value = {};
    for (const line of text.split(/\r?\n/)) {
      const m = /^\s*([a-zA-Z_.]+)\s*=\s*(.*?)\s*$/.exec(line.replace(/#.*/, ""));
      if (m) value[m[1]] = m[2];
    }
    if (!/^detent-device 1\s*$/.test(text.split(/\r?\n/)[0])) throw new Error("its first line is not “detent-device 1”");
    if (!value["sensor.coefficients"]) throw new Error("it holds no sensor.coefficients: calibrate the sensor first (detent-play calibrate)");
    const coefficients = value["sensor.coefficients"].split(/\s+/).map(Number);
    if (!coefficients.every(Number.isFinite)) throw new Error("its sensor.coefficients are not numbers");
    Object.assign(sensor, { coefficients, circuit: value["sensor.circuit"] || "linear", fullScale: Number(value["sensor.full_scale_counts"] || 1023) });
  }

  // Newtons of one line, or null: wrong checksum, comment, counts without a profile.
  function newtonsOf(line) {
    let body = line.trim();
    const star = body.lastIndexOf("*");
    if (star >= 0) {
      let sum = 0;
      for (const c of body.slice(0, star)) sum ^= c.charCodeAt(0);
      if (parseInt(body.slice(star + 1), 16) !== sum) return null;
      body = body.slice(0, star);
    }
    const m = /^(?:\d+,)?([-+]?\d+(?:\.\d+)?)(N?)$/.exec(body);
    if (!m) return null;
    const value = Number(m[1]);
    if (m[2]) return value;
    const now_ms = performance.now();
    sensor.recent.push({ value, at_ms: now_ms });
    while (sensor.recent[0].at_ms < now_ms - steadyFor_ms) sensor.recent.shift();
    if (!sensor.coefficients) return null;
    const u = sensor.circuit === "divider" ? value / (sensor.fullScale - value) : sensor.circuit === "linear" ? value / sensor.fullScale : value;
    return sensor.coefficients.reduceRight((sum, c) => sum * u + c, 0);
  }

  async function readSensor(port) {
    const reader = port.readable.pipeThrough(new TextDecoderStream()).getReader();
    let rest = "";
    for (;;) {
      const { value, done } = await reader.read();
      if (done) throw new Error("the port was closed");
      const lines = (rest + value).split("\n");
      rest = lines.pop().slice(-96);
      for (const line of lines) {
        const n = newtonsOf(line);
        if (n !== null && n > -2 && n < 30) send({ force_N: n });
      }
    }
  }

  // One known weight: counts at rest and under it make a straight line. In two steps, so that readings go on in between.
  // Counts of the last readings, or null where they are few or still move: then it is said. A weight that is just being put down, and a
  // slow link whose readings come late, would else be mixed with what lay there before.
  function steadyCounts() {
    const counts = sensor.recent.filter((r) => r.at_ms >= performance.now() - steadyFor_ms).map((r) => r.value);
    if (counts.length < fewestReadings) {
      say(`Not calibrated: ${counts.length ? "too few" : "no"} counts have come. A sensor that sends newtons needs no calibration; else check its cable.`);
      return null;
    }
    const mean = (values) => values.reduce((sum, c) => sum + c, 0) / values.length;
    const middle = counts.length >> 1, all = mean(counts);
    const spread = Math.sqrt(mean(counts.map((c) => (c - all) ** 2)) / middle);
    const moved = Math.abs(mean(counts.slice(0, middle)) - mean(counts.slice(middle)));
    if (moved <= 1 + 2 * spread && Math.max(...counts) - Math.min(...counts) <= steadyWithin * sensor.fullScale) return all;
    say("Not calibrated: the reading still moves. Leave the sensor alone for a moment and try again.");
    return null;
  }

  function takeRest() {
    const rest = steadyCounts();
    if (rest === null) return;
    sensor.rest = rest;
    byId("weight-row").hidden = false;
    byId("weight").focus();
    say("Put a known weight on the sensor, type its mass and take it.");
  }

  function takeWeight() {
    const grams = Number(byId("weight").value), loaded = steadyCounts();
    if (loaded === null) return;
    if (!(grams > 0) || Math.abs(loaded - sensor.rest) < 1)
      return say("Not calibrated: it needs a weight above 0 g and a reading that changes with it.");
    const u = (c) => c / sensor.fullScale, slope = grams * 0.00980665 / (u(loaded) - u(sensor.rest));
    Object.assign(sensor, { circuit: "linear", coefficients: [-slope * u(sensor.rest), slope] });
    byId("weight-row").hidden = true;
    say("Calibrated with one weight: a straight line, rougher than detent-play calibrate.");
  }

  function bindSensor() {
    if (!navigator.serial) return;
    byId("sensor").hidden = false;
    byId("connect").addEventListener("click", async () => {
      try {
        const port = await navigator.serial.requestPort();
        await port.open({ baudRate: 230400 });
        wake();
        sensor.recent.length = 0;
        byId("calibrate").hidden = false;
        say(sensor.coefficients ? "Sensor connected." : "Sensor connected. If it sends counts, choose a device profile or calibrate.");
        await readSensor(port);
      } catch (e) {
        send({ force_N: 0 });
        say(`Force sensor: ${e.message}. Check the cable and connect it again.`);
      }
    });
    byId("calibrate").addEventListener("click", takeRest);
    byId("weigh").addEventListener("click", takeWeight);
    byId("weight").addEventListener("keydown", (e) => { if (e.key === "Enter") takeWeight(); });
    byId("profile").addEventListener("change", async (e) => {
      try { readProfile(await e.target.files[0].text()); say("Device profile read."); }
      catch (error) { say(`Device profile: ${error.message}.`); }
    });
  }

  // -- start ------------------------------------------------------------------------------------------------------
  async function startAudio(module) {
    // 0: the least the browser can do; "interactive" is several times as long in Chromium.
    audio = new AudioContext({ latencyHint: 0 });
    const source = byId("worklet").textContent;
    // As a data URL: a page opened from the disk may not load a blob into a worklet.
    await audio.audioWorklet.addModule("data:text/javascript;charset=utf-8," + encodeURIComponent(source));
    node = new AudioWorkletNode(audio, "detent", { numberOfInputs: 0, outputChannelCount: [2], processorOptions: { module, buttons: numbers } });
    node.onprocessorerror = () => say("The engine stopped. Load the page again.");
    node.port.onmessage = ({ data: shown }) => showPosition(shown);
    gain = new GainNode(audio);
    node.connect(gain).connect(audio.destination);
    byId("volume").addEventListener("input", (e) => gain.gain.setTargetAtTime(+e.target.value, audio.currentTime, 0.01));
  }

  async function start() {
    document.title = data.title;
    byId("title").textContent = data.title;
    listButtons();
    byId("unit").addEventListener("change", (e) => { unit = e.target.value; drawGraph(); fillFigures(); });
    fillFigures();
    const module = await WebAssembly.compile(bytes(data.engine));
    engine = detentInstance(module, numbers);
    window.detent = {
      buttons: data.buttons.map((b) => b.name),
      // At 48 kHz as `detent-play render` has it; at the context's own rate what the pad plays.
      async render(i, rate = 48000) {
        const count = engine.detent_render(i, rate);
        if (count < 0) throw new RangeError(`there is no button ${i}`);
        return new Float32Array(engine.memory.buffer, engine.detent_rendered(), count).slice();
      },
    };
    choose(0);
    bindPad();
    await startAudio(module);
    bindSensor();
    if (navigator.vibrate) say("Phones add one short, coarse buzz for each jump.");
    byId("pad").disabled = false;
    root.dataset.detent = "ready";
    performance.mark("detent-ready");
  }

  start().catch((e) => {
    root.dataset.detent = "failed";
    say(`This browser cannot play the page: ${e.message}. A current Chromium, Firefox or Safari can.`);
  });
})();
