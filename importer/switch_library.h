// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Front door of the library: thousands of measured switches in one file, found by feel. Apart from
// importer/importer.h, so that who only imports carries no database. A library built without
// DETENT_WITH_LIBRARY has none of it.

#include "importer/library/feel_map.h"
#include "importer/library/find_switches.h"
#include "importer/library/index_folders.h"
#include "importer/library/origin.h"
#include "importer/library/read_switches.h"
#include "importer/library/report_page.h"
