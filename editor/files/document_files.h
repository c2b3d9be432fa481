// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Documents in and out: what is opened, what is saved, and under which name.

#include <memory>
#include <QString>

#include "editor/document/button_document.h"

namespace detent::editor {

/// Opens a button file; a CSV of our own header, or a picture with a button inside, as a new, unnamed
/// document. Reads nothing twice and changes no other document. Failures: those of readButtonFile and
/// graphFromCsv, and of inputKindOf; wrongUsage for pages, which go through the import dialogue.
Result<std::unique_ptr<ButtonDocument>> openDocument(const QString& path);

/// A new document of an import: unsaved from the start, because finding it may have cost an hour of work.
std::unique_ptr<ButtonDocument> importedDocument(std::shared_ptr<const importer::ImportReport> report);

/// State of a document's file since it was last read or written here.
enum class DiskState {
  asKnown,
  changed,  ///< somebody else wrote it; writing now would take their work away
  gone      ///< deleted or moved away
};
/// Reads and hashes the whole file; called before every write.
DiskState diskStateOf(const ButtonDocument& document);

/// Writes the committed button atomically; on success the document has this path and is unmodified. On
/// failure file and document are as before.
Result<Done> saveDocument(ButtonDocument& document, const QString& path);

/// Exchanges the button for what the file holds now, as one step that can be undone; unmodified afterwards.
Result<Done> reloadDocument(ButtonDocument& document);

/// "x" and "x.button" become "x.button.json"; a name that ends in ".json" stays.
QString withButtonEnding(const QString& path);

/// A whole button as text for the clipboard: what its file would hold.
QString buttonText(const Button& button);
/// A new, unsaved document from such text; failures as readButtonFile, with `source` as their subject.
Result<std::unique_ptr<ButtonDocument>> documentFromText(const QString& text, const QString& source = {});

/// Path that saving offers for a document without one: its title as a safe file name, in `folder`, with a
/// number if that name is taken.
QString suggestedPath(const ButtonDocument& document, const QString& folder, const QString& ending);

}  // namespace detent::editor
