#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: the normal distribution of a statistics package is right to ten digits or more, and probit undoes it.
# Surprise: cumulativeStdNormalProbability looks z up in a printed table: steps of 0.01, four digits, and from 3.09 on always 0.999. One tail
# at z = 4 is 0.001, 32 times too large. probit is another approximation, up to 0.02 off, so that a d' of 4.65 (99 % hits, 1 % false alarms)
# is 4.64, and one of 6.18 (99.9 %) is 6.16. Nothing is told.
# Package: simple-statistics 7.8.3 (npm)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
npm install --silent --no-audit --no-fund --prefix "$t" simple-statistics@7.8.3
cat > run.cjs <<'JS'
const { cumulativeStdNormalProbability: below, probit } = require("simple-statistics");
const right = { 1.96: 0.9750021, 1.964: 0.9752342, 3.5: 0.9997674, 4: 0.9999683 };
for (const z in right) console.log(`below z = ${z}: ${below(+z)}, right is ${right[z]}`);
const dPrime = (p) => probit(p) - probit(1 - p);
console.log(`d' of 0.99 and 0.01: ${dPrime(0.99).toFixed(4)}, right is 4.6527; of 0.999 and 0.001: ${dPrime(0.999).toFixed(4)}, right is 6.1805`);
const same = below(1.96) === below(1.964) && below(4) === 0.999 && below(3.2) === 0.999;
process.exit(same && Math.abs(dPrime(0.99) - 4.6427) < 0.0005 && Math.abs(dPrime(0.999) - 6.1603) < 0.0005 ? 0 : 1);
JS
node run.cjs
