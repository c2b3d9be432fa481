/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plays a button on a rigid surface: a force sensor in, a transducer out. C99 or C++. The header:
 *   detent-play export samples/buttons/B.button.json --format c -o button.h
 * A board gives two functions: the force in newtons, and a sample from -1 to 1 to its converter. Call `step` at a steady rate of
 * some kilohertz; forces may come slower. It follows the curves, so that all of the header is played: grains, jumps, bottom-outs,
 * the states of a self-locking button. Where a click is enough, watch the triggers' force_N and rearm_N alone. */
#include <math.h>
#include "button.h"

float board_force_N(void);
void board_play(float sample);

typedef struct { detent_wave wave; float level; long age, length; int jump; } voice; /* in steps; below an age of 0 it waits */

static voice voices[12], grain;
static float rate_Hz, x_mm, extreme_N;      /* where the finger is; the furthest force of this stroke */
static int begun, releasing, actuated;
static unsigned state, piece;               /* piece of the stroke's curve that x_mm is on */
static detent_state current;                /* of `state`: the header's arrays may be in flash that is not read like RAM */
static char played[65];                     /* of each trigger: not armed; a header has at most 65 of them */
static long carrier, sinceGrain = 1000000, untilNext, untilJumpEnds; /* in steps */

static long steps(float ms) { return (long)(ms * rate_Hz / 1000 + 0.5f); }
static int sounds(const voice* v) { return v->age < v->length; }
static float limited(float value, float low, float high) { return value < low ? low : value > high ? high : value; }

static detent_trigger triggerAt(const detent_state* s, unsigned i) { detent_trigger t; DETENT_COPY(t, s->triggers[i]); return t; }

static float sampleOf(voice* v, long cycleAge) {
  if (!sounds(v) || v->age++ < 0) return 0;
  const float ms = 1000 * (float)(v->age - 1) / rate_Hz, left_ms = v->wave.duration_ms - ms;
  const float level = ms < v->wave.rise_ms ? ms / v->wave.rise_ms : left_ms < v->wave.fall_ms ? left_ms / v->wave.fall_ms : 1;
  return v->level * v->wave.amplitude * level * sinf(6.2831853f * fmodf((float)cycleAge * (v->wave.frequency_Hz / rate_Hz), 1));
}

static void beginGrain(float level) {
  const float loudest = detent_loudest_grains_per_s, alone = 1000 / detent_grain.duration_ms;
  if (loudest > 0 && sinceGrain > 0)
    level *= powf(limited(rate_Hz / (float)sinceGrain, alone, loudest) / loudest, detent_grain_level_power);
  for (unsigned i = 0; i < sizeof voices / sizeof *voices; ++i)
    if (voices[i].jump && voices[i].age >= 0 && sounds(&voices[i])) { level *= detent_slope_under_jump; break; }
  if (!sounds(&grain)) carrier = 0;
  grain.wave = detent_grain, grain.level = level, grain.age = sinceGrain = 0;
  grain.length = steps(grain.wave.duration_ms);
}

/* In its turn: a bottom-out lets the jump before it end, and none begins right after another. */
static void begin(const detent_trigger* t) {
  const long latest = steps(detent_longest_bottom_out_wait_ms);
  long wait = !t->kind ? 0 : untilJumpEnds < latest ? untilJumpEnds : latest;
  if (wait < untilNext) wait = untilNext;
  untilNext = wait + steps(detent_burst_spacing_ms);
  if (!t->kind) untilJumpEnds = wait + steps(t->wave.duration_ms);
  unsigned i = 0;
  while (i + 1 < sizeof voices / sizeof *voices && sounds(&voices[i])) ++i;
  voices[i].wave = t->wave, voices[i].level = 1, voices[i].age = -wait, voices[i].jump = !t->kind;
  voices[i].length = steps(t->wave.duration_ms);
}

static long cellOf(float mm) { return (long)floorf((mm - detent_grain_origin_mm) * detent_grains_per_mm + 1e-4f); }

static void passGrains(const detent_slope* slopes, unsigned count, float to_mm) { /* slopes rise in displacement */
  const float half_mm = 0.5f / detent_grains_per_mm;
  long k = cellOf(x_mm);
  unsigned i = 0;
  for (const long end = cellOf(to_mm); k != end; k += releasing ? -1 : 1) {
    const float at_mm = detent_grain_origin_mm + (float)(releasing ? k : k + 1) / detent_grains_per_mm;
    for (; i < count; ++i) {
      detent_slope slope;
      DETENT_COPY(slope, slopes[releasing ? count - 1 - i : i]);
      const int below = at_mm <= slope.from_mm - half_mm, above = at_mm >= slope.to_mm + half_mm;
      if (releasing ? below : above) continue;
      if (!below && !above) beginGrain(slope.level);
      break;
    }
  }
  x_mm = to_mm;
}

