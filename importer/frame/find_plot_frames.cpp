#include "importer/frame/plot_frame.h"
