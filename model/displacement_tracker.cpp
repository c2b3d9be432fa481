#include "model/displacement_tracker.h"