static void travel(const detent_state* s, float to_mm) {
  const float sign = releasing ? -1.0f : 1.0f;
  const detent_slope* slopes = releasing ? s->release_slopes : s->press_slopes;
  const unsigned count = detent_grains_per_mm > 0 ? releasing ? s->release_slope_count : s->press_slope_count : 0;
  for (unsigned i = 0; i < s->trigger_count; ++i) {
    const detent_trigger t = triggerAt(s, i);
    const float ahead = sign * (t.displacement_mm - x_mm), left = sign * (to_mm - t.displacement_mm);
    if (t.release != releasing || (t.kind ? ahead <= 0 || left < 0 : ahead < 0 || left <= 0)) continue;
    passGrains(slopes, count, t.displacement_mm);
    if (!played[i]) begin(&t);
    played[i] = 1;
  }
  passGrains(slopes, count, to_mm);
}

static int beyond(float a, float b) { return releasing ? a < b : a > b; }

/* Along the stroke's curve for as long as it lets this force. A jump passes many of its pieces in one step. */
static void follow(const detent_state* s, float force_N, float end_mm) {
  const float* mm = releasing ? s->release_mm : s->press_mm;
  const float* N = releasing ? s->release_N : s->press_N;
  const unsigned n = releasing ? s->release_points : s->press_points;
  float to_mm = x_mm;
  for (; piece + 1 < n && beyond(end_mm, to_mm); ++piece) {
    const unsigned a = releasing ? n - 1 - piece : piece, b = releasing ? a - 1 : a + 1;
    const float b_mm = DETENT_NUMBER(mm[b]);
    if (beyond(to_mm, b_mm)) continue;
    const float a_mm = DETENT_NUMBER(mm[a]), b_N = DETENT_NUMBER(N[b]);
    float here_N = DETENT_NUMBER(N[a]);
    if (a_mm != to_mm && a_mm != b_mm) here_N += (b_N - here_N) * (to_mm - a_mm) / (b_mm - a_mm);
    if (beyond(here_N, force_N)) break;
    const int stops = beyond(b_N, force_N);
    to_mm = stops ? to_mm + (b_mm - to_mm) * (force_N - here_N) / (b_N - here_N) : b_mm;
    if (stops) break;
  }
  if (beyond(to_mm, end_mm)) to_mm = end_mm;
  if (to_mm != x_mm) travel(s, to_mm);
}

static void turn(int release, float force_N) { releasing = release, extreme_N = force_N, piece = 0; }

void step(float steps_per_s) {
  const float force_N = board_force_N();
  const detent_state* s = &current;
  const int atRest = force_N <= detent_rest_N;
  if (!begun) {
    begun = 1;
    DETENT_COPY(current, detent_states[state]);
    x_mm = s->start_mm;
  }
  rate_Hz = steps_per_s;
  const float end_mm = actuated ? s->rest_mm : s->start_mm; /* of a release */
  if (!releasing) {
    if (force_N > extreme_N) extreme_N = force_N;
    if (force_N < extreme_N - detent_hysteresis_N || (atRest && x_mm > end_mm)) turn(1, force_N);
  } else {
    if (force_N < extreme_N) extreme_N = force_N > 0 ? force_N : 0;
    if (!atRest && force_N > extreme_N + detent_hysteresis_N) turn(0, force_N);
  }
  if (releasing || !atRest) follow(s, force_N, releasing ? end_mm : 1e30f);
  if (!releasing && (s->operating_mm < 0 ? x_mm > s->start_mm : x_mm >= s->operating_mm)) actuated = 1;
  for (unsigned i = 0; i < s->trigger_count; ++i) {
    if (!played[i]) continue;
    const detent_trigger t = triggerAt(s, i);
    if (t.release ? x_mm >= t.rearm_displacement_mm : x_mm <= t.rearm_displacement_mm) played[i] = 0;
  }
  const int ended = releasing && actuated && x_mm <= end_mm;
  if (ended && detent_state_count > 1) { /* the next state of a self-locking button answers */
    state = (state + 1) % detent_state_count;
    DETENT_COPY(current, detent_states[state]);
    for (unsigned i = 0; i < sizeof played; ++i) played[i] = 0;
  }
  if (ended) actuated = 0, piece = 0, x_mm = s->start_mm;
  float sum = 0;
  for (unsigned i = 0; i < sizeof voices / sizeof *voices; ++i) sum += sampleOf(&voices[i], voices[i].age);
  sum += sampleOf(&grain, carrier);
  carrier = sounds(&grain) ? carrier + 1 : 0;
  if (sinceGrain < 1000000) ++sinceGrain;
  if (untilNext > 0) --untilNext;
  if (untilJumpEnds > 0) --untilJumpEnds;
  board_play(limited(sum, -1, 1));
}
