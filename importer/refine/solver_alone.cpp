// SPDX-License-Identifier: GPL-3.0-or-later
// Replacements for functions that the solver's libraries refer to and never call here
// (docs/develop/decisions/0206-axes-from-whole-lines.md).
#define UNW_LOCAL_ONLY
#include <libunwind.h>

extern "C" {
// CHOLMOD orders sparse matrices by METIS, of which no static library exists; the problems here are dense. -4
// is METIS_ERROR.
int METIS_NodeND(void*, void*, void*, void*, void*, void*, void*) { return -4; }
int METIS_ComputeVertexSeparator(void*, void*, void*, void*, void*, void*, void*) { return -4; }

// glog prints the stack of a fatal error by libunwind. That library also replaces the compiler's own
// unwinder: in a Python process that has loaded the compiler's, an exception would pass through both and end
// the process. Without libunwind, a fatal error is printed without its stack.
int UNW_OBJ(init_local)(unw_cursor_t*, unw_context_t*) { return -UNW_EUNSPEC; }
int UNW_OBJ(get_reg)(unw_cursor_t*, unw_regnum_t, unw_word_t*) { return -UNW_EUNSPEC; }
int UNW_OBJ(step)(unw_cursor_t*) { return -UNW_EUNSPEC; }
#ifdef __x86_64__  // on other processors it is an inline function
int UNW_ARCH_OBJ(getcontext)(unw_tdep_context_t*) { return -UNW_EUNSPEC; }
#endif
}
