#pragma once

#include <QByteArray>

#include "app/report/book/book.h"
#include "core/base/result.h"

namespace noonmark {

/// The bytes of a book as a PDF: text that can be selected, fonts embedded, title, language, bookmarks and
/// page labels. Needs a QGuiApplication (the `offscreen` platform suffices). Error: the book has no pages.
Result<QByteArray> printBook(const Book& book);

}  // namespace noonmark
