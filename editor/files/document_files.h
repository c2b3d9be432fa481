// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Opens and saves documents, and finds names for them.

#include <memory>
#include <QString>

#include "editor/document/button_document.h"

namespace detent::editor {

/// Opens a button file; a CSV of our own header, or a picture with a button inside, as a new, unnamed
/// document. Reads nothing twice and changes no other document. Failures: those of readButtonFile and
/// graphFromCsv, and of inputKindOf; wrongUsage for pages, which go through the import dialogue.
Result<std::unique_ptr<ButtonDocument>> openDocument(const QString& path);

/// A new document of an import. It is unsaved from the start, because the corrections may have cost an hour
/// of work.
std::unique_ptr<ButtonDocument> importedDocument(std::shared_ptr<const importer::ImportReport> report);

/// State of a document's file since it was last read or written here.
enum class DiskState {
  asKnown,
  changed,  ///< another program has written it; writing now would overwrite that work
  gone      ///< deleted or moved away
};
/// Reads and hashes the whole file; called before every write.
DiskState diskStateOf(const ButtonDocument& document);

/// Writes the committed button atomically; on success the document has this path and is unmodified. On
/// failure file and document are as before.
Result<Done> saveDocument(ButtonDocument& document, const QString& path);

/// Replaces the button by the present contents of the file, in one undoable step; the document is unmodified
/// afterwards.
Result<Done> reloadDocument(ButtonDocument& document);

/// "x" and "x.button" become "x.button.json"; a name that ends in ".json" stays.
QString withButtonEnding(const QString& path);

/// A whole button as text for the clipboard: the text of its file.
QString buttonText(const Button& button);
/// A new, unsaved document from such text; failures as readButtonFile, with `source` as their subject.
Result<std::unique_ptr<ButtonDocument>> documentFromText(const QString& text, const QString& source = {});

/// Path that saving offers for a document without one: its title as a safe file name, in `folder`, with a
/// number if that name is taken.
QString suggestedPath(const ButtonDocument& document, const QString& folder, const QString& ending);

}  // namespace detent::editor
