#pragma once

#include "app/report/book/book.h"
#include "tests/report/book/recorded_page.h"

namespace noonmark::tests {

/// The texts of a page as they are painted, in units of MeasuringCanvas.
std::vector<PaintedText> textsOfPage(const Book& book, std::size_t index);
/// Texts that lie over each other on a page: "first / second". Empty of a page that can be read.
std::vector<std::string> listMeetings(const std::vector<PaintedText>& texts);
/// All of them, with single spaces.
QString textOfPage(const Book& book, std::size_t index);

}  // namespace noonmark::tests
