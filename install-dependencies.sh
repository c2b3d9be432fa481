#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages Detent needs. Does nothing, fast, where they are installed.
#
#   ./install-dependencies.sh [import|build|test|ci] [--list]
#
#   import  build detent-import and detent-graph            (samples/demo.sh)
#   build   build every program and the editor              (default)
#   test    build, and run the tests                        (tests/run.sh)
#   ci      test, and what .ci/run checks besides
#   --list  print the package names instead of installing them
#
# Each word includes the ones above it. Needs root or sudo where something is missing.
# Where the packages come from elsewhere, set DETENT_DEPENDENCIES=given: then nothing is checked or installed.
set -euo pipefail

import_packages=(
  cmake ninja-build g++ pkg-config ccache
  libopencv-dev                    # OpenCVConfig.cmake is only in the whole
  libeigen3-dev libceres-dev
  libmupdf-dev                     # static: its own libraries are not pulled in by the package
  libharfbuzz-dev libfreetype-dev libopenjp2-7-dev libjbig2dec0-dev libmujs-dev libgumbo-dev zlib1g-dev
  librsvg2-dev libcairo2-dev libfontconfig-dev libxml2-dev fonts-liberation  # detent-svg-worker
  libpng-dev libjpeg-dev libtiff-dev libwebp-dev libgif-dev
  libtesseract-dev libleptonica-dev tesseract-ocr-eng tesseract-ocr-deu tesseract-ocr-chi-sim
  nlohmann-json3-dev libcli11-dev
  libzip-dev libpugixml-dev        # spreadsheets
  jq                               # samples/demo.sh reads --json with it
)
build_packages=(
  qt6-base-dev qt6-base-dev-tools qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n libqcustomplot-dev libgl-dev
  portaudio19-dev libjack-jackd2-dev liblo-dev libsndfile1-dev libreaderwriterqueue-dev
  libsqlite3-dev                   # the library of switches
  libusb-1.0-0-dev                 # the Novint Falcon
  pybind11-dev python3-dev         # import detent
  clang-14 lld-14 wasi-libc libc++-14-dev-wasm32 libclang-rt-14-dev-wasm32  # the engine for browsers (detent-play page)
)
test_packages=(
  catch2 librapidcheck-dev libbenchmark-dev
  git python3 python3-numpy python3-scipy python3-jsonschema mypy time
  python3-pandas python3-matplotlib python3-tqdm  # samples/notebooks
  r-base-core                      # docs/guide/r.md
  kotlin openjdk-17-jdk-headless   # an exported Kotlin file is compiled
  snakemake slurm-wlm munge parallel  # samples/cluster
  jackd2 puredata-core
  chromium chromium-driver         # a shared page is opened in it
  umockdev libumockdev-dev         # a Falcon that is none
  arduino-core-avr gcc-avr avr-libc libsimavr-dev  # tests/firmware
  xvfb xauth xdotool openbox imagemagick fonts-dejavu-core
  locales                          # the editor on a German desktop
  gnuplot-nox                      # tests/accuracy draws with it
  valgrind                         # tests/bench: scene, cost, trade
)
ci_packages=(
  clang-14 clang-tidy-14 clang-format-14 libclang-rt-14-dev hyperfine
  lintian debootstrap debhelper    # .ci/nightly package
  fonts-wqy-zenhei                 # samples/plots/draw.sh
)

usage() { sed -n '3,14s/^# \{0,1\}//p' "$0"; }

purpose=build
list=no
for argument in "$@"; do
  case "$argument" in
    import | build | test | ci) purpose=$argument ;;
    --list) list=yes ;;
    -h | --help) usage; exit 0 ;;
    *)
      echo "install-dependencies.sh: '$argument' is not one of import, build, test, ci, --list." >&2
      exit 2
      ;;
  esac
done

packages=("${import_packages[@]}")
[[ $purpose == import ]] || packages+=("${build_packages[@]}")
[[ $purpose == test || $purpose == ci ]] && packages+=("${test_packages[@]}")
[[ $purpose == ci ]] && packages+=("${ci_packages[@]}")

if [[ $list == yes ]]; then
  printf '%s\n' "${packages[@]}"
  exit 0
fi
[[ ${DETENT_DEPENDENCIES:-} == given ]] && exit 0

# Who we are on, before any Debian tool is asked.
system=unknown
if [[ -r /etc/os-release ]]; then
  system=$(. /etc/os-release && echo "${ID:-unknown} ${VERSION_ID:-without a version}")
fi
if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "install-dependencies.sh: this system ($system) has no apt; Detent's packages are known for Debian 12 only." >&2
  echo "Install what './install-dependencies.sh $purpose --list' names, then set DETENT_DEPENDENCIES=given." >&2
  exit 1
fi

missing=()
installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null | sed -n 's/^installed //p' | sort -u || true)
for package in "${packages[@]}"; do
  grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

if [[ $system != "debian 12" ]]; then
  echo "install-dependencies.sh: these packages are missing: ${missing[*]}" >&2
  echo "This system is $system; their names are known for Debian 12 only. Install them by hand, then set DETENT_DEPENDENCIES=given." >&2
  exit 1
fi

root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "install-dependencies.sh: these packages are missing: ${missing[*]}" >&2
    echo "Installing them needs root and there is no sudo. Run './install-dependencies.sh $purpose' as root once." >&2
    exit 1
  fi
  root=(sudo)
fi
# Through env, because sudo drops the variable. DEBIAN_FRONTEND: jackd2 asks a question otherwise.
apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0)

echo "Installing ${#missing[@]} Debian packages for '$purpose': ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
"${apt[@]}" update >"$log" 2>&1 || { cat "$log" >&2; echo "install-dependencies.sh: apt-get update failed; going on with the lists that are here." >&2; }
if ! "${apt[@]}" install --no-install-recommends "${missing[@]}" >"$log" 2>&1 </dev/null; then
  cat "$log" >&2
  echo "install-dependencies.sh: apt-get could not install: ${missing[*]}. Its own words stand above." >&2
  exit 1
fi
echo "Installed."
