#include "importer/fit/fit_stroke.h"
