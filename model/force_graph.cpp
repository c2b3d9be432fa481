#include "model/force_graph.h"
