#include "importer/trace/curve_trace.h"
