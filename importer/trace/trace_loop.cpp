#include "importer/trace/trace_loop.h"
