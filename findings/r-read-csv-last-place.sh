#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: R reads a decimal number of 17 digits as the nearest double, as strtod of C does; then tables written with enough digits come back
# to the last bit.
# Surprise: R has a strtod of its own that multiplies and divides long doubles. Of 200000 random numbers written so that they read back (17
# digits), 16 come out one unit in the last place beside. No option of read.csv changes it.
# Package: r-base-core 4.2.2.20221110-2 (Debian 12; its dependencies have to be installed)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq r-base-core=4.2.2.20221110-2 2>/dev/null
dpkg -x r-base-core_*.deb root
python3 - <<'PY'
import random
random.seed(1)
numbers = [random.uniform(0, 10) * 10 ** random.randint(-6, 6) for _ in range(200000)]
open("table.csv", "w").write("text,bits\n" + "".join(f"{n!r},{n.hex()}\n" for n in numbers))
PY
sed -e "s|^R_HOME_DIR=.*|R_HOME_DIR=$t/root/usr/lib/R|" root/usr/lib/R/bin/R > run-R
ln -s /etc/R root/usr/lib/R/etc-system 2>/dev/null || true
LC_ALL=C sh run-R --vanilla --slave -e '
t <- read.csv("table.csv", colClasses = c("numeric", "character"))
exact <- as.numeric(t$bits)  # hexadecimal: no rounding
wrong <- which(t$text != exact)
cat(length(wrong), "of", nrow(t), "numbers differ from what was written; the largest by", max(abs(t$text - exact)[wrong] / (2^-52 * exact[wrong])), "of the last place\n")
quit(status = as.integer(length(wrong) == 0))'
