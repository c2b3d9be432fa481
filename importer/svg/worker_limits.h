// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Limits and restrictions of the worker process. Linux.

namespace detent::importer::svg {

struct WorkerLimits {
  int processor_s = 5;
  int memory_MB = 1024;
  int output_MB = 256;
};

/// Bounds processor time, address space and output; the process ends with its parent.
void limitResources(const WorkerLimits& limits);

/// From now on opening a file by name, making a socket and starting a program fail. Libraries must have read
/// their own files before. A restriction that the kernel does not know is skipped.
void closeTheWorld();

}  // namespace detent::importer::svg
