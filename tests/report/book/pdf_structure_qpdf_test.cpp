#include <gmock/gmock.h>

#include <qpdf/qpdf-c.h>

#include <memory>
#include <string>
#include <vector>

#include "app/report/book/print_book.h"
#include "tests/report/book/review_scene.h"

namespace noonmark {
namespace {

using namespace tests;

QByteArray pdfOf(const Book& book) { return printBook(book).value(); }

/// A PDF that is read back. Objects are handles that live as long as it does.
class Pdf {
public:
    explicit Pdf(const QByteArray& bytes) : bytes_(bytes), data_(qpdf_init()) {
        const auto size = static_cast<unsigned long long>(bytes_.size());
        EXPECT_EQ(qpdf_read_memory(data_, "book", bytes_.constData(), size, nullptr), QPDF_SUCCESS);
    }
    Pdf(const Pdf&) = delete;
    Pdf& operator=(const Pdf&) = delete;
    ~Pdf() { qpdf_cleanup(&data_); }

    [[nodiscard]] std::size_t pages() { return static_cast<std::size_t>(qpdf_get_num_pages(data_)); }
    [[nodiscard]] qpdf_oh root() { return qpdf_get_root(data_); }
    [[nodiscard]] qpdf_oh trailer() { return qpdf_get_trailer(data_); }
    [[nodiscard]] qpdf_oh key(qpdf_oh from, const char* name) { return qpdf_oh_get_key(data_, from, name); }
    [[nodiscard]] qpdf_oh item(qpdf_oh array, int i) { return qpdf_oh_get_array_item(data_, array, i); }
    [[nodiscard]] std::string text(qpdf_oh from) { return qpdf_oh_get_utf8_value(data_, from); }

    /// Titles of the bookmarks below an entry, or of the outline's top level.
    [[nodiscard]] std::vector<std::string> titlesBelow(qpdf_oh parent) {
        std::vector<std::string> titles;
        for (qpdf_oh entry = key(parent, "/First"); qpdf_oh_is_dictionary(data_, entry) != QPDF_FALSE;
             entry = key(entry, "/Next"))
            titles.push_back(text(key(entry, "/Title")));
        return titles;
    }

    /// How many fonts are described, and how many of those are embedded.
    [[nodiscard]] std::pair<int, int> countFonts() {
        std::pair<int, int> fonts;
        const int objects = qpdf_oh_get_int_value_as_int(data_, key(trailer(), "/Size"));
        for (int id = 1; id < objects; ++id) {
            const qpdf_oh object = qpdf_get_object_by_id(data_, id, 0);
            if (qpdf_oh_is_dictionary_of_type(data_, object, "/FontDescriptor", "") == QPDF_FALSE) continue;
            ++fonts.first;
            if (has(object, "/FontFile2") || has(object, "/FontFile3")) ++fonts.second;
        }
        return fonts;
    }

private:
    bool has(qpdf_oh from, const char* name) { return qpdf_oh_has_key(data_, from, name) != QPDF_FALSE; }

    QByteArray bytes_;  // the reader refers to them
    qpdf_data data_;
};

TEST(BookPdf, HasOutlineLanguageTitleLabelsAndEmbeddedFonts) {
    BookSettings settings{{Paper::a3, true}, {}, {}};
    settings.titleBlock.sheetPrefix = "A-";
    const Book book = ReviewedPark("Парк Горького").book(settings);
    Pdf pdf(pdfOf(book));
    EXPECT_EQ(pdf.pages(), book.pages.size());
    EXPECT_EQ(pdf.text(pdf.key(pdf.root(), "/Lang")), "en");
    EXPECT_EQ(pdf.text(pdf.key(pdf.key(pdf.trailer(), "/Info"), "/Title")), book.title.toStdString());
    const qpdf_oh labels = pdf.key(pdf.key(pdf.root(), "/PageLabels"), "/Nums");
    EXPECT_EQ(pdf.text(pdf.key(pdf.item(labels, 3), "/P")), "A-2");

    const auto chapters = pdf.titlesBelow(pdf.key(pdf.root(), "/Outlines"));
    ASSERT_FALSE(chapters.empty());
    EXPECT_EQ(chapters.front(), "Summary");
    EXPECT_EQ(chapters.back(), "Method and sources");

    const auto [fonts, embedded] = pdf.countFonts();
    EXPECT_GE(fonts, 2);
    EXPECT_EQ(embedded, fonts);
}

TEST(PdfStructure, NestsBookmarksByLevel) {
    const QByteArray bytes = pdfOf(ReviewedPark().book({}));
    const auto nested = addPdfStructure(
        bytes,
        {{{QStringLiteral("One"), 0, 0}, {QStringLiteral("Über 1"), 1, 1}, {QStringLiteral("Two"), 1, 0}},
         QStringLiteral("de"),
         {}});
    ASSERT_TRUE(nested);
    Pdf pdf(*nested);
    const qpdf_oh outline = pdf.key(pdf.root(), "/Outlines");
    EXPECT_THAT(pdf.titlesBelow(outline), testing::ElementsAre("One", "Two"));
    EXPECT_THAT(pdf.titlesBelow(pdf.key(outline, "/First")), testing::ElementsAre("Über 1"));
    EXPECT_EQ(pdf.text(pdf.key(pdf.root(), "/Lang")), "de");
}

TEST(PdfStructure, RefusesWhatIsNoPdfAndPagesThatAreNotThere) {
    EXPECT_FALSE(addPdfStructure("hello", {}));
    const QByteArray bytes = pdfOf(ReviewedPark().book({}));
    EXPECT_FALSE(addPdfStructure(bytes, {{{QStringLiteral("Far"), 999, 0}}, QStringLiteral("en"), {}}));
}

}  // namespace
}  // namespace noonmark
