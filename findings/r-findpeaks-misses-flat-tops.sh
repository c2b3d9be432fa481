#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: findpeaks of R's pracma finds the maxima of a curve; a maximum of two equal samples is found at one of them, as MATLAB's function
# of that name does.
# Surprise: by default a peak has to fall in the very next sample. Force testers resolve 0.01 N, so the top of a tactile switch is nearly
# always two or more equal samples: the whole curve has no peak (NULL), or the highest one found is a lower one of noise. No word; one unit
# of the last digit more or less at the top, and the peak is there. findpeaks(..., zero = "+") finds it.
# Package: r-cran-pracma 2.4.2-1 (Debian 12; r-base-core has to be installed)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq r-cran-pracma=2.4.2-1 2>/dev/null
dpkg -x r-cran-pracma_*.deb root
LC_ALL=C R_LIBS="$t/root/usr/lib/R/site-library" /usr/bin/R --vanilla --slave -e '
highest <- function(...) { found <- pracma::findpeaks(...); if (is.null(found)) "none" else format(max(found[, 1]), nsmall = 2) }
smooth <- 0.6 * exp(-((seq(0, 2, 0.02) - 1) / 0.4)^2)  # N: one tactile peak
tester <- round(smooth, 2)                             # as a tester with 0.01 N writes it
noisy <- tester; noisy[30] <- noisy[30] + 0.03         # one sample beside, on the way up
said <- c(smooth = highest(smooth), tester = highest(tester), noisy = highest(noisy), plus = highest(tester, zero = "+"))
cat("equal samples at the top:", sum(tester == max(tester)), "\n")
cat("highest peak in the exact curve:", said["smooth"], "N; in steps of 0.01 N:", said["tester"])
cat("; with one sample beside:", said["noisy"], "N; with zero = \"+\":", said["plus"], "N\n")
right <- said["smooth"] == "0.60" && said["tester"] == "none" && said["plus"] == "0.60" && as.numeric(said["noisy"]) < 0.5
quit(status = as.integer(!right))'
