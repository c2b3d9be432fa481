#include "model/sections.h"
