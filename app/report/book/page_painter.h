#pragma once

#include "app/report/book/book.h"

namespace noonmark {

/// Paints page `index` of a book with its top left corner at the painter's origin, for print or as a picture:
/// the same lines break at the same words at every size. `canvas.point`: painter units per point of paper.
void paintPage(const Book& book, std::size_t index, const Canvas& canvas);

/// A page as a picture, at so many dots per inch of paper: for previews.
QImage makePagePicture(const Book& book, std::size_t index, double dotsPerInch);

}  // namespace noonmark
