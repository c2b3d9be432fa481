// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public interface of the library: thousands of measured switches in one file, searchable by feel. Separate
// from importer/importer.h, so that programs that only import need no database. Empty in builds without
// DETENT_WITH_LIBRARY.

#include "importer/library/feel_map.h"
#include "importer/library/felt_shape.h"
#include "importer/library/find_switches.h"
#include "importer/library/index_folders.h"
#include "importer/library/origin.h"
#include "importer/library/read_switches.h"
#include "importer/library/report_page.h"
#include "importer/library/wanted_button.h"
