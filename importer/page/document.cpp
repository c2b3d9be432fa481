// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/document.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <system_error>

#include "importer/page/gunzip.h"
#include "importer/page/page_source.h"
#include "importer/page/picture_header.h"
#include "model/check.h"
#include "model/sha256.h"

namespace detent::importer {

struct Document::Impl {
  SourceFile file;
  std::unique_ptr<PageSource> source;
};

Failure unreadable(const std::string& name, Message place, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, name, std::move(place), std::move(problem), std::move(remedies)};
}

namespace {

std::string megabytes(double bytes) {
  const std::string text = std::to_string(bytes / (1024 * 1024));
  return text.substr(0, text.find('.') + 2) + " MB";
}

std::optional<Failure> tooLarge(const std::string& name, double bytes, const PageLimits& limits) {
  if (bytes <= limits.maxFileMegabytes * 1024 * 1024) return std::nullopt;
  return unreadable(name, "",
                    Message("the file has %1; the limit is %2", megabytes(bytes),
                            megabytes(limits.maxFileMegabytes * 1024 * 1024)),
                    {{RemedyKind::advice, Message("Give a smaller file")}, {RemedyKind::raiseLimit, {}}});
}

Result<Bytes> readFile(const std::string& path, const std::string& name, const PageLimits& limits) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return unreadable(name, "", Message("there is no such file"), Message("Check the path %1", path));
  if (std::filesystem::is_directory(status))
    return unreadable(name, "", Message("this is a folder, not a file"),
                      Message("Choose one of the files in the folder"));
  if (!std::filesystem::is_regular_file(status))
    return unreadable(name, "", Message("this is not an ordinary file"),
                      Message("Save the content to an ordinary file and import that file"));
  std::ifstream in(path, std::ios::binary);
  if (!in)
    return unreadable(name, "", Message("the file cannot be opened"),
                      Message("Check that you may read %1", path));
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error)
    return unreadable(name, "", Message("the file's size cannot be read"),
                      Message("Check that you may read %1", path));
  if (auto failure = tooLarge(name, static_cast<double>(size), limits)) return *failure;
  Bytes bytes(static_cast<std::size_t>(size));
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (in.gcount() != static_cast<std::streamsize>(size))
    return unreadable(name, Message("byte %1", std::to_string(in.gcount())),
                      Message("the file could not be read to its end"),
                      Message("Copy the file to a local disk and import the copy"));
  return bytes;
}

bool isProbablyText(const Bytes& bytes) {
  const std::size_t n = std::min<std::size_t>(bytes.size(), 4096);
  for (std::size_t i = 0; i < n; ++i)
    if (bytes[i] < 9 || (bytes[i] > 13 && bytes[i] < 32 && bytes[i] != 27) || bytes[i] == 127) return false;
  return true;
}

/// Returns true if a file's type contradicts its name. A picture with another picture format's name is
/// accepted, because browsers save such files. A picture named as a document, or the reverse, is refused: the
/// name shows what the sender meant.
bool contradicts(FileKind promised, FileKind actual) {
  if (promised == FileKind::unknown || promised == actual) return false;
  return !(isPicture(promised) && isPicture(actual));
}

std::optional<Failure> wrongKind(const SourceFile& file, FileKind actual) {
  const FileKind promised = kindOfName(file.name);
  if (actual == FileKind::unknown) {
    const Message content = isProbablyText(*file.bytes) ? Message("the content is plain text")
                                                        : Message("the type of the content is not known");
    return unreadable(
        file.name, Message("first bytes"),
        promised == FileKind::unknown
            ? content
            : Message("%1, although the file name says that it is a %2", content, kindName(promised)),
        Message("Give a PNG, JPEG, BMP, TIFF, WebP, GIF, PDF, SVG or CSV file"));
  }
  if (isForeignPicture(actual))
    return unreadable(file.name, Message("first bytes"),
                      Message("the content is a %1, which Detent cannot read", kindName(actual)),
                      Message("Open it in a picture viewer and save it as PNG"));
  if (contradicts(promised, actual))
    return unreadable(
        file.name, Message("first bytes"),
        Message("the content is a %1, although the file name says that it is a %2", kindName(actual),
                kindName(promised)),
        Message("Check that this is the right file, and give it a name that suits its content"));
  return std::nullopt;
}

