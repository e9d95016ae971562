#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "app/report/book/flow.h"
#include "app/report/book/print_book.h"
#include "app/report/maps/answer_legends.h"
#include "core/engines/auto_engine.h"
#include "tests/report/book/book_texts.h"
#include "tests/report/book/review_scene.h"

namespace noonmark {
namespace {

using namespace tests;

constexpr double unit = MeasuringCanvas::unitsPerPoint;

QRectF inUnits(const QRectF& area) { return {area.topLeft() * unit, area.size() * unit}; }

/// Every text lies within the frame, is not cut by a clip, and lies over no other text.
void expectNothingCutOff(const Book& book) {
    const QRectF frame = inUnits(frameArea(book.setup)).adjusted(-1, -1, 1, 1);
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
        const std::vector<PaintedText> texts = textsOfPage(book, i);
        ASSERT_FALSE(texts.empty());
        EXPECT_THAT(listMeetings(texts), testing::IsEmpty()) << "page " << i;
        for (const PaintedText& text : texts) {
            if (text.box.width() <= 0) continue;  // marks without ink
            EXPECT_TRUE(frame.contains(text.box))
                << "page " << i << ": " << text.text.toStdString() << " at " << text.box.left() / unit << ","
                << text.box.top() / unit << " size " << text.box.width() / unit << " in a frame of "
                << frame.width() / unit;
            EXPECT_FALSE(text.isClipped) << "page " << i << ": " << text.text.toStdString();
        }
        for (const PageItem& item : book.pages[i].items)
            EXPECT_TRUE(inUnits(contentArea(book.setup)).adjusted(-1, -1, 1, 1).contains(inUnits(item.area)))
                << "page " << i;
    }
}

QString textOf(const Book& book) {
    QString all;
    for (std::size_t i = 0; i < book.pages.size(); ++i) all += textOfPage(book, i) + u' ';
    return all.simplified();
}

const std::string longName = "The Honourable Society's Memorial Garden and Playground of Saint-Michel";
const std::string wideName = "WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW";
const std::string greekName = "Πλατεία Συντάγματος και Εθνικός Κήπος, Αθήνα, Ελληνική Δημοκρατία";
const std::string chineseName = "人民公园中央草坪与儿童游乐场以及学校操场的日照分析区域第一号";
const std::string arabicName = "حديقة الأزهر الكبرى في القاهرة";
const std::string hostileName = "a\nb\tc \x01 \xE2\x80\xAE evil <b>&amp; %1 %s \\ 100 %";

TEST(Book, TextsThatLieOverEachOtherAreFound) {
    const auto meetings = [](double secondLeft, double secondTop) {
        RecordedPage page(QSize(2000, 1000));
        QPainter painter(&page);
        painter.setFont(textFont({painter, unit}, 8));
        painter.drawText(QPointF(100, 500), QStringLiteral("Elm Park"));
        painter.drawText(QPointF(secondLeft, secondTop), QStringLiteral("62 m"));
        painter.end();
        return listMeetings(page.texts());
    };
    EXPECT_EQ(meetings(150, 510).size(), 1U);
    EXPECT_EQ(meetings(150, 500 + 10 * unit).size(), 0U) << "the next line";
    EXPECT_EQ(meetings(1200, 500).size(), 0U);
}

TEST(Paper, HasTheSizesOfItsNames) {
    const auto mm = [](double points) { return points * 25.4 / 72; };
    EXPECT_NEAR(mm(sizePt({Paper::a4, false}).width()), 210, 0.3);
    EXPECT_NEAR(mm(sizePt({Paper::a3, true}).width()), 420, 0.3);
    EXPECT_NEAR(mm(sizePt({Paper::a1, false}).height()), 841, 0.3);
    EXPECT_NEAR(sizePt({Paper::letter, false}).width(), 8.5 * 72, 0.1);
    EXPECT_NEAR(sizePt({Paper::tabloid, true}).width(), 17 * 72, 0.1);
    EXPECT_EQ(parsePaper("tabloid"), Paper::tabloid);
    EXPECT_EQ(parsePaper("A0"), std::nullopt);
}

TEST(Paper, AMetreAtOneTo2000IsHalfAMillimetre) {
    EXPECT_NEAR(pointsPerMetre(2000) * 25.4 / 72, 0.5, 1e-12);
    EXPECT_NEAR(pointsPerMetre(500) * 25.4 / 72, 2, 1e-12);
}

TEST(PlainText, HasOneLineAndOneDirection) {
    EXPECT_EQ(plainText(std::string_view("a\nb\tc")), QStringLiteral("a b c"));
    EXPECT_EQ(plainText(std::string_view("x\xE2\x80\xAE\x01y")), QStringLiteral("x y"));
    EXPECT_EQ(plainText(std::string_view("\xE4\xBA\xBA")), QString(QChar(0x4eba)));
}

TEST(Book, NothingIsCutOffOnAnyPaper) {
    const ReviewedPark park(longName);
    for (const Paper paper : papers)
        for (const bool landscape : {false, true}) {
            SCOPED_TRACE(std::string(nameOf(paper)) + (landscape ? " landscape" : " portrait"));
            BookSettings settings{{paper, landscape}, {}, {}};
            settings.titleBlock = {longName, longName, longName, "a long day in the month of November",
                                   "SHADOW-STUDY-"};
            expectNothingCutOff(park.book(settings));
        }
}

TEST(Book, NothingIsCutOffWhateverTheNames) {
    for (const std::string& name : {wideName, greekName, chineseName, arabicName, hostileName}) {
        SCOPED_TRACE(name);
        BookSettings settings;
        settings.titleBlock = {name, name, name, name, name.substr(0, 12)};
        expectNothingCutOff(ReviewedPark(name, name).book(settings));
    }
}

TEST(Book, KeepsNamesWholeAndStatesWhatWasReviewed) {
    BookSettings settings{{Paper::a3, true}, 1000, {}};
    settings.titleBlock = {"Proj-7", "Ada", "Board", "1 May 2026", "A-"};
    const QString text = textOf(ReviewedPark("Elm Park").book(settings));
    for (const char* part :
         {"Elm Park", "Proj-7", "Ada", "Board", "1 May 2026", "A-1", "sheet 1 of", "1:1000",
          "21 March 2026, 10:00", "21 June 2026, 14:00", "azimuth", "incremental shadow", "Not checked",
          "Method", "How to repeat this result", "Tower compared with Existing"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part;
}

TEST(Book, HasAPageOfEachKindInOrderWithBookmarks) {
    BookSettings settings;
    settings.allPages = true;
    const Book book = ReviewedPark().book(settings);
    std::vector<std::string> chapters;
    for (const BookPage& page : book.pages)
        if (!page.bookmark.isEmpty() && page.level == 0)
            chapters.push_back(page.bookmark.section(u':', 0, 0).toStdString());
    EXPECT_THAT(chapters,
                testing::ElementsAre("Summary", "Shadow diagrams", "Shadow fans", "Views from the sun",
                                     "Timelines of places", "Method and sources"))
        << "the summary has room for the tables";
    EXPECT_TRUE(textOfPage(book, 0).contains(QStringLiteral("Table of the rule")));
    EXPECT_EQ(sheetNumber(book, 2), QStringLiteral("3"));
}

TEST(Book, FansComeFirstWhereTheRuleListsThemFirst) {
    ReviewedPark park;
    park.study.rule.deliverables.diagrams->views = {"fan", "plan"};
    std::vector<std::string> chapters;
    for (const BookPage& page : park.book({{Paper::a4, false}, {}, {}}).pages)
        if (!page.bookmark.isEmpty() && page.level == 0)
            chapters.push_back(page.bookmark.section(u':', 0, 0).toStdString());
    ASSERT_GE(chapters.size(), 3U);
    EXPECT_EQ(chapters[1], "Shadow fans");
    EXPECT_EQ(chapters[2], "Shadow diagrams");
}

TEST(Book, DiagramsHaveTheStatedScaleOnPaper) {
    const Book book = ReviewedPark().book({{Paper::a3, true}, 500, {}});
    std::size_t diagrams = 0;
    for (const BookPage& page : book.pages)
        for (const PageItem& item : page.items)
            if (const auto* diagram = std::get_if<Diagram>(&item.content);
                diagram && diagram->fan.empty() && page.title == QStringLiteral("Shadow diagrams")) {
                ++diagrams;
                EXPECT_EQ(diagram->scale, 500);
            }
    EXPECT_EQ(diagrams, 4U) << "two days of two hours";
}

TEST(Book, NoDiagramIsAloneOnAPageBesideFullOnes) {
    for (std::size_t hours = 1; hours <= 6; ++hours) {
        ReviewedPark park;
        auto& times = park.study.rule.deliverables.diagrams->timesMin;
        times.clear();
        for (std::size_t i = 0; i < hours; ++i) times.push_back(600 + 45 * double(i));
        std::vector<std::size_t> onPages;
        for (const BookPage& page : park.book({{Paper::a3, true}, 500, {}}).pages) {
            const auto count = std::size_t(std::ranges::count_if(page.items, [](const PageItem& item) {
                return std::holds_alternative<Diagram>(item.content);
            }));
            if (page.title == QStringLiteral("Shadow diagrams")) onPages.push_back(count);
        }
        EXPECT_EQ(std::accumulate(onPages.begin(), onPages.end(), std::size_t(0)), 2 * hours);
        EXPECT_LE(std::ranges::max(onPages) - std::ranges::min(onPages), 1U) << hours << " times on two days";
    }
}

TEST(Book, AMetreOfTheMapIsPaintedAtTheScale) {
    // A box of 100 m at 1:1000 is 100 mm wide on paper: at 254 dots per inch, 1000 dots.
    auto scene = std::make_shared<DiagramScene>();
    Diagram diagram{scene, {}, {}, {}, {0, 0}, 1000, {}, 1};
    diagram.shadows.incremental = {boxFootprint(-50, -20, 50, 20)};
    QImage image(1400, 900, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintDiagram({painter, 254.0 / 72}, QRectF(0, 0, 1400, 900), diagram);
    painter.end();
    const auto isShadow = [&](int x, int y) { return image.pixelColor(x, y) == shade::incremental; };
    int wide = 0, high = 0;
    const int middle = int((900 - captionPt(1) * 254 / 72) / 2);
    for (int x = 0; x < 1400; ++x) wide += isShadow(x, middle);
    for (int y = 0; y < 900; ++y) high += isShadow(700, y);
    EXPECT_NEAR(wide, 1000, 2);
    EXPECT_NEAR(high, 400, 2);
}

TEST(Book, OutlinesOfPlacesHaveTheColoursOfTheirVerdicts) {
    // Two squares of 40 m at 1:1000 and 254 dots an inch: 400 dots a side.
    auto scene = std::make_shared<DiagramScene>();
    scene->places = {{"A", PlaceKind::park, {boxFootprint(-50, -20, -10, 20)}, "a"},
                     {"B", PlaceKind::park, {boxFootprint(10, -20, 50, 20)}, "b"}};
    const auto paint = [&] {
        QImage image(1400, 900, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        paintDiagram({painter, 254.0 / 72}, QRectF(0, 0, 1400, 900),
                     {scene, {}, {}, {}, {0, 0}, 1000, {}, 1});
        painter.end();
        return image;
    };
    const auto countLeft = [](const QImage& image, Verdict verdict, bool left) {
        int dots = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = left ? 0 : 700; x < (left ? 700 : 1400); ++x)
                dots += image.pixelColor(x, y) == verdictMark(verdict);
        return dots;
    };
    EXPECT_EQ(countLeft(paint(), Verdict::fail, true), 0);
    scene->placeColours = {verdictMark(Verdict::fail), verdictMark(Verdict::pass)};
    const QImage image = paint();
    EXPECT_GT(countLeft(image, Verdict::fail, true), 4 * 400 * 3) << "a line of at least 3 dots all around";
    EXPECT_EQ(countLeft(image, Verdict::fail, false), 0);
    EXPECT_GT(countLeft(image, Verdict::pass, false), 4 * 400 * 3);
    EXPECT_EQ(countLeft(image, Verdict::pass, true), 0);
}

TEST(FlowText, KeepsAllTextInOrderInColumnsThatFit) {
    TextBlocks blocks;
    QString all;
    for (int i = 0; i < 40; ++i) {
        blocks.push_back(i % 5 == 0
                             ? heading(QStringLiteral("Part %1").arg(i))
                             : body(QStringLiteral("word ").repeated(qsizetype{7} * i) + QString::number(i)));
        all += blocks.back().text;
    }
    MeasuringCanvas measure;
    QString flowed;
    for (const TextBlocks& column : flowText(blocks, {150, 200}, 8)) {
        EXPECT_LE(heightOf(measure.canvas(), column, 150 * unit, 8), 200 * unit + 1);
        EXPECT_TRUE(column.size() == 1 || column.back().kind != TextKind::heading);
        for (const TextBlock& block : column) flowed += block.text;
    }
    EXPECT_EQ(flowed, all);
}

TEST(FlowTable, RepeatsTheTitlesAndLosesNoRow) {
    PageTable table{{QStringLiteral("Name"), QStringLiteral("A longer title")}, {}, {}, {}, 8};
    for (int i = 0; i < 90; ++i)
        table.rows.push_back({QString::number(i), QStringLiteral("text ").repeated(i)});
    table.widthsPt = fitColumns(table, 200);
    EXPECT_LE(table.widthsPt[0] + table.widthsPt[1], 200 + 1e-6);
    std::size_t next = 0;
    const auto parts = flowTable(table, 100, 300);
    EXPECT_GT(parts.size(), 3U);
    for (const PageTable& part : parts) {
        EXPECT_EQ(part.titles, table.titles);
        EXPECT_LE(tableHeightPt(part), 300.1);
        for (const auto& row : part.rows) EXPECT_EQ(row, table.rows[next++]);
    }
    EXPECT_EQ(next, table.rows.size());
}

// Many narrow numbers beside long names: a title is in one row, a name in all of them.
TEST(FlowTable, NamesGetTheWidthThatWordsOfTitlesLeave) {
    PageTable table{{QStringLiteral("Place")}, {}, {}, {}, 8};
    for (int i = 0; i < 10; ++i)
        table.titles.push_back(QStringLiteral("Mean sun of all cells with trees as evergreens, h"));
    for (int i = 0; i < 20; ++i) {
        table.rows.push_back({QStringLiteral("Rue de la Turbie, Rue Grimaldi to Rue Suffren, sidewalk")});
        table.rows.back().resize(11, QStringLiteral("1.23"));
    }
    const std::vector<double> widths = fitColumns(table, 700);
    EXPECT_NEAR(std::accumulate(widths.begin(), widths.end(), 0.0), 700, 0.5);
    EXPECT_GT(widths[0], 2 * widths[1]);
    EXPECT_GT(widths[1], 35) << "no word is broken";
}

TEST(Book, PreviewsShowThePagesOfThePdf) {
    const Book book = ReviewedPark().book({{Paper::a4, true}, {}, {}});
    const QImage picture = makePagePicture(book, 0, 72);
    EXPECT_NEAR(picture.width(), 842, 1);
    EXPECT_NEAR(picture.height(), 595, 1);
    bool hasShadow = false;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            hasShadow = hasShadow || picture.pixelColor(x, y) == shade::incremental;
    EXPECT_TRUE(hasShadow) << "the picture of the worst moment";
}

TEST(Book, WithoutAProposalStillHasItsPages) {
    ReviewedPark park;
    park.after = park.before;
    NoProgress progress;
    park.study = runReview(park.study.rule, park.before, park.after, park.places, park.study.settings,
                           AutoEngine(), progress, {})
                     .value();
    const Book book = park.book({});
    EXPECT_GE(book.pages.size(), 4U);
    expectNothingCutOff(book);
}

TEST(Book, BarsMayBeNegative) {
    BarChart chart{{{QStringLiteral("Score"), Qt::red}}, {}};
    chart.groups = {{QStringLiteral("Jan"), {100}}, {QStringLiteral("Feb"), {-100}}};
    QImage image(400, 300, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintBars({painter, 1}, QRectF(0, 0, 400, 300), chart);
    painter.end();
    const auto heights = [&](int x) {
        std::pair rows{300, 0};
        for (int y = 0; y < 300; ++y)
            if (image.pixelColor(x, y) == QColor(Qt::red)) rows = {std::min(rows.first, y), y};
        return rows;
    };
    const QRectF plot = plotIn(QRectF(0, 0, 400, 300), 1);
    const auto january = heights(int(plot.left() + plot.width() / 4)),
               february = heights(int(plot.left() + plot.width() * 3 / 4));
    EXPECT_LE(std::abs(january.second - february.first), 2) << "both begin at zero";
    EXPECT_NEAR(january.second - january.first, february.second - february.first, 2);
}

TEST(Book, StopsWhenAsked) {
    const ReviewedPark park;
    std::stop_source stop;
    stop.request_stop();
    NoProgress progress;
    const auto book = makeReviewBook(park.source(), {}, progress, stop.get_token());
    ASSERT_FALSE(book);
    EXPECT_TRUE(isCancelled(book.error()));
}

TEST(PrintBook, RefusesABookWithoutPages) { EXPECT_FALSE(printBook({})); }

}  // namespace
}  // namespace noonmark
