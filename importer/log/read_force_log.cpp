#include "importer/log/force_log.h"
