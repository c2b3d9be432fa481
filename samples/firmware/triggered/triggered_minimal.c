/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plays a button's clicks on a rigid surface: a force sensor in, a transducer out. C99 or C++. The header:
 *   detent-play export samples/buttons/B.button.json --format c -o button.h
 * A board gives two functions: the force in newtons, and a sample from -1 to 1 to its converter. Call `step` at a steady rate of
 * some kilohertz. It watches the force alone: jumps, bottom-outs and the states of a self-locking button are played, the grains of
 * a slope are not; triggered.c beside it plays those too. */
#include <math.h>
#define DETENT_TRIGGERS_ONLY
#include "button.h"

float board_force_N(void);
void board_play(float sample);

typedef struct { detent_wave wave; long age, length; } voice; /* in steps; below an age of 0 it waits */

static voice voices[12];
static float rate_Hz, before_N;
static unsigned state;
static detent_state now; /* of `state`: the header's arrays may be in flash that is not read like RAM */
static int begun, actuated;
static char spent[65];                /* of each trigger: not armed; a header has at most 65 of them */
static long untilNext, untilJumpEnds; /* in steps */

static long steps(float ms) { return (long)(ms * rate_Hz / 1000 + 0.5f); }
static int sounds(const voice* v) { return v->age < v->length; }

static detent_trigger triggerAt(unsigned i) { detent_trigger t; DETENT_COPY(t, now.triggers[i]); return t; }

static void answer(unsigned next) { /* a press is armed, a release is not before it has been pressed */
  state = next, actuated = 0;
  DETENT_COPY(now, detent_states[next]);
  for (unsigned i = 0; i < now.trigger_count; ++i) spent[i] = (char)triggerAt(i).release;
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
  voices[i].wave = t->wave, voices[i].age = -wait, voices[i].length = steps(t->wave.duration_ms);
}

static float sampleOf(voice* v) {
  if (!sounds(v) || v->age++ < 0) return 0;
  const float ms = 1000 * (float)(v->age - 1) / rate_Hz, left_ms = v->wave.duration_ms - ms;
  const float level = ms < v->wave.rise_ms ? ms / v->wave.rise_ms : left_ms < v->wave.fall_ms ? left_ms / v->wave.fall_ms : 1;
  return v->wave.amplitude * level * sinf(6.2831853f * fmodf((float)(v->age - 1) * (v->wave.frequency_Hz / rate_Hz), 1));
}

void step(float steps_per_s) {
  const float N = board_force_N();
  rate_Hz = steps_per_s;
  if (!begun) begun = 1, answer(0);
  for (unsigned i = 0; i < now.trigger_count; ++i) {
    const detent_trigger t = triggerAt(i);
    if (t.release ? N >= t.rearm_N : N <= t.rearm_N) spent[i] = 0;
    if (spent[i] || !(t.release ? before_N > t.force_N && N <= t.force_N : before_N < t.force_N && N >= t.force_N)) continue;
    spent[i] = 1;
    begin(&t);
  }
  if (now.operating_N >= 0 && N >= now.operating_N) actuated = 1;
  if (detent_state_count > 1 && actuated && N <= fmaxf(now.settled_N, detent_rest_N)) answer((state + 1) % detent_state_count);
  before_N = N;
  float sum = 0;
  for (unsigned i = 0; i < sizeof voices / sizeof *voices; ++i) sum += sampleOf(&voices[i]);
  if (untilNext > 0) --untilNext;
  if (untilJumpEnds > 0) --untilJumpEnds;
  board_play(sum < -1 ? -1 : sum > 1 ? 1 : sum);
}
