// SPDX-License-Identifier: GPL-3.0-or-later
// A participant's station: the trials of a study, one after the other. What is felt and whether it was felt is computed by
// engine and worklet; each answer is a line of the journal (playback/study/trials/participant_record.h), on the disk before
// the next trial is shown.
"use strict";

(() => {
  const byId = (id) => document.getElementById(id);
  const root = document.documentElement;
  const data = JSON.parse(byId("data").textContent);
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stimuli = data.stimuli.map((s) => ({ numbers: new Float64Array(bytes(s.numbers).buffer), settings: s.settings }));
  const stimulusOf = new Map(data.stimuli.map((s, i) => [`${s.mode} ${s.button}`, i]));
  const sound = data.sound && { ...data.sound, samples: new Float32Array(bytes(data.sound.samples).buffer) };
  const now_s = () => performance.now() / 1000;
  const utc_s = () => Date.now() / 1000;

  let words = null;
  const speak = (language) => {
    const known = language === "de" ? "de" : "en";
    root.lang = known;
    words = data.words[known];
  };
  const filled = (text, ...values) => text.replace(/%(\d)/g, (_, n) => values[n - 1]);

  // -- what stands on the page ------------------------------------------------------------------------------------
  const say = (text = "") => { byId("message").textContent = text; };
  const made = (tag, properties, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  const paragraph = (text, properties = {}) => made("p", { ...properties, textContent: text });
  const button = (id, text, action) => made("button", { id, type: "button", textContent: text, onclick: action });
  const row = (...children) => made("div", { className: "row" }, ...children);
  const show = (...children) => { byId("screen").replaceChildren(...children); say(); };

  // -- journal ----------------------------------------------------------------------------------------------------
  let engine = null, database = null;

  function sha256(text) {
    const utf8 = new TextEncoder().encode(text);
    const at = engine.detent_text(utf8.length);
    new Uint8Array(engine.memory.buffer, at, utf8.length).set(utf8);
    const digits = engine.detent_sha256();
    return String.fromCharCode(...new Uint8Array(engine.memory.buffer, digits, 64));
  }

  const chainKey = ",\"chain\":\"";
  const chainOf = (before, body) => sha256(before + body).slice(0, 16);

  const finished = (request) => new Promise((done, failed) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error);
  });

  // Lines of one participant, and what they say. A line counts once the disk has it.
  class Journal {
    constructor(person) {
      Object.assign(this, { person, lines: [], chain: "", answers: [], consent: null, ended: false, damagedAt: 0 });
    }
    keyOf(line) { return [data.sha256, this.person.id, line]; }
    async read() {
      const all = IDBKeyRange.bound(this.keyOf(0), this.keyOf(Infinity));
      for (const line of await finished(database.transaction("lines").objectStore("lines").getAll(all))) this.take(line);
    }
    take(line) {
      const at = line.lastIndexOf(chainKey), body = line.slice(0, at) + "}";
      if (at < 0 || chainOf(this.chain, body) !== line.slice(at + chainKey.length, -2)) {
        this.damagedAt ||= this.lines.length + 1;
        return;
      }
      this.chain = line.slice(at + chainKey.length, -2);
      this.lines.push(line);
      const said = JSON.parse(body);
      if (said.format) this.place = said.place;
      if (said.event === "consent") this.consent = said;
      if (said.event === "session") this.ended = false;
      if (said.event === "end") this.ended = true;
      if (said.event === "answer") this.answers.push(said);
    }
    // All of them, or none. Another window that writes has taken the next key.
    async append(...bodies) {
      let chain = this.chain;
      const lines = bodies.map((body) => {
        chain = chainOf(chain, body);
        return body.slice(0, -1) + chainKey + chain + "\"}";
      });
      const writing = database.transaction("lines", "readwrite", { durability: "strict" });
      lines.forEach((line, i) => writing.objectStore("lines").add(line, this.keyOf(this.lines.length + i)));
      await new Promise((done, failed) => {
        writing.oncomplete = done;
        writing.onabort = () => failed(new Error(writing.error?.name === "ConstraintError" ? words.twoWindows : writing.error?.message || words.notStored));
      });
      lines.forEach((line) => this.take(line));
    }
    text() { return this.lines.map((line) => line + "\n").join(""); }
    complete() { return this.answers.length >= this.person.trials.length; }
  }

  let journal = null;
  const note = (object) => JSON.stringify(object);

  // -- trials -----------------------------------------------------------------------------------------------------
  const scaled = data.kind === "rating" && data.scale !== "pairwise";
  const twoAnswers = data.kind === "same-different";
  const hasX = (data.kind === "abx" || data.kind === "matching") && !data.physical;

  // The next trial; in a threshold study with the difference that follows from the answers.
  function nextTrial() {
    const trial = journal.person.trials[journal.answers.length], choices = [...trial.choices];
    if (data.kind === "threshold") {
      const reference = choices[1 - trial.target], levels = data.levels.filter((l) => l.reference === reference);
      choices[trial.target] = levels[trial.practice ? levels.length - 1 : nextLevel(levels, trial.mode)].button;
    }
    return { ...trial, choices };
  }

  function nextLevel(levels, mode) {
    const values = levels.map((l) => l.increase);
    for (const answer of journal.answers) {
      const level = levels.findIndex((l) => data.labels[l.button] === answer.x);
      if (!answer.practice && answer.mode === mode && level >= 0) values.push(level, answer.correct ? 1 : 0);
    }
    const at = engine.detent_values(values.length);
    new Float64Array(engine.memory.buffer, at, values.length).set(values);
    return engine.detent_next_level(levels.length);
  }

  let session_s = 0, current = null, running = 0, held = null, busy = false, rested = 0;

  // One trial as it is worked on: TrialController of the other stations.
  function begin(trial) {
    const slot = () => ({ tries: 0, presses: 0, whole: 0, peak_N: 0, travel_mm: 0 });
    current = { trial, slots: Array.from({ length: trial.choices.length + 1 }, slot), shown_s: now_s(), firstPress_s: -1 };
    node.port.postMessage({ trial: ++running });
  }
  const isX = (slot) => slot === current.trial.choices.length;
  const buttonIn = (slot) => current.trial.choices[isX(slot) ? current.trial.target : slot];
  const neededSlots = () => {
    const choices = current.trial.choices.map((_, i) => i);
    return hasX ? [choices.length, ...choices] : choices;
  };
  const whole = (slot) => current.slots[slot].whole > 0;

  // What is not felt yet and has to be before an answer: feltEnough() of participant_record.h.
  function missing() {
    const slots = neededSlots(), choices = slots.filter((s) => !isX(s));
    const left = slots.filter((s) => !whole(s));
    return data.kind === "matching" && choices.some(whole) ? left.filter(isX) : left;
  }

  function press(slot) {
    if (busy || held !== null || !current) return;
    held = slot;
    const used = current.slots[slot];
    ++used.tries;
    if (current.firstPress_s < 0) current.firstPress_s = now_s() - current.shown_s;
    node.port.postMessage({ slot, stimulus: stimulusOf.get(`${current.trial.mode} ${buttonIn(slot)}`) });
    padOf(slot)?.toggleAttribute("data-held", true);
  }
  function lift() {
    if (held === null) return;
    padOf(held)?.toggleAttribute("data-held", false);
    held = null;
    node.port.postMessage({ lift: true });
  }
  const padOf = (slot) => document.querySelector(`[data-slot="${slot}"]`);

  function felt({ trial, slot, presses, whole, peak_N, travel_mm }) {
    if (!current || trial !== running) return;
    const used = current.slots[slot];
    used.presses += presses;
    used.whole += whole;
    used.peak_N = Math.max(used.peak_N, peak_N);
    used.travel_mm = Math.max(used.travel_mm, travel_mm);
    if (used.whole > 0) padOf(slot)?.toggleAttribute("data-felt", true);
    if (current.felt) current.felt();
    else allowAnswers();
  }

  function allowAnswers() {
    const may = missing().length === 0;
    document.querySelectorAll("[data-answer]").forEach((b) => { b.disabled = !may; });
  }

  const nameOf = (slot) => (isX(slot) ? "X" : String(slot + 1));

  async function answer(choice, rating) {
    if (busy || !current) return;
    const left = missing();
    if (left.length) return say((scaled ? words.pressIt : words.pressThem) + (scaled ? "" : " " + left.map(nameOf).join(" ")));
    const { trial, slots, shown_s, firstPress_s } = current, answerOf = (i) => (twoAnswers ? ["same", "different"][i] : data.labels[trial.choices[i]]), end_s = now_s();
    const told = ({ presses, whole, peak_N, travel_mm }) => ({ presses, whole, peak_N, travel_mm });
    const line = { event: "answer", trial: trial.number, practice: trial.practice, mode: trial.mode, choices: trial.choices.map((i) => data.labels[i]) };
    if (data.kind !== "rating") line.x = answerOf(trial.target);
    line.answer = answerOf(choice);
    if (data.kind !== "rating") line.correct = choice === trial.target;
    if (rating !== undefined) line.rating = rating;
    Object.assign(line, { replays: slots.slice(0, -1).map((s) => s.tries), replays_x: slots.at(-1).tries, felt: slots.slice(0, -1).map(told), felt_x: told(slots.at(-1)),
                          onset_s: shown_s - session_s, first_press_s: firstPress_s, answer_s: end_s - shown_s });
    busy = true;
    try {
      lift();
      await journal.append(note(line));
      current = null;
      if (journal.complete()) await journal.append(note({ event: "end", reason: "complete" }));
    } catch (error) {
      return say(filled(words.notKept, error.message));
    } finally {
      busy = false;
    }
    goOn();
  }

  function goOn() {
    if (journal.complete()) return showEnd(words.last);
    const trial = nextTrial();
    if (trial.rest_before && rested !== trial.number) {
      rested = trial.number;
      current = null;
      return show(paragraph(words.rest), row(button("rested", words.restOver, goOn)));
    }
    showTrial(trial);
  }

  // -- screens ----------------------------------------------------------------------------------------------------
  function pad(slot, text) {
    const field = button("", text, null);
    field.className = "pad";
    field.dataset.slot = slot;
    field.addEventListener("pointerdown", (e) => {
      if (e.button !== 0) return;
      field.setPointerCapture(e.pointerId);
      press(slot);
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) field.addEventListener(end, lift);
    field.addEventListener("contextmenu", (e) => e.preventDefault());
    return field;
  }

  function showTrial(trial) {
    begin(trial);
    const choices = trial.choices.map((_, i) => i);
    const pads = scaled ? [pad(0, words.pad)] : choices.map((i) => pad(i, nameOf(i)));
    if (hasX) pads.push(pad(choices.length, "X"));
    const given = (i, text, action) => {
      const b = button("", text, action);
      b.dataset.answer = i;
      return b;
    };
    const parts = [paragraph(filled(trial.practice ? words.practice : words.trial, trial.number, journal.person.trials.length), { id: "number" }),
                   paragraph(scaled ? words.spaceScale : words.space), row(...pads)];
    if (data.physical) parts.push(paragraph(filled(words.realSwitch, trial.choices[trial.target] + 1)));
    if (!scaled) parts.push(row(...choices.map((i) => given(i, twoAnswers ? words.sameDifferent[i] : filled(words.comparisons[data.comparison], nameOf(i)), () => answer(i)))));
    if (scaled) parts.push(paragraph(data.scale === "magnitude" ? words.magnitude : words.preference));
    if (scaled && data.scale === "preference") parts.push(row(...[1, 2, 3, 4, 5, 6, 7].map((n) => given(n, String(n), () => answer(0, n)))));
    if (scaled && data.scale === "magnitude") {
      const field = made("input", { id: "magnitude", type: "number", min: 0, max: 1e6, step: "any" });
      const give = () => {
        const value = field.valueAsNumber;
        if (value > 0 && value <= 1e6) answer(0, value);
        else say(words.typeMagnitude);
      };
      field.addEventListener("keydown", (e) => { if (e.key === "Enter") give(); });
      parts.push(row(made("label", {}, words.number, " ", field), given(0, "OK", give)));
    }
    parts.push(row(button("pause", words.pause, showPause), button("stop", words.stop, askStop)));
    show(...parts);
    allowAnswers();
  }

  function showPause() {
    lift();
    current = null;
    show(paragraph(words.paused), row(button("resume", words.resume, goOn), ...handOver()));
  }

  function askStop() {
    lift();
    current = null;
    show(paragraph(words.stopAsked), row(button("stop-yes", words.stopYes, stop), button("resume", words.resume, goOn)));
  }

  async function stop() {
    try {
      await journal.append(note({ event: "end", reason: "stopped by the participant" }));
      showEnd(words.early);
    } catch (error) {
      say(filled(words.notKept, error.message));
    }
  }

  // Ways of the journal to the experimenter.
  const handOver = () => [button("download", words.download, download), ...(data.post ? [button("send", words.send, send)] : [])];

  function download() {
    const url = URL.createObjectURL(new Blob([journal.text()], { type: "application/jsonl" }));
    made("a", { href: url, download: journal.person.id + ".jsonl" }).click();
    setTimeout(() => URL.revokeObjectURL(url), 60000);
  }

  async function send() {
    say(words.sending);
    try {
      const got = await fetch(data.post, { method: "POST", body: journal.text(), headers: { "Content-Type": "text/plain;charset=utf-8" }, credentials: "omit" });
      if (!got.ok) throw new Error(String(got.status));
      say(words.sent);
    } catch (error) {
      say(filled(words.notSent, error.message));
    }
  }

  function showEnd(text) {
    current = null;
    const more = journal.complete() ? [] : [button("resume", words.resume, showCheck)];
    show(paragraph(text, { id: "end" }), ...(data.post ? [] : [paragraph(words.handOver)]), row(...handOver(), ...more));
    if (data.post) send();
  }

  // The sound device is lost: the trial begins anew, and the journal says so.
  async function interrupted(reason) {
    if (!current || current.felt) return;
    const number = current.trial.number;
    lift();
    current = null;
    try {
      await journal.append(note({ event: "interruption", trial: number, reason }));
      show(paragraph(filled(words.interrupted, reason)), row(button("resume", words.resume, async () => { await audio.resume(); goOn(); })));
    } catch (error) {
      show(paragraph(error.message));
    }
  }

  function decline() {
    show(paragraph(words.goodbye, { id: "end" }));
  }

  function showConsent(language) {
    const text = data.consents.find((c) => c.language === language) || data.consents[0];
    speak(text.language);
    const choice = made("select", { id: "language", onchange: (e) => showConsent(e.target.value) },
                        ...data.consents.map((c) => made("option", { value: c.language, textContent: c.language, selected: c === text })));
    show(...(data.consents.length > 1 ? [made("label", {}, words.language, " ", choice)] : []), paragraph(text.text, { id: "consent" }),
         row(button("agree", words.agree, () => showCheck({ event: "consent", decision: "agreed", language: text.language, sha256: text.sha256, utc_s: utc_s() })),
             button("decline", words.decline, decline)));
  }

  // Before the first trial: the finger is there, and something is felt.
  async function showCheck(consent) {
    try {
      await startAudio();
    } catch (error) {
      return say(error.message);
    }
    const trial = { ...journal.person.trials[0], number: 0 };
    begin(trial);
    const yes = button("begin", words.feltIt, () => openSession(consent?.event ? consent : null));
    yes.disabled = true;
    current.felt = () => { yes.disabled = !whole(0); };
    show(paragraph(words.check), ...(data.listening === "masked" ? [paragraph(words.masked)] : []), row(pad(0, words.pad)), row(yes));
  }

  async function openSession(consent) {
    if (busy) return;
    busy = true;
    const route = { sensor: "", sensor_calibration: "", sound: `a browser's output, ${audio.sampleRate} Hz, latency ${audio.baseLatency} s` };
    const begun = { event: "session", kind: "real", listening: data.listening, device: "a browser's output", noise_level: 0, simulation: "", route,
                    program: data.program, utc_s: utc_s(), cut_bytes: 0 };
    const first = journal.lines.length ? [] : [journal.person.header.slice(0, -1) + ",\"route\":" + note(route) + "}"];
    try {
      await journal.append(...first, ...(consent ? [note(consent)] : []), note(begun));
    } catch (error) {
      return say(filled(words.notKept, error.message));
    } finally {
      busy = false;
    }
    session_s = now_s();
    goOn();
  }

  async function showPerson(person) {
    journal = new Journal(person);
    await journal.read();
    byId("title").textContent = person.id;
    // Another place has other trials.
    if (journal.lines.length && journal.place !== JSON.parse(person.header).place) return show(paragraph(filled(words.otherPage, person.id)), row(...handOver()));
    if (journal.damagedAt) return show(paragraph(filled(words.lost, journal.damagedAt)), row(...handOver()));
    if (!journal.consent) return showConsent(root.lang);
    speak(journal.consent.language);
    if (journal.complete()) return showEnd(words.last);
    if (journal.ended) return showEnd(words.early);
    show(paragraph(words.paused), row(button("resume", words.resume, showCheck), ...handOver()));
  }

  function showPeople() {
    const named = data.people.find((p) => p.id === decodeURIComponent(location.hash.slice(1)));
    if (named || data.people.length === 1) return showPerson(named || data.people[0]);
    show(paragraph(words.who), row(...data.people.map((p) => button("", p.id, () => showPerson(p)))));
  }

  // -- keys -------------------------------------------------------------------------------------------------------
  function bindKeys() {
    const slotOf = (e) => {
      if (e.code === "Space" || e.code === "Enter") {
        if (e.target.dataset?.slot !== undefined) return Number(e.target.dataset.slot);
        return e.code === "Space" && e.target.tagName !== "BUTTON" && (scaled || current.felt) ? 0 : -1;
      }
      if (scaled || current.felt) return -1;
      if (e.key.toLowerCase() === "x" && hasX) return current.trial.choices.length;
      return /^[1-9]$/.test(e.key) && Number(e.key) <= current.trial.choices.length ? Number(e.key) - 1 : -1;
    };
    addEventListener("keydown", (e) => {
      if (!current || e.ctrlKey || e.altKey || e.metaKey) return;
      const slot = slotOf(e);
      if (slot >= 0) {
        e.preventDefault();
        if (!e.repeat) press(slot);
        return;
      }
      if (e.repeat || e.target.tagName === "INPUT") return;
      if (scaled && data.scale === "preference" && !current.felt && /^[1-7]$/.test(e.key)) return answer(0, Number(e.key));
      const choice = e.key.length === 1 ? e.key.toLowerCase().charCodeAt(0) - 97 : -1;
      if (!scaled && !current.felt && choice >= 0 && choice < current.trial.choices.length) answer(choice);
    });
    addEventListener("keyup", (e) => {
      if (current && slotOf(e) >= 0) e.preventDefault();
      lift();
    });
    // A finger that cannot be seen any more has let go.
    addEventListener("blur", lift);
    document.addEventListener("visibilitychange", () => { if (document.hidden) lift(); });
  }

  // -- start ------------------------------------------------------------------------------------------------------
  let audio = null, node = null, module = null;

  async function startAudio() {
    if (audio) return audio.resume();
    audio = new AudioContext({ latencyHint: 0 });
    await audio.audioWorklet.addModule("data:text/javascript;charset=utf-8," + encodeURIComponent(byId("worklet").textContent));
    node = new AudioWorkletNode(audio, "detent-station", { numberOfInputs: 0, outputChannelCount: [2], processorOptions: { module, stimuli, sound } });
    node.onprocessorerror = () => { interrupted("sound device lost"); say(words.engineStopped); };
    node.port.onmessage = ({ data: message }) => felt(message);
    node.connect(audio.destination);
    await audio.resume();
    audio.onstatechange = () => { if (audio.state !== "running") interrupted("sound device lost"); };
  }

  async function start() {
    speak(navigator.language.slice(0, 2));
    document.title = data.title;
    byId("title").textContent = data.title;
    module = await WebAssembly.compile(bytes(data.engine));
    engine = detentInstance(module, stimuli);
    const opening = indexedDB.open("detent-study", 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore("lines");
    database = await finished(opening).catch(() => { throw new Error(words.notStored); });
    navigator.storage?.persist?.();
    bindKeys();
    window.detent = {
      journal: () => journal?.text(),
      // What a stimulus plays in a standard press, at 48 kHz.
      render(i) {
        const count = engine.detent_render(i, 48000);
        return new Float32Array(engine.memory.buffer, engine.detent_rendered(), count).slice();
      },
      // What is felt and heard in the second after a stimulus is pressed, at 48 kHz.
      heard(i) {
        engine.detent_start(48000);
        detentSound(engine, sound);
        engine.detent_begin_trial();
        engine.detent_place(0, i);
        engine.detent_press();
        const samples = [[], []];
        for (let block = 0; block < 375; ++block)
          [engine.detent_process(128), engine.detent_heard()].forEach((at, c) => samples[c].push(...new Float32Array(engine.memory.buffer, at, 128)));
        return samples;
      },
    };
    await showPeople();
    root.dataset.detent = "ready";
  }

  start().catch((e) => {
    root.dataset.detent = "failed";
    say(`This browser cannot run the study: ${e.message}. A current Chromium, Firefox or Safari can.`);
  });
})();
