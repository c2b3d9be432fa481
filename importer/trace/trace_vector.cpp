#include "importer/trace/trace_vector.h"
