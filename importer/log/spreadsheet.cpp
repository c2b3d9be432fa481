// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets of xlsx and OpenDocument files as tables.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <type_traits>

#include <dlfcn.h>
#include <pugixml.hpp>
#include <zip.h>

#include "importer/log/table.h"
#include "model/text.h"

namespace detent::importer {
namespace {

constexpr std::size_t kMostUnpacked_bytes = std::size_t{64} << 20;
constexpr std::size_t kMostSheetColumns = 256, kMostSheetRows = std::size_t{1} << 20;
constexpr std::size_t kMostSheets = 64;

/// libzip, loaded when the first spreadsheet is read. Loading it with the program would double the start-up
/// time, because it loads libcrypto.
struct Libzip {
  static const Libzip* get() {
    static const Libzip loaded;
    return loaded.isWhole ? &loaded : nullptr;
  }

  decltype(&zip_source_buffer_create) createSource = nullptr;
  decltype(&zip_source_free) freeSource = nullptr;
  decltype(&zip_open_from_source) open = nullptr;
  decltype(&zip_discard) discard = nullptr;
  decltype(&zip_name_locate) locate = nullptr;
  decltype(&zip_fopen) openMember = nullptr;
  decltype(&zip_fclose) closeMember = nullptr;
  decltype(&zip_fread) read = nullptr;
  bool isWhole = false;

 private:
  Libzip() {
    void* const library = dlopen(DETENT_LIBZIP, RTLD_LAZY | RTLD_LOCAL);  // kept until the program ends
    if (library == nullptr) return;
    const auto find = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
      return function != nullptr;
    };
    isWhole = find(createSource, "zip_source_buffer_create") && find(freeSource, "zip_source_free") &&
              find(open, "zip_open_from_source") && find(discard, "zip_discard") &&
              find(locate, "zip_name_locate") && find(openMember, "zip_fopen") &&
              find(closeMember, "zip_fclose") && find(read, "zip_fread");
  }
};

/// An archive in memory, closed without writing.
class Archive {
 public:
  Archive(const Libzip& libzip, const std::string& bytes) : libzip_(libzip), zip_(nullptr, libzip.discard) {
    zip_source_t* source = libzip_.createSource(bytes.data(), bytes.size(), 0, nullptr);
    if (!source) return;
    zip_.reset(libzip_.open(source, ZIP_RDONLY, nullptr));
    if (!zip_) libzip_.freeSource(source);
  }
  explicit operator bool() const { return zip_ != nullptr; }
  bool has(const std::string& member) const { return libzip_.locate(zip_.get(), member.c_str(), 0) >= 0; }

  /// nullopt if the member is missing, damaged, encrypted, or unpacks to more than the limit, whatever size
  /// the archive states.
  std::optional<std::string> read(const std::string& member) const {
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
        libzip_.openMember(zip_.get(), member.c_str(), 0), libzip_.closeMember);
    if (!file) return {};
    std::string text;
    constexpr std::size_t piece_bytes = std::size_t{1} << 16;
    while (text.size() <= kMostUnpacked_bytes) {
      const std::size_t size = text.size();
      text.resize(size + piece_bytes);
      const zip_int64_t got = libzip_.read(file.get(), text.data() + size, piece_bytes);
      if (got < 0) return {};
      text.resize(size + static_cast<std::size_t>(got));
      if (got == 0) return text;
    }
    return {};
  }

 private:
  const Libzip& libzip_;
  std::unique_ptr<zip_t, void (*)(zip_t*)> zip_;
};

/// pugixml expands only XML's five entities and character references; it skips document types.
std::optional<std::unique_ptr<pugi::xml_document>> xmlOf(const std::optional<std::string>& text) {
  if (!text) return {};
  auto document = std::make_unique<pugi::xml_document>();
  if (!document->load_buffer(text->data(), text->size(), pugi::parse_default | pugi::parse_ws_pcdata))
    return {};
  return document;
}

/// All text below a node; paragraphs and line breaks are separated by a blank.
void appendText(const pugi::xml_node& node, std::string& text, int depth = 0) {
  constexpr std::size_t longestCell_bytes = 2000;
  for (const pugi::xml_node child : node.children()) {
    constexpr int deepest = 32;  // levels; a malicious file could nest nodes without end
    if (text.size() > longestCell_bytes || depth > deepest) return;
    const std::string_view name = child.name();
    if (name == "office:annotation" || name == "rPh") continue;  // a comment, a reading aid
    if ((name == "text:p" && !text.empty()) || name == "text:s" || name == "text:tab" ||
        name == "text:line-break")
      text += ' ';
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
      text += child.value();
    else
      appendText(child, text, depth + 1);
  }
}

