// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A device at the far end of a serial port: a pty whose other end a program opens, a thread that answers
// lines late, and a handle with a finger that moves in real time. What a device says is the subclass's.

#include <array>
#include <atomic>
#include <deque>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/playback/plant/handle.h"
#include "tests/playback/plant/transport.h"

namespace detent::test {

struct PtySettings {
  HandleSettings handle;
  FingerSettings finger;
  Plan plan = [](double) { return Intent{}; };
  double start_mm = 0;
  double replyDelay_s = 0;    ///< delay from a line to its answer
  double replyJitter_s = 0;   ///< random addition, 0 to this
  double brokenAnswers = 0;   ///< share of answers whose bytes are damaged
  double resetAt_s = -1;      ///< time in the scene; < 0: never
  double unplugAt_s = -1;     ///< time in the scene; < 0: never
  double pluggedAgain_s = 0;  ///< time after it was unplugged; 0: never
  /// The scene (finger and faults) begins with the first line, or waits until the device has something to
  /// run: a program may take its time to measure a slow link and to push a free handle first.
  bool sceneWaits = false;
  double period_s = 0.001;  ///< of the program's questions, by which the device's punctuality is judged
  std::uint64_t seed = 1;
};

/// The device's part in a run, which decides if the run says anything about the program.
struct Witness {
  bool punctual = true;
  bool tooStrong = false;  ///< more than the largest force: no lateness excuses it
  bool judged = true;      ///< false: the device was late in each of the runs
};

/// One moment of the device, taken every millisecond. Its world stands still until the first line comes.
struct PtyMoment {
  double time_s = 0;  ///< time in the scene; far below 0 before the scene has begun
  double position_mm = 0;
  double motor_N = 0;  ///< acting on the handle, against pressing
  double finger_N = 0;
};

class PtyDevice {
 public:
  explicit PtyDevice(const PtySettings& settings);
  virtual ~PtyDevice();
  PtyDevice(const PtyDevice&) = delete;
  PtyDevice& operator=(const PtyDevice&) = delete;

  /// Path of the port, the same after it has been unplugged and plugged in again.
  const std::string& port() const { return port_; }
  /// Ends the device's thread; its records may be read from then on.
  void halt();
  const std::vector<PtyMoment>& moments() const { return moments_; }
  /// Received lines, without their ends.
  const std::vector<std::string>& heard() const { return heard_; }
  double largestMotor_N() const;
  Witness witness(double max_N) const { return {punctual_, largestMotor_N() > max_N}; }

 protected:
  /// Starts the thread: at the end of a subclass's constructor.
  void begin();
  virtual void hear(const std::string& line) = 0;
  /// A step of the device's own time: the force that its motor is to give.
  virtual double command_N() = 0;
  virtual void reset() = 0;

  /// Sends a line, with its end, after the reply delay; a share of them is damaged on the way.
  void answer(std::string line);
  /// Starts a scene that waits; call once.
  void beginScene();
  double now_s() const { return now_s_; }  ///< since the device was made
  double scene_s() const { return firstLine_s_ < 0 ? -1 : now_s_ - firstLine_s_ - sceneFrom_s_; }
  double truePosition_mm() const { return world_.position_mm(); }
  double trueSpeed_mm_per_s() const { return world_.velocity_mm_per_s(); }

 private:
  struct Waiting {
    double due_s;
    std::string text;
  };
  void run();
  void plug();
  void unplug();
  void events();
  void read();
  void move();
  void watch(double loop_s);

  PtySettings settings_;
  double sceneFrom_s_;  ///< since the first line
  HandleAndFinger world_;
  Chance chance_;
  std::string port_, partial_;
  int master_ = -1;
  double now_s_ = 0, firstLine_s_ = -1, unplugged_s_ = -1, nextMoment_s_ = 0;
  bool resetDone_ = false, unplugDone_ = false, punctual_ = true;
  struct Late {
    double at_s;
    int periods;
  };
  std::deque<Late> late_;               ///< the latest loops and passages that may have cost an answer
  std::array<int, 2> witness_{-1, -1};  ///< here, there: a port of its own
  double sent_s_ = -1;                  ///< since then a byte is on its way through it; < 0: none is
  std::deque<Waiting> waiting_;
  std::vector<PtyMoment> moments_;
  std::vector<std::string> heard_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

/// The first run of up to five that is fine or too strong, else one with a punctual device: a machine that
/// stands still for a moment makes device and program late, which is no verdict on either. Where the device
/// was late in all of them, the run is not judged. A run has a Witness `device`.
template <class Run, class Fine>
auto undisturbed(const Run& runs, const Fine& fine) {
  auto run = runs();
  std::optional<decltype(run)> punctual;
  for (int left = 4; !fine(run) && !run.device.tooStrong; --left) {
    if (run.device.punctual) punctual.emplace(run);
    if (left == 0) {
      if (punctual) return *punctual;
      run.device.judged = false;
      break;
    }
    run = runs();
  }
  return run;
}

}  // namespace detent::test
