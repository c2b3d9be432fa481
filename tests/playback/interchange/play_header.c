/* SPDX-License-Identifier: GPL-3.0-or-later
 * play_header: a board that follows a header of `detent-play export --format c` and nothing else, written from the words in that
 * header and on docs/reference/export-formats.md. Compiled with -include button.h.
 *
 * stdin: the force of each sample in N, as text. stdout: a line "event SAMPLE KIND" per onset (press_jump, release_jump,
 * bottom_out, grain), then "samples" and what sounds at each sample, 48000 a second. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define RATE 48000.0
#define MOST 32

typedef struct {
  const detent_wave* wave;
  double level;
  long begun;
  int jump;
} Sounding;

static Sounding bursts[MOST];
static Sounding grain;
static long carrierBegun, lastGrain = -1, now;
static long earliest = -1000000, jumpEnds = -1000000;
static int ready[80];
static long waiting[80];
static const detent_trigger* waits[80];

static double envelope(const detent_wave* w, double ms) {
  if (ms >= w->duration_ms) return 0;
  if (ms < w->rise_ms) return ms / w->rise_ms;
  if (ms > w->duration_ms - w->fall_ms) return (w->duration_ms - ms) / w->fall_ms;
  return 1;
}

static double wave(const detent_wave* w, long since, long carrierSince) {
  return w->amplitude * envelope(w, 1000.0 * (double)since / RATE) *
         sin(2 * 3.14159265358979323846 * w->frequency_Hz * (double)carrierSince / RATE);
}

static int sounds(const Sounding* s) {
  return s->wave && 1000.0 * (double)(now - s->begun) / RATE < s->wave->duration_ms;
}

static void begin(const detent_trigger* t) {
  int i, to = 0;
  for (i = 0; i < MOST; ++i)
    if (!sounds(&bursts[i])) to = i;
  bursts[to].wave = &t->wave;
  bursts[to].level = 1;
  bursts[to].begun = now;
  bursts[to].jump = !t->kind;
  printf("event %ld %s\n", now, t->kind ? "bottom_out" : t->release ? "release_jump" : "press_jump");
}

static void beginGrain(float level) {
  int i;
  double least = 1000.0 / detent_grain.duration_ms, perSecond = least;
  Sounding next;
  next.level = level;
  next.jump = 0;
  if (detent_loudest_grains_per_s > 0) {
    if (lastGrain >= 0)
      perSecond = now > lastGrain ? RATE / (double)(now - lastGrain) : detent_loudest_grains_per_s;
    perSecond = fmin(fmax(perSecond, least), detent_loudest_grains_per_s);
    next.level *= pow(perSecond / detent_loudest_grains_per_s, detent_grain_level_power);
  }
  for (i = 0; i < MOST; ++i)
    if (sounds(&bursts[i]) && bursts[i].jump) {
      next.level *= detent_slope_under_jump;
      break;
    }
  if (!sounds(&grain)) carrierBegun = now;
  next.wave = &detent_grain;
  next.begun = now;
  grain = next;
  lastGrain = now;
  printf("event %ld grain\n", now);
}

/* Displacement of one stroke at a force: the shallowest place that bears it on a press, the deepest that no longer pushes back on
   a release; never behind `from`. */
static double place(const float* x, const float* f, unsigned n, double force, double from, int releasing) {
  unsigned k;
  if (!releasing) {
    for (k = 0; k + 1 < n; ++k)
      if (x[k + 1] >= from && f[k + 1] >= force) {
        double p = f[k] >= force ? x[k] : x[k] + (x[k + 1] - x[k]) * (force - f[k]) / (f[k + 1] - f[k]);
        if (p < from) p = from;
        if (p <= x[k + 1]) return p;
      }
    return x[n - 1];
  }
  for (k = n - 1; k > 0; --k)
    if (x[k - 1] <= from && f[k - 1] <= force) {
      double p = f[k] <= force ? x[k] : x[k - 1] + (x[k] - x[k - 1]) * (force - f[k - 1]) / (f[k] - f[k - 1]);
      if (p > from) p = from;
      if (p >= x[k - 1]) return p;
    }
  return x[0];
}

/* Grains of the places that a press comes to or a release leaves, each as strong as its piece says. */
static void pass(const detent_slope* slopes, unsigned count, double from, double to) {
  const double pitch = 1.0 / detent_grains_per_mm;
  const double begins = (from - detent_grain_origin_mm) / pitch, ends = (to - detent_grain_origin_mm) / pitch;
  const long step = to > from ? 1 : -1;
  long k = (long)floor(begins + 1e-4) + (step > 0);
  unsigned i;
  for (; step > 0 ? (double)k <= ends + 1e-4 : (double)k > ends + 1e-4; k += step) {
    const double mm = detent_grain_origin_mm + (double)k * pitch;
    for (i = 0; i < count; ++i)
      if (mm >= slopes[i].from_mm - 1e-4 && mm <= slopes[i].to_mm + 1e-4) {
        beginGrain(slopes[i].level);
        break;
      }
  }
}