/// Collects rows without their empty ends, of which sheets have many.
class SheetRows {
 public:
  explicit SheetRows(Table& table) : table_(table) {}
  void beginRow(long number) { row_ = number, cells_.clear(); }
  void set(std::size_t column, std::string text) {
    if (column >= kMostSheetColumns || text.empty()) return;
    if (cells_.size() <= column) cells_.resize(column + 1);
    cells_[column] = std::move(text);
  }
  bool isFull() const { return table_.rows() >= kMostSheetRows; }
  void endRow() {
    if (isFull()) return;
    table_.beginRow(row_);
    for (std::string& cell : cells_) {
      const std::string& kept = table_.keep(std::move(cell));
      table_.addCell(trimmed(kept));
    }
  }

 private:
  Table& table_;
  long row_ = 0;
  std::vector<std::string> cells_;
};

Table tableOfOds(const pugi::xml_node& sheet) {
  Table table;
  table.name = sheet.attribute("table:name").value();
  SheetRows rows(table);
  long number = 0;
  const auto takeRow = [&](const pugi::xml_node& row) {
    rows.beginRow(number + 1);
    std::size_t column = 0;
    for (const pugi::xml_node cell : row.children()) {
      const std::string_view name = cell.name();
      if (name != "table:table-cell" && name != "table:covered-table-cell") continue;
      std::string text;
      const std::string_view type = cell.attribute("office:value-type").value();
      const std::string_view value = cell.attribute("office:value").value();
      if (!value.empty() && (type.empty() || type == "float" || type == "percentage" || type == "currency"))
        text = value;
      else
        appendText(cell, text);
      const auto repeat = std::clamp<long long>(cell.attribute("table:number-columns-repeated").as_llong(1),
                                                1, static_cast<long long>(kMostSheetColumns));
      for (long long k = 0; k < repeat && column < kMostSheetColumns; ++k) rows.set(column++, text);
    }
    const auto repeat = std::max<long long>(1, row.attribute("table:number-rows-repeated").as_llong(1));
    rows.endRow();  // a repeated row counts as one measurement, a repeated empty one as one gap
    number += static_cast<long>(std::min<long long>(repeat, 1LL << 31));
  };
  const auto visit = [&](const auto& self, const pugi::xml_node& parent, int depth) -> void {
    for (const pugi::xml_node child : parent.children()) {
      const std::string_view name = child.name();
      if (name == "table:table-row")
        takeRow(child);
      else if (name == "table:table-rows" || name == "table:table-header-rows" ||
               name == "table:table-row-group")
        if (depth < 8) self(self, child, depth + 1);
    }
  };
  visit(visit, sheet, 0);
  return table;
}

/// "BC12": column 54.
std::size_t columnOfReference(std::string_view reference) {
  std::size_t column = 0;
  for (const char c : reference) {
    if (c < 'A' || c > 'Z' || column > kMostSheetColumns) break;
    column = column * 26 + static_cast<std::size_t>(c - 'A' + 1);
  }
  return column == 0 ? 0 : column - 1;
}

/// Number of formulas in a sheet that no program has calculated: every result is missing or 0, as XlsxWriter
/// writes it. 0 if a result differs, or if there are so few that the zeros may be real.
std::size_t uncalculatedIn(const pugi::xml_node& worksheet) {
  constexpr std::size_t fewest = 5;
  std::size_t formulas = 0;
  for (const pugi::xml_node row : worksheet.child("sheetData").children("row"))
    for (const pugi::xml_node cell : row.children("c")) {
      if (!cell.child("f")) continue;
      const std::string_view result = cell.child("v").text().get();
      if (!result.empty() && result != "0") return 0;
      ++formulas;
    }
  return formulas < fewest ? 0 : formulas;
}

Table tableOfXlsx(const pugi::xml_node& worksheet, const std::vector<std::string>& shared, std::string name) {
  Table table;
  table.name = std::move(name);
  const bool isUncalculated = uncalculatedIn(worksheet) > 0;
  SheetRows rows(table);
  long number = 0;
  for (const pugi::xml_node row : worksheet.child("sheetData").children("row")) {
    const long given = static_cast<long>(row.attribute("r").as_llong(number + 1));
    if (given > number + 1 && number > 0) rows.beginRow(number + 1), rows.endRow();  // separates the blocks
    number = given;
    rows.beginRow(number);
    std::size_t column = 0;
    for (const pugi::xml_node cell : row.children("c")) {
      const std::string_view reference = cell.attribute("r").value(), type = cell.attribute("t").value();
      if (!reference.empty()) column = columnOfReference(reference);
      std::string text;
      if (type == "s") {
        const auto index = cell.child("v").text().as_llong(-1);
        if (index >= 0 && static_cast<std::size_t>(index) < shared.size())
          text = shared[static_cast<std::size_t>(index)];
      } else if (type == "inlineStr") {
        appendText(cell.child("is"), text);
      } else if (type != "e" && !(isUncalculated && cell.child("f"))) {
        text = cell.child("v").text().get();
      }
      rows.set(column++, std::move(text));
    }
    rows.endRow();
    if (rows.isFull()) break;
  }
  return table;
}

