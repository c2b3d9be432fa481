// SPDX-License-Identifier: GPL-3.0-or-later
// One-axis force device: a motor or voice coil on an H-bridge, a quadrature encoder at the handle. Speaks docs/reference/force-protocol.md:
// the host sends a force every millisecond, or uploads a force table that this program runs by itself.
//
// Boards. RP2040 (Earle Philhower's core), Teensy 4, ESP32, STM32: the table runs at up to 4 kHz; written after the documents of
// these cores, not tried on them. Mega 2560, Leonardo, Micro, Uno and Nano: 8 bit, so the table runs at 400 Hz and PWM has 9.6 bits
// at 20 kHz; compiled with Arduino's own core and run on a simulated Uno and Mega (tests/firmware). Any other core stops at an
// #error below. The rate that `?` answers is measured on the board, and so is the time between two steps.
//
// Wiring: docs/guide/force-feedback.md, "A microcontroller". Encoder A and B to pins 2 and 3; H-bridge direction to 4, PWM to 5 (Uno and
// Nano: 9); an emergency switch that opens when pressed between 6 and ground. 10 kOhm from each of the two H-bridge inputs to ground:
// from reset until this program runs (8 s in a Leonardo's bootloader) the pins float. While pin 6 is open there is no force, so a
// wire that breaks stops the motor too; a bridge to ground does without a switch.
// Change the first four numbers below to your device. There is no force before the host has set a limit.

const int32_t step_nm = 10000;            // one encoder count at the handle
const int32_t largestForce_uN = 5000000;  // what the motor bears
const int32_t fullDuty_uN = 5100000;      // force at a PWM duty of 100 %, measured with a scale while the handle stands still
const int32_t watchedAbove_uN = 250000;   // the encoder is watched above it: five times the friction, 0.25 N at least
const uint32_t baud = 500000;             // exact on a 16 MHz AVR, where 230400 is 3.5 % off; native USB ignores it

const uint32_t longestSilence_ms = 50;  // without a line for so long the force goes; the host may ask for less
const uint32_t watchdog_ms = 60;        // the board resets itself when loop() stands still for so long
const int32_t fall_us = 10000;          // at too high a speed the force of the table falls to nothing within this
const int32_t velocityFilter_us = 2000;
// A table whose encoder counts no step for stillFor_us loses its force over probe_us, and stops after
// uncounted_us in all; each step brings the force back within regained_us. Out of a movement of swift_um_per_s
// and swiftSteps steps the force goes after deadStill_us already, over deadRamp_us. Figures of
// docs/develop/decisions/1114-dead-encoders.md.
const int32_t stillFor_us = 200000, probe_us = 110000, uncounted_us = 410000, regained_us = 20000;
const int32_t swift_um_per_s = 30000, swiftSteps = 4, deadStill_us = 8000, deadRamp_us = 5000;
const int32_t watchedFrom_nm = 100000;   // closer to its rest a handle may stand at its stop for ever
const uint32_t longestAnswer_us = 5000;  // an answer that the port does not take within this is dropped

const uint8_t encoderA = 2, encoderB = 3, directionPin = 4, stopPin = 6;

// PWM of 20 kHz: nobody feels or hears it, and a force is not older than 50 us. Duty runs from 0 to fullDuty.
#if defined(ARDUINO_ARCH_AVR)
#include <avr/wdt.h>
const uint32_t fastestLaw_us = 2500;
const uint16_t fullDuty = F_CPU / 20000;
#if defined(__AVR_ATmega328P__)
const uint8_t pwmPin = 9;  // timer 1; pin 5 is on the timer of micros()
#define DETENT_TIMER(name, rest) name##1##rest
#else
const uint8_t pwmPin = 5;  // timer 3
#define DETENT_TIMER(name, rest) name##3##rest
#endif
const uint16_t mostRows = RAMEND > 0x1000 ? 256 : 40;  // 12 bytes each
#define DETENT_IN_RAM

