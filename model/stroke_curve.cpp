#include "model/stroke_curve.h"
