#include "importer/axes/axis_calibration.h"
