// SPDX-License-Identifier: GPL-3.0-or-later
// The Falcon's kinematics, packets and firmware files; its USB side is in falcon_usb_test.cpp.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <catch2/catch.hpp>

#include "playback/device/falcon_kinematics.h"
#include "playback/device/falcon_protocol.h"

namespace {

using namespace detent;
using namespace detent::playback;

/// Places all over the handle's reach.
template <class Each>
void overTheReach(int count, Each each) {
  std::mt19937 random(20131008);
  std::uniform_real_distribution<> across_mm(-35, 35), depth_mm(85, 165);
  for (int i = 0; i < count; ++i)
    each(FalconPlace_mm{across_mm(random), across_mm(random), depth_mm(random)});
}

double distance(const FalconPlace_mm& a, const FalconPlace_mm& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// libnifalcon's closed form (FalconKinematicStamper::IK), by the tangent of half the angle.
double nifalconAngle(double u, double v, double w) {
  constexpr double a = 60, b = 102.5, c = 14.43, d = 11.25, e = 11.25, f = -25;
  const double s3 = std::sin(std::acos((v + f) / b));
  const double common = w * w + u * u + 2 * c * u + a * a + c * c - d * d - e * e - b * b * s3 * s3 -
                        2 * b * e * s3 - 2 * b * d * s3 - 2 * d * e;
  const double l0 = common - 2 * a * u - 2 * a * c, l1 = -4 * a * w, l2 = common + 2 * a * u + 2 * a * c;
  return 2 * std::atan((-l1 - std::sqrt(l1 * l1 - 4 * l0 * l2)) / (2 * l2));
}

}  // namespace

TEST_CASE("Falcon kinematics: the inverse is libnifalcon's closed form") {
  overTheReach(500, [](const FalconPlace_mm& p) {
    const auto angles = falconAngles_rad(p);
    REQUIRE(angles);
    for (std::size_t i = 0; i < 3; ++i) {
      const double turns[] = {105, -15, -135}, phi = turns[i] * 3.14159265358979323846 / 180;
      const double u = std::cos(phi) * p[0] + std::sin(phi) * p[1] - 40,
                   v = -std::sin(phi) * p[0] + std::cos(phi) * p[1] + 23.09;
      CHECK((*angles)[i] == Approx(nifalconAngle(u, v, p[2])).margin(1e-12));
    }
  });
}

TEST_CASE("Falcon kinematics: forward and inverse agree to a nanometre, from far away too") {
  double worst_mm = 0;
  overTheReach(20000, [&](const FalconPlace_mm& p) {
    const auto angles = falconAngles_rad(p);
    REQUIRE(angles);
    const auto back = falconPlace_mm(*angles, {0, 0, 140});
    REQUIRE(back);
    worst_mm = std::max(worst_mm, distance(p, *back));
  });
  CHECK(worst_mm < 1e-6);
}

TEST_CASE("Falcon kinematics: torques do the work of the force") {
  std::mt19937 random(7);
  std::normal_distribution<> any(0, 3);
  overTheReach(500, [&](const FalconPlace_mm& p) {
    const std::array<double, 3> force_N{any(random), any(random), any(random)};
    const auto torques_Nm = falconTorques_Nm(p, force_N);
    REQUIRE(torques_Nm);
    const auto angles = falconAngles_rad(p);
    for (std::size_t k = 0; k < 3; ++k) {  // a small move along each axis
      constexpr double way_mm = 1e-4;
      FalconPlace_mm moved = p;
      moved[k] += way_mm;
      const auto there = falconAngles_rad(moved);
      double work_mJ = 0;
      for (std::size_t i = 0; i < 3; ++i) work_mJ += 1000 * (*torques_Nm)[i] * ((*there)[i] - (*angles)[i]);
      CHECK(work_mJ == Approx(force_N[k] * way_mm).margin(1e-6 * way_mm * 10 + 1e-8));
    }
  });
}

TEST_CASE("Falcon kinematics: out of reach, and not a number, is reported") {
  for (const FalconPlace_mm& p :
       {FalconPlace_mm{0, 0, 300}, {200, 0, 120}, {std::nan(""), 0, 120}, {0, 0, INFINITY}}) {
    CHECK_FALSE(falconAngles_rad(p));
    CHECK_FALSE(falconTorques_Nm(p, {0, 0, 1}));
  }
  CHECK_FALSE(falconPlace_mm({std::nan(""), 0, 0}, {0, 0, 140}));
  CHECK_FALSE(falconPlace_mm({2.5, -2.5, 2.5}, {0, 0, 140}));
  // One count moves the handle by about 38 um at the knee.
  CHECK(60 * (falconAngle_rad(1) - falconAngle_rad(0)) == Approx(0.038).epsilon(0.01));
  CHECK(falconAngle_rad(0) == Approx(0.6108652).epsilon(1e-6));
}

TEST_CASE("Falcon packets: there and back, and what is none is counted") {
  FalconCommand command;
  command.motors = {0, -1, 4095};
  command.light = FalconLight::red;
  command.homing = true;
  const FalconPacket packet = falconPacket(command);
  CHECK(std::string(packet.begin(), packet.end()) == "<AAAAPPPPPPPAJA>");
  FalconAnswers answers;
  const auto answerTo = [&](const std::string& bytes) {
    std::optional<FalconAnswer> last;
    for (const char c : bytes) {
      if (const auto answer = answers.take(static_cast<std::uint8_t>(c))) last = answer;
    }
    return last;
  };
  const auto good = answerTo(std::string("<AAAAPPPPPPPA") + static_cast<char>('A' + 0x70) + "A>");
  REQUIRE(good);
  CHECK(good->counts == std::array<int, 3>{0, -1, 4095});
  CHECK(good->homed);
  CHECK_FALSE(answerTo("<AAAAPPPPPPPAqA>")->homed);
  CHECK(answers.malformed() == 0);
  CHECK_FALSE(answerTo("AAAA>>A"));
  CHECK(answers.malformed() == 0);
  CHECK_FALSE(answerTo("<AAAAPPPPPP>"));
  CHECK_FALSE(answerTo("<AAAAPzPPPPPAqA>"));
  CHECK_FALSE(answerTo("<AAAAPPPPPPPAqAAAAAAAAAAAAAAAAAAA"));
  CHECK(answers.malformed() == 3);
  CHECK(answerTo("<AAAA<AAAAPPPPPPPAqA>"));  // the second half of a broken packet is a good one
  CHECK(answers.malformed() == 4);
}

TEST_CASE("Falcon firmware: a file that is none is refused with a sentence") {
  std::vector<std::uint8_t> image{0xaa, 0x08};
  image.resize(22, 0);
  for (const int byte : {2, 0, 0x3f, 0, 2, 0x80, 1, 2, 3, 4, 0, 0})
    image.push_back(static_cast<std::uint8_t>(byte));
  CHECK(isFalconFirmware(image));
  std::vector<std::uint8_t> longer = image, shorter = image, other = image;
  longer.push_back(0);
  shorter.pop_back();
  other[0] = 0xab;
  for (const auto& wrong : {longer, shorter, other, std::vector<std::uint8_t>{}})
    CHECK_FALSE(isFalconFirmware(wrong));

  const auto folder = std::filesystem::temp_directory_path() / "detent-falcon-test";
  std::filesystem::create_directories(folder);
  const auto file = [&](const char* name, const std::vector<std::uint8_t>& bytes) {
    const std::string path = (folder / name).string();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
  };
  CHECK(*readFalconFirmware(file("good.bin", image)) == image);
  auto refused = readFalconFirmware(file("short.bin", shorter));
  REQUIRE_FALSE(refused);
  CHECK(english(refused.failure().problem).starts_with("the file is not Falcon firmware"));
  CHECK_FALSE(readFalconFirmware(file("huge.bin", std::vector<std::uint8_t>(1 << 19, 0))));
  CHECK_FALSE(readFalconFirmware((folder / "missing.bin").string()));
  CHECK_FALSE(readFalconFirmware(folder.string()));
  std::filesystem::remove_all(folder);
}
