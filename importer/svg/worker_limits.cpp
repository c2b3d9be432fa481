// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/worker_limits.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace detent::importer::svg {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t ownArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t ownArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t ownArchitecture = 0;  // unknown processor: no filter is installed
#endif

// AddressSanitizer reserves terabytes of address space.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool addressSpaceIsUsed = false;
#elif defined(__has_feature)
constexpr bool addressSpaceIsUsed = !__has_feature(address_sanitizer);
#else
constexpr bool addressSpaceIsUsed = true;
#endif

void setLimit(decltype(RLIMIT_CPU) what, rlim_t value) {
  const rlimit limit{value, value};
  setrlimit(what, &limit);
}

/// A Landlock ruleset without rules: every opening of a file by name is refused.
void refuseFiles() {
  landlock_ruleset_attr handled{};
  handled.handled_access_fs =
      LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
      LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
      LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
      LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
      LANDLOCK_ACCESS_FS_MAKE_SYM;
  const long rules = syscall(SYS_landlock_create_ruleset, &handled, sizeof handled.handled_access_fs, 0);
  if (rules < 0) return;
  syscall(SYS_landlock_restrict_self, rules, 0);
  close(static_cast<int>(rules));
}

/// A filter under which the calls below fail with EPERM and all others are allowed.
void refuseCalls() {
  constexpr std::array refused{SYS_socket,
                               SYS_socketpair,
                               SYS_connect,
                               SYS_bind,
                               SYS_execve,
                               SYS_execveat,
                               SYS_kill,
                               SYS_ptrace,
                               SYS_process_vm_readv,
                               SYS_process_vm_writev,
                               SYS_bpf,
                               SYS_io_uring_setup,
                               SYS_perf_event_open,
                               SYS_mount,
                               SYS_unshare};
  std::array<sock_filter, refused.size() + 6> program{};
  std::size_t at = 0;
  const auto add = [&](int code, std::uint32_t value, std::size_t ifTrue, std::size_t ifFalse) {
    program[at++] = {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(ifTrue),
                     static_cast<std::uint8_t>(ifFalse), value};
  };
  add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch), 0, 0);
  add(BPF_JMP | BPF_JEQ | BPF_K, ownArchitecture, 1, 0);
  add(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS, 0, 0);
  add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr), 0, 0);
  for (std::size_t i = 0; i < refused.size(); ++i)
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(refused[i]), refused.size() - i, 0);
  add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW, 0, 0);
  add(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM, 0, 0);
  sock_fprog filter{static_cast<unsigned short>(at), program.data()};
  syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter);
}

}  // namespace

void limitResources(const WorkerLimits& limits) {
  constexpr rlim_t megabyte = 1u << 20;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setLimit(RLIMIT_CPU, static_cast<rlim_t>(limits.processor_s));
  setLimit(RLIMIT_FSIZE, static_cast<rlim_t>(limits.output_MB) * megabyte);
  setLimit(RLIMIT_CORE, 0);
  if (addressSpaceIsUsed) setLimit(RLIMIT_AS, static_cast<rlim_t>(limits.memory_MB) * megabyte);
}

void closeTheWorld() {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  refuseFiles();
  if (ownArchitecture != 0) refuseCalls();
}

}  // namespace detent::importer::svg
