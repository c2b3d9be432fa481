#include "importer/strokes/stroke_pair.h"
