// SPDX-License-Identifier: GPL-3.0-or-later
// Stand-ins for functions that the solver's archives name and never need here
// (docs/develop/decisions/0206-axes-from-whole-lines.md).
#define UNW_LOCAL_ONLY
#include <libunwind.h>

extern "C" {
// CHOLMOD orders sparse matrices by METIS, which has no archive; the problems here are dense. -4 is
// METIS_ERROR.
int METIS_NodeND(void*, void*, void*, void*, void*, void*, void*) { return -4; }
int METIS_ComputeVertexSeparator(void*, void*, void*, void*, void*, void*, void*) { return -4; }

// glog prints the stack of a fatal error by libunwind. That library also replaces the compiler's own
// unwinder: in a Python that has loaded the latter, an exception would pass through both and end the process.
// Without it a fatal error is printed without its stack.
int UNW_OBJ(init_local)(unw_cursor_t*, unw_context_t*) { return -UNW_EUNSPEC; }
int UNW_OBJ(get_reg)(unw_cursor_t*, unw_regnum_t, unw_word_t*) { return -UNW_EUNSPEC; }
int UNW_OBJ(step)(unw_cursor_t*) { return -UNW_EUNSPEC; }
#ifdef __x86_64__  // elsewhere it is inline
int UNW_ARCH_OBJ(getcontext)(unw_tdep_context_t*) { return -UNW_EUNSPEC; }
#endif
}
