// SPDX-License-Identifier: GPL-3.0-or-later
// One-axis force device: a motor or voice coil on an H-bridge, a quadrature encoder at the handle. Speaks docs/reference/force-protocol.md:
// the host sends a force every millisecond, or uploads a force table that this program then runs at 4 kHz.
//
// Board: any Arduino with 32 bit and native USB (Teensy, RP2040, SAMD, ESP32-S3). Without hardware it has been run against Detent
// on a simulated board only (tests/playback/device/force_firmware_test.cpp).
//
// Wiring: encoder A and B to pins 2 and 3; H-bridge direction to 4, PWM to 5; an emergency switch that opens when pressed between 6 and
// ground. While pin 6 is open there is no force, so a wire that breaks stops the motor too; a bridge to ground does without a switch.
// Change the four numbers below to your device. There is no force before the host has set a limit.

const int32_t step_nm = 10000;        // one encoder count at the handle
const int32_t largestForce_uN = 5000000;
const int32_t uNPerPwm = 20000;       // force of one PWM count (of 255), measured with a scale
const uint32_t lawPeriod_us = 250;
const uint32_t longestSilence_ms = 50;  // without a line for so long the force goes; the host may ask for less
const int32_t fall_us = 10000;          // at too high a speed the force of the table falls to nothing within this

const uint8_t encoderA = 2, encoderB = 3, directionPin = 4, pwmPin = 5, stopPin = 6;
const uint16_t mostRows = 256;
const uint32_t baud = 230400;

struct Row {
  int32_t press_uN, release_uN, damping_uNs_per_mm;
};

Row rows[mostRows];
uint16_t rowCount;
int32_t first_nm, spacing_nm, radius_nm, wall_uN_per_mm;
bool ownLaw;

// What the host has set. No limit: no force.
int32_t limit_uN, slew_uN_per_ms, speed_um_per_s, rise_ms, silence_ms = (int32_t)longestSilence_ms;
bool stopped, tooFast;     // stopped: by the switch or the host, until it says U
int32_t gain_ppm;          // of the table's force that is let through

volatile int32_t counts;
int32_t force_uN, centre_nm, lastPosition_nm, velocity_um_per_s;
uint32_t lastLine_us, nextLaw_us;
char line[96];
uint8_t lineLength;

void readEncoder() {
  counts = counts + (digitalRead(encoderA) == digitalRead(encoderB) ? 1 : -1);
}

void setup() {
  pinMode(directionPin, OUTPUT);
  pinMode(pwmPin, OUTPUT);
  pinMode(stopPin, INPUT_PULLUP);
  analogWrite(pwmPin, 0);
  attachInterrupt(digitalPinToInterrupt(encoderA), readEncoder, CHANGE);
  Serial.begin(baud);
  lastLine_us = nextLaw_us = micros();
}

void setForce(int64_t wanted_uN) {
  const int64_t most_uN = stopped ? 0 : limit_uN;
  force_uN = (int32_t)(wanted_uN > most_uN ? most_uN : wanted_uN < -most_uN ? -most_uN : wanted_uN);
  const int32_t pwm = abs(force_uN) / uNPerPwm;
  digitalWrite(directionPin, force_uN < 0);
  analogWrite(pwmPin, pwm > 255 ? 255 : pwm);
}