// After a reset by the watchdog it goes on with its shortest time: off before anything else.
void stopWatchdog() __attribute__((naked, used, section(".init3")));
void stopWatchdog() {
  MCUSR = 0;
  wdt_disable();
}
void beginWatchdog() { wdt_enable(WDTO_60MS); }
void feedWatchdog() { wdt_reset(); }
void beginPwm() {  // fast PWM with ICR as top, no prescaler; the pin is joined to it by writePwm
  DETENT_TIMER(TCCR, A) = _BV(DETENT_TIMER(WGM, 1));
  DETENT_TIMER(TCCR, B) = _BV(DETENT_TIMER(WGM, 3)) | _BV(DETENT_TIMER(WGM, 2)) | _BV(DETENT_TIMER(CS, 0));
  DETENT_TIMER(ICR, ) = fullDuty - 1;
}
void writePwm(uint16_t duty) {
  if (duty == 0) {  // fast PWM has a pulse of one clock at its least
    DETENT_TIMER(TCCR, A) = _BV(DETENT_TIMER(WGM, 1));
    digitalWrite(pwmPin, LOW);
    return;
  }
  DETENT_TIMER(OCR, A) = duty - 1;
  DETENT_TIMER(TCCR, A) = _BV(DETENT_TIMER(COM, A1)) | _BV(DETENT_TIMER(WGM, 1));
}

#else
const uint32_t fastestLaw_us = 250;
const uint8_t pwmPin = 5;
const uint16_t mostRows = 256;
#if defined(ARDUINO_ARCH_RP2040) && !defined(ARDUINO_ARCH_MBED)
#define DETENT_IN_RAM
const uint16_t fullDuty = 4095;
void beginWatchdog() { rp2040.wdt_begin(watchdog_ms); }
void feedWatchdog() { rp2040.wdt_reset(); }
void beginPwm() {
  analogWriteFreq(20000);
  analogWriteResolution(12);
}
void writePwm(uint16_t duty) { analogWrite(pwmPin, duty); }
#elif defined(ARDUINO_ARCH_STM32)
#include <IWatchdog.h>
#define DETENT_IN_RAM
const uint16_t fullDuty = 1023;
void beginWatchdog() { IWatchdog.begin(1000 * watchdog_ms); }
void feedWatchdog() { IWatchdog.reload(); }
void beginPwm() {
  analogWriteFrequency(20000);
  analogWriteResolution(10);
}
void writePwm(uint16_t duty) { analogWrite(pwmPin, duty); }
#elif defined(TEENSYDUINO)
#define DETENT_IN_RAM
const uint16_t fullDuty = 4095;
void beginWatchdog() {}  // none here: what these boards have needs a library
void feedWatchdog() {}
void beginPwm() {
  analogWriteFrequency(pwmPin, 20000);
  analogWriteResolution(12);
}
void writePwm(uint16_t duty) { analogWrite(pwmPin, duty); }
#elif defined(ARDUINO_ARCH_ESP32)
#define DETENT_IN_RAM IRAM_ATTR
const uint16_t fullDuty = 2047;
void beginWatchdog() {}  // none here: the core's own watches whole seconds
void feedWatchdog() {}
#if ESP_ARDUINO_VERSION_MAJOR >= 3
void beginPwm() { ledcAttach(pwmPin, 20000, 11); }
void writePwm(uint16_t duty) { ledcWrite(pwmPin, duty); }
#else
void beginPwm() {
  ledcSetup(0, 20000, 11);
  ledcAttachPin(pwmPin, 0);
}
void writePwm(uint16_t duty) { ledcWrite(0, duty); }
#endif
#else
#error "force1d: write the five functions above for this core: PWM of 20 kHz or more with 10 bits, and a watchdog. analogWrite() alone is 490 to 1000 Hz on most boards, which shakes the handle."
#endif
#endif

struct Row {
  int32_t press_uN, release_uN, damping_uNs_per_mm;
};

Row rows[mostRows];
uint16_t rowCount;
int32_t first_nm, spacing_nm, radius_nm, wall_uN_per_mm;
bool ownLaw;

// What the host has set. No limit: no force.
int32_t limit_uN, slew_uN_per_ms, speed_um_per_s, rise_ms = 1, silence_ms = (int32_t)longestSilence_ms;
bool stopped, tooFast;     // stopped: by the switch, the host or a dead encoder, until the host says U
bool deadEncoder;          // it stopped because the encoder counted no step under force
int32_t gain_ppm;          // of the table's force that is let through
int32_t still_us;          // without a step under force
int32_t sinceStep_us;      // without a step
int32_t moved_nm;          // since the last rest, both ways together; not counted beyond swiftSteps
int32_t speedAtStep_um_per_s;  // when the encoder last counted
int32_t believed_ppm;      // of the force, as far as the count is believed

