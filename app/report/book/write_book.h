#pragma once

#include <QIODevice>

#include "app/report/book/book.h"
#include "core/base/result.h"

namespace noonmark {

/// Writes a book as a PDF: text that can be selected, fonts embedded, title, language, bookmarks and page
/// labels. Needs a QGuiApplication (the `offscreen` platform suffices). Error: the book has no pages, or the
/// device does not take it.
Result<void> writeBook(const Book& book, QIODevice& device);

}  // namespace noonmark