void send(const char* body) {
  uint8_t sum = 0;
  for (const char* c = body; *c; ++c) sum ^= (uint8_t)*c;
  char tail[8];
  snprintf(tail, sizeof tail, "*%02X\n", sum);
  Serial.print(body);
  Serial.print(tail);
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
void moveGain() {
  const int32_t speed = abs(velocity_um_per_s);
  if (speed > speed_um_per_s) tooFast = true;
  if (speed < speed_um_per_s / 2) tooFast = false;
  gain_ppm += tooFast ? -(int32_t)(1000000LL * lawPeriod_us / fall_us) : (int32_t)(1000LL * lawPeriod_us / rise_ms);
  gain_ppm = constrain(gain_ppm, 0, 1000000);
}

void runLaw() {
  const int32_t position_nm = counts * step_nm;
  // Low-pass over 8 steps of the difference: 2 ms.
  const int64_t speed = (int64_t)(position_nm - lastPosition_nm) * 1000 / (int32_t)lawPeriod_us;
  velocity_um_per_s += (int32_t)((speed - velocity_um_per_s) / 8);
  lastPosition_nm = position_nm;
  moveGain();
  // Limited, then faded, then no faster than the slew limit, and never above the ramp: as the host does it.
  int64_t wanted_uN = lawForce(position_nm);
  wanted_uN = wanted_uN > limit_uN ? limit_uN : wanted_uN < -limit_uN ? -(int64_t)limit_uN : wanted_uN;
  wanted_uN = wanted_uN * gain_ppm / 1000000;
  const int64_t change_uN = (int64_t)slew_uN_per_ms * lawPeriod_us / 1000, most_uN = (int64_t)limit_uN * gain_ppm / 1000000;
  if (wanted_uN > force_uN + change_uN) wanted_uN = force_uN + change_uN;
  if (wanted_uN < force_uN - change_uN) wanted_uN = force_uN - change_uN;
  if (wanted_uN > most_uN) wanted_uN = most_uN;
  if (wanted_uN < -most_uN) wanted_uN = -most_uN;
  setForce(wanted_uN);
}

void noForce() {
  gain_ppm = 0;
  setForce(0);
}

void answerPosition(const char* sequence) {
  char body[72];
  const int state = stopped ? 1 : limit_uN == 0 ? 2 : 0;
  snprintf(body, sizeof body, "P,%s,%lu,%ld,%d", sequence, (unsigned long)micros(), (long)counts * step_nm, state);
  send(body);
}

// Numbers of a line after its letter; false if there are fewer.
bool numbersIn(char* text, int32_t* values, uint8_t count) {
  for (uint8_t i = 0; i < count; ++i) {
    text = strchr(text, ',');
    if (!text) return false;
    values[i] = strtol(++text, nullptr, 10);
  }
  return true;
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

void takeLine(char* text) {
  char* star = strrchr(text, '*');
  if (!star) return;
  uint8_t sum = 0;
  for (char* c = text; c != star; ++c) sum ^= (uint8_t)*c;
  if (strtoul(star + 1, nullptr, 16) != sum) return;
  *star = 0;
  lastLine_us = micros();
  int32_t v[2];
  switch (text[0]) {
    case '?': {
      char body[80];
      snprintf(body, sizeof body, "I,force1d,%ld,%ld,%lu,%u,2", (long)step_nm, (long)largestForce_uN,
               1000000UL / lawPeriod_us, (unsigned)mostRows);
      send(body);
      break;
    }
    case 'F':
      if (!numbersIn(text, v, 2)) break;
      ownLaw = false;
      setForce(v[1]);
      *strrchr(text, ',') = 0;
      answerPosition(text + 2);
      break;
    case 'H':
      answerPosition(text + 2);
      break;
    case 'L':
      takeLimits(text);
      break;
    case 'T':
      takeTable(text);
      break;
    case 'R':
      takeRow(text);
      break;
    case 'G':
      ownLaw = rowCount >= 2 && limit_uN > 0;
      noForce();
      centre_nm = counts * step_nm + radius_nm;
      send(ownLaw ? "A" : "N,no table");
      break;
    case 'S':
      stopped = true;
      noForce();
      break;
    case 'U':
      stopped = digitalRead(stopPin) != 0;
      noForce();
      break;
    case 'X':
      ownLaw = false;
      noForce();
      break;
  }
}

void loop() {
  if (digitalRead(stopPin) != 0) stopped = true;
  if (stopped && force_uN != 0) noForce();
  while (Serial.available()) {
    const char c = (char)Serial.read();
    if (c == '\n') {
      line[lineLength] = 0;
      takeLine(line);
      lineLength = 0;
    } else if (lineLength + 1u < sizeof line) {
      line[lineLength++] = c;
    }
  }
  const uint32_t now_us = micros();
  if ((int32_t)(now_us - lastLine_us) > silence_ms * 1000) {
    ownLaw = false;
    noForce();
  }
  if ((int32_t)(now_us - nextLaw_us) < 0) return;
  nextLaw_us = now_us + lawPeriod_us;
  if (ownLaw && !stopped) runLaw();
}