volatile int32_t counts;
int32_t force_uN, centre_nm, lastPosition_nm, velocity_um_per_s;
uint32_t lastLine_us, nextLaw_us, lastLaw_us;
uint32_t lawPeriod_us = fastestLaw_us;  // that this board keeps, measured at the start
uint32_t meanStep_us;                   // between the last steps of a running table, times 16; 0: none ran yet
char line[96];
uint8_t lineLength;
bool lineSpoilt;  // too long, or not ASCII

// Fast enough for 20,000 counts a second on an 8 bit board: the pins' registers are looked up once.
#if defined(ARDUINO_ARCH_AVR)
volatile uint8_t *registerA, *registerB;
uint8_t maskA, maskB;
void readEncoder() {
  const bool a = *registerA & maskA, b = *registerB & maskB;
  counts = a == b ? counts + 1 : counts - 1;
}
void beginEncoder() {
  registerA = portInputRegister(digitalPinToPort(encoderA));
  registerB = portInputRegister(digitalPinToPort(encoderB));
  maskA = digitalPinToBitMask(encoderA);
  maskB = digitalPinToBitMask(encoderB);
}
#else
void DETENT_IN_RAM readEncoder() { counts = counts + (digitalRead(encoderA) == digitalRead(encoderB) ? 1 : -1); }
void beginEncoder() {}
#endif

int32_t positionNow_nm() {
  noInterrupts();  // four bytes are four reads on an 8 bit board
  const int32_t now = counts;
  interrupts();
  return now * step_nm;
}

void setForce(int64_t wanted_uN) {
  const int64_t most_uN = stopped ? 0 : limit_uN;
  force_uN = (int32_t)(wanted_uN > most_uN ? most_uN : wanted_uN < -most_uN ? -most_uN : wanted_uN);
  const int64_t duty = (int64_t)abs(force_uN) * fullDuty / fullDuty_uN;
  digitalWrite(directionPin, force_uN < 0);
  writePwm(duty > fullDuty ? fullDuty : (uint16_t)duty);
}

// The force law of Detent with a linear table, a play operator between press and release, damping, and a wall at the end.
int64_t lawForce(int32_t position_nm) {
  if (position_nm - radius_nm > centre_nm) centre_nm = position_nm - radius_nm;
  if (position_nm + radius_nm < centre_nm) centre_nm = position_nm + radius_nm;
  const int64_t along_nm = (int64_t)position_nm - first_nm;
  int32_t index = along_nm <= 0 ? 0 : (int32_t)(along_nm / spacing_nm);
  int32_t within_nm = along_nm <= 0 ? 0 : (int32_t)(along_nm % spacing_nm);
  int64_t wall_uN = 0;
  if (index >= rowCount - 1) {
    wall_uN = (along_nm - (int64_t)(rowCount - 1) * spacing_nm) * wall_uN_per_mm / 1000000;
    index = rowCount - 2;
    within_nm = spacing_nm;
  }
  const Row& a = rows[index];
  const Row& b = rows[index + 1];
  const int64_t press = a.press_uN + (int64_t)(b.press_uN - a.press_uN) * within_nm / spacing_nm;
  const int64_t release = a.release_uN + (int64_t)(b.release_uN - a.release_uN) * within_nm / spacing_nm;
  const int64_t in_nm = (int64_t)position_nm - centre_nm + radius_nm;  // 0: releasing, 2 radius: pressing
  const int64_t damping = (int64_t)a.damping_uNs_per_mm * velocity_um_per_s / 1000;
  return release + (press - release) * in_nm / (2 * (int64_t)radius_nm) + wall_uN + damping;
}

// How much of the force is let through: up from nothing within rise_ms, down where the handle is too fast.
void moveGain(int32_t step_us) {
  const int32_t speed = abs(velocity_um_per_s);
  if (speed > speed_um_per_s) tooFast = true;
  if (speed < speed_um_per_s / 2) tooFast = false;
  gain_ppm += tooFast ? -(int32_t)(1000000LL * step_us / fall_us) : (int32_t)(1000LL * step_us / rise_ms);
  gain_ppm = constrain(gain_ppm, 0, 1000000);
}