std::vector<std::string> sharedStringsOf(const Archive& archive) {
  std::vector<std::string> shared;
  const auto document = xmlOf(archive.read("xl/sharedStrings.xml"));
  if (!document) return shared;
  for (const pugi::xml_node item : (*document)->child("sst").children("si")) {
    std::string text;
    appendText(item, text);
    shared.push_back(std::move(text));
  }
  return shared;
}

/// Paths of the worksheets in the order of the workbook, with their names.
std::vector<std::pair<std::string, std::string>> worksheetsOf(const Archive& archive) {
  std::vector<std::pair<std::string, std::string>> sheets;
  const auto workbook = xmlOf(archive.read("xl/workbook.xml"));
  const auto relations = xmlOf(archive.read("xl/_rels/workbook.xml.rels"));
  if (workbook && relations) {
    std::map<std::string, std::string> targets;
    for (const pugi::xml_node relation : (*relations)->child("Relationships").children())
      targets[relation.attribute("Id").value()] = relation.attribute("Target").value();
    for (const pugi::xml_node sheet : (*workbook)->child("workbook").child("sheets").children()) {
      std::string target = targets[sheet.attribute("r:id").value()];
      if (target.empty()) continue;
      if (target.front() == '/')
        target.erase(0, 1);
      else
        target.insert(0, "xl/");
      sheets.emplace_back(target, sheet.attribute("name").value());
    }
  }
  if (sheets.empty() && archive.has("xl/worksheets/sheet1.xml"))
    sheets.emplace_back("xl/worksheets/sheet1.xml", "Sheet1");
  if (sheets.size() > kMostSheets) sheets.resize(kMostSheets);
  return sheets;
}

}  // namespace

Result<std::vector<Table>> tablesOfSpreadsheet(const std::string& bytes, const std::string& subject) {
  const auto damaged = [&](Message problem) {
    return unreadableFile(subject, std::move(problem),
                          Message("Save the spreadsheet again, as xlsx, ODS or CSV"));
  };
  const Libzip* const libzip = Libzip::get();
  if (libzip == nullptr)
    return unreadableFile(subject, Message("spreadsheets need the library libzip, which is not installed"),
                          Message("Install it (on Debian: libzip4), or save the sheet as CSV"));
  const Archive archive(*libzip, bytes);
  if (!archive) return damaged(Message("the file is not a spreadsheet, or is damaged"));
  std::vector<Table> tables;
  const auto keep = [&](Table table) {
    if (table.rows() > 0) tables.push_back(std::move(table));
  };
  if (archive.has("content.xml")) {
    const auto document = xmlOf(archive.read("content.xml"));
    if (!document) return damaged(Message("the content is damaged, or larger than 64 MB when unpacked"));
    std::size_t sheets = 0;
    const pugi::xpath_node_set found = (*document)->select_nodes("//table:table");
    for (const pugi::xpath_node& node : found)
      if (sheets++ < kMostSheets) keep(tableOfOds(node.node()));
    return tables;
  }
  const auto worksheets = worksheetsOf(archive);
  if (worksheets.empty()) return damaged(Message("the spreadsheet file has no sheet"));
  const std::vector<std::string> shared = sharedStringsOf(archive);
  for (const auto& [path, name] : worksheets) {
    const auto document = xmlOf(archive.read(path));
    if (!document) return damaged(Message("the content is damaged, or larger than 64 MB when unpacked"));
    keep(tableOfXlsx((*document)->child("worksheet"), shared, name));
  }
  return tables;
}

std::size_t uncalculatedFormulas(const std::string& bytes) {
  const Libzip* const libzip = Libzip::get();
  if (libzip == nullptr) return 0;
  const Archive archive(*libzip, bytes);
  std::size_t formulas = 0;
  if (!archive) return 0;
  for (const auto& [path, name] : worksheetsOf(archive))
    if (const auto document = xmlOf(archive.read(path)))
      formulas += uncalculatedIn((*document)->child("worksheet"));
  return formulas;
}

}  // namespace detent::importer
