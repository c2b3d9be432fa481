#include "importer/importer.h"