// True once a movement has ended from one step to the next: a hand slows down over several.
bool stoppedDead(int32_t way_nm, int32_t step_us) {
  if (way_nm == 0) {
    if (sinceStep_us < stillFor_us) sinceStep_us += step_us;
    return sinceStep_us >= deadStill_us && moved_nm >= swiftSteps * step_nm && speedAtStep_um_per_s >= swift_um_per_s;
  }
  if (sinceStep_us >= deadStill_us) moved_nm = 0;
  if (moved_nm < swiftSteps * step_nm) moved_nm += abs(way_nm);
  speedAtStep_um_per_s = abs(velocity_um_per_s);
  sinceStep_us = 0;
  return false;
}

// A count that stands still is a resting finger or a dead encoder. A live one counts as soon as the force falls
// under the finger.
int64_t watchedForce(int64_t wanted_uN, int32_t position_nm, int32_t way_nm, int32_t step_us) {
  const bool dead = stoppedDead(way_nm, step_us), moved = way_nm != 0;
  const bool watched = (wanted_uN > watchedAbove_uN || wanted_uN < -watchedAbove_uN) && position_nm > watchedFrom_nm &&
                       position_nm > 2 * step_nm;
  still_us = moved || !watched ? 0 : still_us + step_us;
  believed_ppm += (int32_t)(watched && dead           ? -1000000LL * step_us / deadRamp_us
                            : still_us >= stillFor_us ? -1000000LL * step_us / probe_us
                                                      : 1000000LL * step_us / regained_us);
  believed_ppm = constrain(believed_ppm, 0, 1000000);
  if (still_us >= uncounted_us) stopped = deadEncoder = true;
  return wanted_uN * believed_ppm / 1000000;
}

void runLaw(int32_t step_us) {
  const int32_t position_nm = positionNow_nm();
  const int32_t way_nm = position_nm - lastPosition_nm;
  const int64_t speed = (int64_t)way_nm * 1000 / step_us;
  velocity_um_per_s += (int32_t)((speed - velocity_um_per_s) * step_us / (velocityFilter_us > step_us ? velocityFilter_us : step_us));
  lastPosition_nm = position_nm;
  moveGain(step_us);
  // Limited, then faded, then no faster than the slew limit, and never above the ramp: as the host does it.
  int64_t wanted_uN = lawForce(position_nm);
  wanted_uN = wanted_uN > limit_uN ? limit_uN : wanted_uN < -limit_uN ? -(int64_t)limit_uN : wanted_uN;
  wanted_uN = watchedForce(wanted_uN * gain_ppm / 1000000, position_nm, way_nm, step_us);
  const int64_t change_uN = (int64_t)slew_uN_per_ms * step_us / 1000, most_uN = (int64_t)limit_uN * gain_ppm / 1000000;
  if (wanted_uN > force_uN + change_uN) wanted_uN = force_uN + change_uN;
  if (wanted_uN < force_uN - change_uN) wanted_uN = force_uN - change_uN;
  if (wanted_uN > most_uN) wanted_uN = most_uN;
  if (wanted_uN < -most_uN) wanted_uN = -most_uN;
  setForce(wanted_uN);
}

void noForce() {
  gain_ppm = still_us = moved_nm = 0;
  believed_ppm = 1000000;
  setForce(0);
}

// How long a step of the law takes here, on a table of zeros without a limit: a quarter of the time stays for the port.
void measureLaw() {
  rowCount = 2;
  spacing_nm = radius_nm = 100000;
  for (uint8_t i = 0; i < 8; ++i) {
    const uint32_t began_us = micros();
    first_nm = positionNow_nm() + 1000 - spacing_nm * i;  // before, within and behind the table
    runLaw(fastestLaw_us);
    const uint32_t took_us = micros() - began_us;
    if (took_us * 4 / 3 > lawPeriod_us) lawPeriod_us = took_us * 4 / 3;
  }
  rowCount = 0;
  ownLaw = false;  // where memory outlives the reset
  noForce();
}

