/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The board under samples/firmware/triggered on an AVR: 5 V at A0 are 5 N, and a PWM pin gives the sample about its middle.
 * The program is included on the compiler's command line. */
#include <Arduino.h>

void step(float steps_per_s);

#if defined(TCCR2A)
#define DUTY OCR2B /* pin 3 of an Uno, pin 9 of a Mega */
static void beginPwm(void) { TCCR2A = _BV(COM2B1) | _BV(WGM21) | _BV(WGM20), TCCR2B = _BV(CS20); }
#else
#define DUTY OCR1AL /* pin 9 of a Leonardo */
static void beginPwm(void) { TCCR1A = _BV(COM1A1) | _BV(WGM10), TCCR1B = _BV(WGM12) | _BV(CS10); }
#endif

float board_force_N(void) { return (float)analogRead(0) * (5.0f / 1023.0f); }
void board_play(float sample) { DUTY = (unsigned char)(128 + 127 * sample); }

volatile unsigned longestStep_us; /* read by the test */
static unsigned long next_us;

void setup(void) {
  beginPwm();
  DUTY = 128;
  next_us = micros();
}

void loop(void) {
  const unsigned long now_us = micros();
  if ((long)(now_us - next_us) < 0) return;
  next_us += 1000;
  step(1000);
  const unsigned took_us = (unsigned)(micros() - now_us);
  if (took_us > longestStep_us) longestStep_us = took_us;
}
