// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button as a Frictionless data package (Tabular Data Package 1.0): a description beside CSV tables, each
// column with its unit.

#include <string>
#include <vector>

#include "model/button.h"
#include "model/result.h"

namespace detent {

struct PackageTable {
  std::string file;  ///< name without folder
  std::string csv;
};

struct DataPackage {
  std::string description;           ///< datapackage.json
  std::vector<PackageTable> tables;  ///< described tables: a curve per state, and the key figures
};

/// Deterministic: independent of time and machine. Any thread.
DataPackage dataPackageFrom(const Button& button);

/// Writes `description` (a path that ends in datapackage.json) and its tables; all or none.
Result<Done> writeDataPackage(const Button& button, const std::string& description);

}  // namespace detent