void setup() {
  pinMode(directionPin, OUTPUT);
  pinMode(pwmPin, OUTPUT);
  pinMode(stopPin, INPUT_PULLUP);
  beginPwm();
  writePwm(0);
  beginEncoder();
  attachInterrupt(digitalPinToInterrupt(encoderA), readEncoder, CHANGE);
  Serial.begin(baud);
  measureLaw();
  lastLine_us = nextLaw_us = lastLaw_us = micros();
  beginWatchdog();
}

// The port must not hold loop() up: it waits a quarter of a second where nobody reads a native USB port.
void send(const char* body) {
  uint8_t sum = 0;
  for (const char* c = body; *c; ++c) sum ^= (uint8_t)*c;
  char tail[8];
  snprintf(tail, sizeof tail, "*%02X\n", sum);
  const int length = (int)(strlen(body) + strlen(tail));
  const uint32_t began_us = micros();
  while (Serial.availableForWrite() < length)
    if (micros() - began_us > longestAnswer_us) return;
  Serial.print(body);
  Serial.print(tail);
}

void answerPosition(const char* sequence) {
  char body[72];
  const int state = deadEncoder ? 3 : stopped ? 1 : limit_uN == 0 ? 2 : 0;
  snprintf(body, sizeof body, "P,%s,%lu,%ld,%d", sequence, (unsigned long)micros(), (long)positionNow_nm(), state);
  send(body);
}

// Reads a decimal integer that ends with the text or at a comma, and goes past the comma. False if there is none, or one too large.
bool readNumber(char*& text, int32_t& value) {
  const bool negative = *text == '-';
  if (negative) ++text;
  int64_t number = 0;
  uint8_t digits = 0;
  for (; *text >= '0' && *text <= '9'; ++text, ++digits) {
    number = 10 * number + (*text - '0');
    if (number > INT32_MAX) return false;
  }
  if (digits == 0 || (*text != ',' && *text != 0)) return false;
  if (*text == ',' && *++text == 0) return false;
  value = (int32_t)(negative ? -number : number);
  return true;
}

// Exactly so many numbers after the letter and its comma.
bool numbersIn(char* text, int32_t* values, uint8_t count) {
  if (text[1] != ',') return false;
  text += 2;
  for (uint8_t i = 0; i < count; ++i)
    if (!readNumber(text, values[i])) return false;
  return *text == 0;
}

// Length of the digits after "F," or "H,": the sequence number is said back as it came. 0 if it is none.
uint8_t sequenceLength(const char* text) {
  uint8_t length = 0;
  if (text[1] != ',') return 0;
  while (text[2 + length] >= '0' && text[2 + length] <= '9') ++length;
  return length > 10 ? 0 : length;
}

// Anything that is no limit takes away the one there was.
void takeLimits(char* text) {
  int32_t v[5];
  limit_uN = 0;
  ownLaw = false;
  noForce();
  if (!numbersIn(text, v, 5) || v[0] <= 0 || v[1] <= 0 || v[2] <= 0 || v[3] <= 0 || v[4] <= 0) return send("N,limit");
  limit_uN = v[0] < largestForce_uN ? v[0] : largestForce_uN;
  slew_uN_per_ms = v[1];
  speed_um_per_s = v[2];
  rise_ms = v[3];
  silence_ms = v[4] < (int32_t)longestSilence_ms ? v[4] : (int32_t)longestSilence_ms;
  char body[72];
  snprintf(body, sizeof body, "L,%ld,%ld,%ld,%ld,%ld", (long)limit_uN, (long)slew_uN_per_ms, (long)speed_um_per_s,
           (long)rise_ms, (long)silence_ms);
  send(body);
}

void takeTable(char* text) {
  int32_t v[6];
  ownLaw = false;
  rowCount = 0;
  noForce();  // of the table before
  if (!numbersIn(text, v, 6) || v[5] <= 0 || v[5] > limit_uN) return send("N,limit");
  if (v[0] < 2 || v[0] > mostRows || v[2] <= 0 || v[3] <= 0) return send("N,table");
  limit_uN = v[5];
  rowCount = (uint16_t)v[0];
  first_nm = v[1];
  spacing_nm = v[2];
  radius_nm = v[3];
  wall_uN_per_mm = v[4];
  send("A");
}

void takeRow(char* text) {
  int32_t v[4];
  if (!numbersIn(text, v, 4) || v[0] < 0 || v[0] >= rowCount) return send("N,row");
  rows[v[0]] = {v[1], v[2], v[3]};
  send("A");
}

