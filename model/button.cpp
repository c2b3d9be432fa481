#include "model/button.h"
