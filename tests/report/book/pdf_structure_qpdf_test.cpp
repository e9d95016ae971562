#include <gmock/gmock.h>

#include <QBuffer>

// See app/report/book/pdf_structure_qpdf.cpp.
#define POINTERHOLDER_TRANSITION 4
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFOutlineDocumentHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>

#include "app/report/book/pdf_structure.h"
#include "app/report/book/write_book.h"
#include "tests/report/book/review_scene.h"

namespace noonmark {
namespace {

using namespace tests;

QByteArray pdfOf(const Book& book) {
    QBuffer device;
    device.open(QIODevice::WriteOnly);
    EXPECT_TRUE(writeBook(book, device));
    return device.data();
}

TEST(BookPdf, HasOutlineLanguageTitleLabelsAndEmbeddedFonts) {
    BookSettings settings{{Paper::a3, true}, {}, {}};
    settings.titleBlock.sheetPrefix = "A-";
    const Book book = ReviewedPark("Парк Горького").book(settings);
    const QByteArray bytes = pdfOf(book);
    QPDF pdf;
    pdf.processMemoryFile("book", bytes.constData(), std::size_t(bytes.size()));
    EXPECT_EQ(pdf.getAllPages().size(), book.pages.size());
    QPDFObjectHandle root = pdf.getRoot();
    EXPECT_EQ(root.getKey("/Lang").getUTF8Value(), "en");
    EXPECT_EQ(pdf.getTrailer().getKey("/Info").getKey("/Title").getUTF8Value(), book.title.toStdString());
    EXPECT_EQ(root.getKey("/PageLabels").getKey("/Nums").getArrayItem(3).getKey("/P").getUTF8Value(), "A-2");

    QPDFOutlineDocumentHelper outlines(pdf);
    std::vector<std::string> chapters;
    for (auto& entry : outlines.getTopLevelOutlines()) chapters.push_back(entry.getTitle());
    ASSERT_FALSE(chapters.empty());
    EXPECT_EQ(chapters.front(), "Summary");
    EXPECT_EQ(chapters.back(), "Method and sources");

    int fonts = 0;
    for (QPDFObjectHandle object : pdf.getAllObjects())
        if (object.isDictionaryOfType("/FontDescriptor")) {
            ++fonts;
            EXPECT_TRUE(object.hasKey("/FontFile2") || object.hasKey("/FontFile3"));
        }
    EXPECT_GE(fonts, 2);
}

TEST(PdfStructure, NestsBookmarksByLevel) {
    const QByteArray bytes = pdfOf(ReviewedPark().book({}));
    const auto nested = addPdfStructure(
        bytes,
        {{{QStringLiteral("One"), 0, 0}, {QStringLiteral("Über 1"), 1, 1}, {QStringLiteral("Two"), 1, 0}},
         QStringLiteral("de"),
         {}});
    ASSERT_TRUE(nested);
    QPDF pdf;
    pdf.processMemoryFile("book", nested->constData(), std::size_t(nested->size()));
    QPDFOutlineDocumentHelper outlines(pdf);
    auto top = outlines.getTopLevelOutlines();
    ASSERT_EQ(top.size(), 2U);
    ASSERT_EQ(top[0].getKids().size(), 1U);
    EXPECT_EQ(top[0].getKids()[0].getTitle(), "Über 1");
    EXPECT_EQ(pdf.getRoot().getKey("/Lang").getUTF8Value(), "de");
}

TEST(PdfStructure, RefusesWhatIsNoPdfAndPagesThatAreNotThere) {
    EXPECT_FALSE(addPdfStructure("hello", {}));
    const QByteArray bytes = pdfOf(ReviewedPark().book({}));
    EXPECT_FALSE(addPdfStructure(bytes, {{{QStringLiteral("Far"), 999, 0}}, QStringLiteral("en"), {}}));
}

}  // namespace
}  // namespace noonmark