static void travel(const detent_state* s, int releasing, double* at, double to) {
  if (to == *at || !(detent_grains_per_mm > 0)) return;
  if (releasing)
    pass(s->release_slopes, s->release_slope_count, *at, to);
  else
    pass(s->press_slopes, s->press_slope_count, *at, to);
  *at = to;
}

/* A bottom-out lets the jump before it end; jumps and bottom-outs keep their distance. */
static void beginInTurn(unsigned i, const detent_trigger* t) {
  long wait = now;
  if (t->kind && jumpEnds > wait) {
    const long latest = wait + lround(RATE * detent_longest_bottom_out_wait_ms / 1000);
    wait = jumpEnds < latest ? jumpEnds : latest;
  }
  if (wait < earliest) wait = earliest;
  earliest = wait + lround(RATE * detent_burst_spacing_ms / 1000);
  if (!t->kind) jumpEnds = wait + lround(RATE * t->wave.duration_ms / 1000);
  waiting[i] = wait + 1;
  waits[i] = t;
}

/* A release arms what a press plays, a press what a release plays. */
static void arm(const detent_state* s) {
  unsigned i;
  for (i = 0; i < s->trigger_count && i < 80; ++i) ready[i] = !s->triggers[i].release;
}

int main(void) {
  const detent_state* s = &detent_states[0];
  float* out = NULL;
  size_t room = 0;
  double force, before = 0, at = s->start_mm, farthest = 0;
  int releasing = 0, acted = 0;
  unsigned i, answers = 0;
  arm(s);
  for (now = 0; scanf("%lf", &force) == 1; ++now) {
    double next, sum = 0;
    if ((size_t)now >= room) {
      room = 2 * room + (size_t)RATE;
      out = realloc(out, room * sizeof *out);
      if (!out) return 1;
    }
    /* The force has to come back by the hysteresis before a stroke turns; without a force the finger is gone. */
    if (releasing ? force < farthest : force > farthest) farthest = force;
    if (!releasing && (force < farthest - detent_hysteresis_N || force <= detent_rest_N)) {
      releasing = before > detent_rest_N || at > s->start_mm;
      farthest = force;
    } else if (releasing && force > detent_rest_N && force > farthest + detent_hysteresis_N) {
      releasing = 0;
      farthest = force;
    }
    next = releasing ? place(s->release_mm, s->release_N, s->release_points, force, at, 1)
                     : place(s->press_mm, s->press_N, s->press_points, force, at, 0);
    if (!releasing && force <= detent_rest_N) next = at;
    if (releasing && next < (acted ? s->rest_mm : s->start_mm)) next = acted ? s->rest_mm : s->start_mm;
    /* What one sample meets comes in the order travelled. */
    for (i = 0; i < 80; ++i)
      if (waiting[i] == now + 1) {
        waiting[i] = 0;
        begin(waits[i]);
      }
    for (i = 0; i < s->trigger_count && i < 80; ++i) {
      const detent_trigger* t = &s->triggers[i];
      if (!ready[i]) ready[i] = t->release ? force >= t->rearm_N : force <= t->rearm_N;
      if (ready[i] && (t->release ? before > t->force_N && force <= t->force_N
                                  : before < t->force_N && force >= t->force_N)) {
        ready[i] = 0;
        if (releasing ? t->displacement_mm < at : t->displacement_mm > at)
          travel(s, releasing, &at, t->displacement_mm);
        beginInTurn(i, t);
      }
      if (waiting[i] == now + 1) {
        waiting[i] = 0;
        begin(t);
      }
    }
    travel(s, releasing, &at, next);
    if (!(detent_grains_per_mm > 0)) at = next;
    if (!releasing && (s->operating_mm >= 0 ? at >= s->operating_mm : at > s->start_mm)) acted = 1;
    if (releasing && acted && at <= s->rest_mm) {
      acted = 0;
      if (detent_state_count > 1) {
        answers = (answers + 1) % detent_state_count;
        s = &detent_states[answers];
        arm(s);
      }
      at = s->start_mm;
    }
    before = force;
    for (i = 0; i < MOST; ++i)
      if (sounds(&bursts[i])) sum += wave(bursts[i].wave, now - bursts[i].begun, now - bursts[i].begun);
    if (sounds(&grain)) sum += grain.level * wave(grain.wave, now - grain.begun, now - carrierBegun);
    out[now] = (float)sum;
  }
  printf("samples\n");
  for (long n = 0; n < now; ++n) printf("%.9g\n", out[n]);
  free(out);
  return 0;
}