/// The uncompressed drawing if the file is a compressed one (.svgz); any other file unchanged.
Result<SourceFile> unpacked(const SourceFile& file) {
  const double most_bytes = file.limits.maxFileMegabytes * 1024 * 1024;
  auto content = gunzip(*file.bytes, static_cast<std::size_t>(std::clamp(most_bytes, 0.0, 1e12)));
  if (!content)
    return unreadable(
        file.name, "",
        Message("the packed content is damaged, or larger than the limit of %1", megabytes(most_bytes)),
        {{RemedyKind::advice, Message("Unpack the file and import its content")},
         {RemedyKind::raiseLimit, {}}});
  SourceFile changed = file;
  changed.bytes = std::make_shared<const Bytes>(std::move(*content));
  return changed;
}

OpenedSource openSource(const SourceFile& asGiven) {
  auto plain = isGzip(*asGiven.bytes) ? unpacked(asGiven) : Result<SourceFile>(asGiven);
  if (!plain) return plain.failure();
  const SourceFile& file = *plain;
  if (file.bytes->empty())
    return unreadable(file.name, "", Message("the file is empty (0 bytes)"),
                      Message("Copy or download the file again"));
  const FileKind kind = sniffFileKind(*file.bytes);
  if (auto failure = wrongKind(file, kind)) return *failure;
  if (kind == FileKind::bmp) return openBmpSource(file);
  if (kind == FileKind::pdf) return openPdfSource(file);
  if (kind == FileKind::svg) return openSvgSource(file);
  return openPictureSource(file);
}

Failure outOfMemory(const std::string& name) {
  return unreadable(name, "", Message("there is not enough memory to read the file"),
                    Message("Scale the picture down or crop it to the graph"));
}

bool finite(const Box& box) {
  return std::isfinite(box.x0) && std::isfinite(box.y0) && std::isfinite(box.x1) && std::isfinite(box.y1);
}

}  // namespace

Document::Document(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

Result<Document> Document::open(const std::string& path, const PageLimits& limits) {
  const std::string name = std::filesystem::path(path).filename().string();
  try {
    auto bytes = readFile(path, name.empty() ? path : name, limits);
    if (!bytes) return bytes.failure();
    return fromBytes(std::move(*bytes), name, limits);
  } catch (const std::bad_alloc&) {
    return outOfMemory(name);
  }
}

Result<Document> Document::fromBytes(std::vector<unsigned char> bytes, const std::string& name,
                                     const PageLimits& limits) {
  if (auto failure = tooLarge(name, static_cast<double>(bytes.size()), limits)) return *failure;
  try {
    auto impl = std::make_unique<Impl>(
        Impl{{std::make_shared<const Bytes>(std::move(bytes)), name, limits}, nullptr});
    auto source = openSource(impl->file);
    if (!source) return source.failure();
    impl->source = std::move(source.value());
    return Document(std::move(impl));
  } catch (const std::bad_alloc&) {
    return outOfMemory(name);
  }
}

int Document::pageCount() const { return impl_->source->pageCount(); }

Result<Page> Document::page(int number, const Progress& progress) const {
  if (number < 1 || number > pageCount())
    return Failure{FailureCode::wrongUsage, name(), "", Message("there is no page %1", number),
                   Message("Pages count from 1 to %1", pageCount())};
  try {
    return impl_->source->page(number, progress);
  } catch (const std::bad_alloc&) {
    return outOfMemory(name());
  }
}

Result<PageView> Document::view(const Page& page, const Box& region, int quarterTurns,
                                const ViewOptions& options, const Homography& levelToPage,
                                const Progress& progress) const {
  DETENT_CHECK(levelToPage == Homography{} || page.unit == PageUnit::pixel, "only pictures stand askew");
  DETENT_CHECK(quarterTurns >= 0 && quarterTurns <= 3, "quarter turns are 0 to 3");
  DETENT_CHECK(page.number >= 1 && page.number <= pageCount(),
               "a view is made of a page of its own document");
  if (!finite(region) || region.x1 < region.x0 || region.y1 < region.y0)
    return Failure{FailureCode::wrongUsage, name(), "", Message("the region is not a rectangle"),
                   Message("Give left, top, right, bottom")};
  try {
    return impl_->source->view(page, region, quarterTurns, options, levelToPage, progress);
  } catch (const std::bad_alloc&) {
    return outOfMemory(name());
  }
}

const std::string& Document::name() const { return impl_->file.name; }

std::string Document::sha256() const { return sha256Hex(*impl_->file.bytes); }

}  // namespace detent::importer
