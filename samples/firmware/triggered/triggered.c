/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plays a button on a rigid surface: a force sensor in, a transducer out. C99. The header:
 *   detent-play export samples/buttons/B.button.json --format c -o button.h
 * A board gives two functions: the force in newtons, and a sample from -1 to 1 to its converter. Call `step` at a
 * steady rate of some kilohertz; forces may come slower. One sound at a time: a new one takes the place of the last. */
#include "button.h"
#include <math.h>

float board_force_N(void);
void board_play(float sample);

static unsigned state;             /* of a self-locking button */
static unsigned armed = ~0u;       /* one bit for each trigger of the state */
static float last_N;               /* force of the step before */
static const detent_wave* playing; /* 0: silence */
static float played_ms;

/* Level of a wave: rises over rise_ms, falls over fall_ms. */
static float level(const detent_wave* wave, float ms) {
  if (wave->rise_ms > 0 && ms < wave->rise_ms) return wave->amplitude * ms / wave->rise_ms;
  const float falling = ms - (wave->duration_ms - wave->fall_ms);
  return falling > 0 && wave->fall_ms > 0 ? wave->amplitude * (1 - falling / wave->fall_ms) : wave->amplitude;
}

static void watch(const detent_trigger* trigger, unsigned bit, float force_N) {
  const int passed = trigger->release ? last_N > trigger->force_N && force_N <= trigger->force_N
                                      : last_N < trigger->force_N && force_N >= trigger->force_N;
  const int back = trigger->release ? force_N >= trigger->rearm_N : force_N <= trigger->rearm_N;
  if (back) armed |= bit;
  if (!passed || !(armed & bit)) return;
  armed &= ~bit;
  playing = &trigger->wave;
  played_ms = 0;
}

/* A finger that lets go has actuated a self-locking button: its other state answers next. */
static void change_state(float force_N) {
  const float threshold_N = detent_states[state].press_threshold_N;
  static int actuated;
  if (threshold_N > 0 && force_N >= threshold_N) actuated = 1;
  if (!actuated || force_N > 0.01f) return;
  actuated = 0;
  state = (state + 1) % detent_state_count;
  armed = ~0u;
}

void step(float rate_Hz) {
  const float force_N = board_force_N();
  const detent_state* now = &detent_states[state];
  for (unsigned i = 0; i < now->trigger_count && i < 32; ++i) watch(&now->triggers[i], 1u << i, force_N);
  change_state(force_N);
  last_N = force_N;
  float sample = 0;
  if (playing) {
    sample = level(playing, played_ms) * sinf(6.2831853f * playing->frequency_Hz * played_ms / 1000);
    played_ms += 1000 / rate_Hz;
    if (played_ms >= playing->duration_ms) playing = 0;
  }
  board_play(sample);
}
