// SPDX-License-Identifier: GPL-3.0-or-later
// Force sensor of the mockup: Interlink FSR 400 to the voltage of the board's inputs, a fixed resistor to ground, the middle to A0.
// Never 5 V on a board of 3.3 V (RP2040, Zero): docs/guide/first-button.md says which pin on which board.
// Sends one line per reading, 1000 times a second, as docs/reference/serial-protocol.md says:
//
//     TIME_US,COUNTS*XX        time since start (wraps after 71.6 minutes), reading of the converter, checksum
//
// Board: any Arduino whose `Serial` is native USB (Leonardo, Micro, RP2040, MKR, XIAO; ESP32-S3 with "USB CDC On Boot"). On a Zero native
// USB is `SerialUSB`: write that for `Serial`. Uno, Mega and Nano Every have a USB chip of their own: give --baud 500000, and set an FTDI's
// latency timer to 1 ms, or readings come in packets of 16 ms. Divider: 10 kOhm spans about 0.2 N to 12 N.
// Compiled for Uno, Leonardo and Mega and run on a simulated Uno and Mega (tests/firmware).

const uint8_t sensorPin = A0;
const uint32_t period_us = 1000;
const uint32_t baud = 500000;  // exact on a 16 MHz AVR, where 230400 is 3.5 % off; native USB ignores it

uint32_t next_us;

// Said whenever somebody asks: who opens the port after the start hears it too.
void greet() {
  Serial.println("# detent-force 1 fsr400 divider 1023");
}

void setup() {
  Serial.begin(baud);
  greet();
  next_us = micros();
}

void sendReading(uint32_t time_us, int counts) {
  char line[32];
  const int length = snprintf(line, sizeof line, "%lu,%d", (unsigned long)time_us, counts);
  uint8_t checksum = 0;
  for (int i = 0; i < length; ++i) checksum ^= (uint8_t)line[i];
  char tail[8];
  snprintf(tail, sizeof tail, "*%02X\n", checksum);
  Serial.print(line);
  Serial.print(tail);
}

void loop() {
  while (Serial.available() > 0) {
    if (Serial.read() == '?') greet();
  }
  const uint32_t now_us = micros();
  if ((int32_t)(now_us - next_us) < 0) return;
  next_us += period_us;
  // After a stall start anew instead of sending a burst of old times.
  if ((int32_t)(now_us - next_us) > (int32_t)(10 * period_us)) next_us = now_us + period_us;
  sendReading(now_us, analogRead(sensorPin));
}
