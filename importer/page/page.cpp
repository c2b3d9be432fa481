#include "importer/page/page.h"
