#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a trial without an answer has no reaction time, so its field in jsPsych's CSV is empty, as a missing value is everywhere in CSV.
# Surprise: it is the word "null", in quotation marks: null counts as an object and goes through JSON.stringify, while a value that is
# undefined becomes an empty field. R and pandas read a column of numbers with it as text.
# Package: jspsych 7.3.4 (npm)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
npm install --silent --no-audit --no-fund --prefix "$t" jspsych@7.3.4 jsdom@24.1.3
cat > run.cjs <<'JS'
const { JSDOM } = require("jsdom");
const dom = new JSDOM("<body></body>", { pretendToBeVisual: true });
for (const name of ["window", "document"]) Object.defineProperty(global, name, { value: name === "window" ? dom.window : dom.window.document });
const { initJsPsych } = require("jspsych");
const data = initJsPsych().data;
data.get().push({ participant: "P1", rt: 412.5 });
data.get().push({ participant: "P1", rt: null });
data.get().push({ participant: "P1" });
process.stdout.write(data.get().csv());
process.exit(0);
JS
node run.cjs | tee told
grep -q '"null"' told && grep -q '"P1",""' told
