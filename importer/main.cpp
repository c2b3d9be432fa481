// SPDX-License-Identifier: GPL-3.0-or-later
// detent-import: from a plot, a datasheet page or a force meter's log to a button. Parses the command line,
// calls the importer's public interface, prints the result.

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>

#include "importer/program/arguments.h"
#include "importer/program/library_program.h"
#include "importer/program/run.h"

namespace {

std::atomic<bool> interrupted{false};

void onInterrupt(int) { interrupted = true; }

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  try {
    if (detent::importer::isLibraryCommand(argc, argv))
      return detent::importer::runLibrary(argc, argv, [] { return interrupted.load(); });
    const auto parsed = detent::importer::parseArguments(argc, argv, std::cout, std::cerr);
    if (!parsed.arguments) return parsed.exitCode;
    return detent::importer::run(*parsed.arguments, [] { return interrupted.load(); });
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "detent-import: internal fault: %s. Please report it with the input file.\n",
                 fault.what());
    return 1;
  }
}