void startTable() {
  ownLaw = rowCount >= 2 && limit_uN > 0;
  noForce();
  velocity_um_per_s = 0;
  tooFast = false;
  lastPosition_nm = positionNow_nm();
  centre_nm = lastPosition_nm + radius_nm;
  lastLaw_us = nextLaw_us = micros();
  send(ownLaw ? "A" : "N,no table");
}

void tellWho() {
  char body[80];
  const uint32_t slowest_us = meanStep_us / 16 > lawPeriod_us ? meanStep_us / 16 : lawPeriod_us;
  snprintf(body, sizeof body, "I,force1d,%ld,%ld,%lu,%u,2", (long)step_nm, (long)largestForce_uN,
           (unsigned long)(1000000 / slowest_us), (unsigned)mostRows);
  send(body);
}

// Value of a hex digit; -1 if it is none.
int hexDigit(char c) {
  return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

// Does what a whole line says. True if it was one of the protocol's: only those keep the force from going.
bool takeLine(char* text) {
  char* star = strrchr(text, '*');
  if (!star || strlen(star) != 3) return false;
  uint8_t sum = 0;
  for (char* c = text; c != star; ++c) sum ^= (uint8_t)*c;
  if (hexDigit(star[1]) != sum >> 4 || hexDigit(star[2]) != (sum & 15)) return false;
  *star = 0;
  int32_t v[1];
  const bool alone = text[0] != 0 && text[1] == 0;
  switch (text[0]) {
    case '?':
      if (!alone) return false;
      tellWho();
      return true;
    case 'F': {
      const uint8_t length = sequenceLength(text);
      char* force = text + 2 + length;
      if (length == 0 || *force != ',' || !numbersIn(force - 1, v, 1)) return false;
      ownLaw = false;
      setForce(v[0]);
      *force = 0;
      answerPosition(text + 2);
      return true;
    }
    case 'H': {
      const uint8_t length = sequenceLength(text);
      if (length == 0 || text[2 + length] != 0) return false;
      answerPosition(text + 2);
      return true;
    }
    case 'L':
      takeLimits(text);
      return true;
    case 'T':
      takeTable(text);
      return true;
    case 'R':
      takeRow(text);
      return true;
    case 'G':
      if (!alone) return false;
      startTable();
      return true;
    case 'S':
      if (!alone) return false;
      stopped = true;
      noForce();
      return true;
    case 'U':
      if (!alone) return false;
      stopped = digitalRead(stopPin) != 0;
      deadEncoder = false;
      noForce();
      return true;
    case 'X':
      if (!alone) return false;
      ownLaw = false;
      noForce();
      return true;
  }
  return false;
}

void receive(char c) {
  if (c == '\n') {
    line[lineLength] = 0;
    if (!lineSpoilt && takeLine(line)) lastLine_us = micros();
    lineLength = 0;
    lineSpoilt = false;
  } else if (lineLength + 1u < sizeof line && c >= ' ' && c <= '~') {
    line[lineLength++] = c;
  } else {
    lineSpoilt = true;
  }
}

void loop() {
  feedWatchdog();
  if (digitalRead(stopPin) != 0) stopped = true;
  if (stopped && force_uN != 0) noForce();
  for (uint8_t most = 64; most > 0 && Serial.available(); --most) receive((char)Serial.read());
  const uint32_t now_us = micros();
  if ((int32_t)(now_us - lastLine_us) > silence_ms * 1000) {
    ownLaw = false;
    if (force_uN != 0 || gain_ppm != 0) noForce();
  }
  if (!ownLaw || stopped || (int32_t)(now_us - nextLaw_us) < 0) return;
  int32_t step_us = (int32_t)(now_us - lastLaw_us);
  if (step_us < 1 || step_us > 50000) step_us = (int32_t)lawPeriod_us;
  lastLaw_us = now_us;
  nextLaw_us += lawPeriod_us;
  if ((int32_t)(now_us - nextLaw_us) > 0) nextLaw_us = now_us + lawPeriod_us;
  meanStep_us = meanStep_us == 0 ? 16 * (uint32_t)step_us : meanStep_us + step_us - meanStep_us / 16;
  runLaw(step_us);
}
