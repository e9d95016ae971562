#include <gmock/gmock.h>

#include <QRegularExpression>
#include <algorithm>

#include "app/report/book/review/review_pages.h"
#include "core/engines/auto_engine.h"
#include "core/review/library/rule_library.h"
#include "core/review/places/verdict_text.h"
#include "tests/report/book/book_texts.h"
#include "tests/report/book/review_scene.h"

namespace noonmark {
namespace {

using namespace tests;

Place piece(int number, PlaceKind kind, float west, float south, float size) {
    const std::string source = "OSM way " + std::to_string(number);
    return {std::string(nameOf(kind)) + " (" + source + ")",
            kind,
            {boxFootprint(west, south, west + size, south + size)},
            source};
}

/// The park of ReviewedPark, `pieces` plantings of 36 m2 in the tower's shadow on it, as many plazas of
/// 144 m2 without a name beside it, and places with names that no shadow reaches; reviewed by a rule.
ReviewedPark reviewOfMany(const std::string& rule, int pieces) {
    ReviewedPark park("Elm Park");
    for (int i = 0; i < pieces; ++i) {
        const float column = float(i % 14), row = float(i / 14 % 8);
        park.places.push_back(piece(i, PlaceKind::greenstreet, -49 + column * 7, 1 + row * 7, 6));
        park.places.push_back(piece(1000 + i, PlaceKind::plaza, -100 + column * 13, 61 + row * 13, 12));
    }
    for (int i = 0; i < 40; ++i)
        park.places.push_back({"Far Garden " + std::to_string(i),
                               PlaceKind::park,
                               {boxFootprint(float(i) * 30, -900, float(i) * 30 + 20, -880)},
                               "test"});
    park.study.rule = RuleLibrary::load({}).value().find(rule, {}).value();
    NoProgress progress;
    park.study = runReview(park.study.rule, park.before, park.after, park.places, park.study.settings,
                           AutoEngine(), progress, {})
                     .value();
    return park;
}

std::vector<std::string> namesOf(const std::vector<PlaceRow>& rows) {
    std::vector<std::string> names;
    for (const PlaceRow& row : rows) names.push_back(row.name.toStdString());
    return names;
}

TEST(ReviewBook, OfManyPlacesHasAtMostThirtyPages) {
    const ReviewedPark park = reviewOfMany("ceqr", 112);
    ASSERT_TRUE(std::ranges::any_of(park.study.places, [](const PlaceReview& place) {
        return place.verdict == Verdict::fail;
    })) << "timelines and tables have something to list";
    for (const bool landscape : {false, true})
        EXPECT_LE(park.book({{Paper::a4, landscape}, {}, {}}).pages.size(), 30U);
    BookSettings all;
    all.allPages = true;
    EXPECT_GT(park.book(all).pages.size(), 30U);
}

TEST(ReviewBook, ListsSmallPiecesUnderThePlaceThatTheyLieIn) {
    const ReviewedPark park = reviewOfMany("four-days", 28);
    const ListedPlaces list = listPlaces(park.source(), {}, true);
    EXPECT_THAT(namesOf(list.rows), testing::Contains("Elm Park: pieces of less than 100 m²"));
    EXPECT_THAT(namesOf(list.rows), testing::Not(testing::Contains(testing::HasSubstr("greenstreet"))));
    BookSettings settings;
    settings.minPlaceM2 = 10;
    EXPECT_THAT(namesOf(listPlaces(park.source(), settings, true).rows),
                testing::Contains("greenstreet (OSM way 0)"));
}

TEST(ReviewBook, ListsEveryPlaceOnceAndNumbersItAlikeEverywhere) {
    const ReviewedPark park = reviewOfMany("ceqr", 112);
    const ListedPlaces list = listPlaces(park.source(), {}, true);
    std::vector<int> listed(park.places.size(), 0);
    for (const auto* rows : {&list.rows, &list.others})
        for (const PlaceRow& row : *rows)
            for (const std::size_t i : row.reviews) {
                ++listed[i];
                EXPECT_EQ(list.numbers[i], row.number);
            }
    for (const std::size_t i : list.unnamed) {
        ++listed[i];
        EXPECT_EQ(list.numbers[i], 0) << "what nobody can name has no number";
    }
    EXPECT_THAT(listed, testing::Each(1));
    EXPECT_EQ(list.others.size(), 40U) << "the far gardens";
    EXPECT_EQ(list.rows.front().number, 1);
}

TEST(ReviewBook, NumbersPlacesOfDiagramsAndNamesThemInAKey) {
    const ReviewedPark park = reviewOfMany("four-days", 28);
    const Book book = park.book({});
    const auto page = std::ranges::find(book.pages, QStringLiteral("Shadow diagrams"), &BookPage::title);
    ASSERT_NE(page, book.pages.end());
    const QString text = textOfPage(book, std::size_t(page - book.pages.begin()));
    EXPECT_FALSE(text.contains(QStringLiteral("OSM way"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("1 Elm Park"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("plaza without a name"))) << text.toStdString();
}

TEST(ReviewBook, DrawsTimelinesOfWhatFailsOrIsBorderlineUnlessAllAreAskedFor) {
    const ReviewedPark park("Elm Park");
    const auto hasTimelines = [&](const BookSettings& settings) {
        return std::ranges::any_of(park.book(settings).pages, [](const BookPage& page) {
            return page.title.startsWith(QStringLiteral("Timelines"));
        });
    };
    EXPECT_FALSE(hasTimelines({})) << "the rule has no limit";
    BookSettings all;
    all.allPages = true;
    EXPECT_TRUE(hasTimelines(all));
}

/// A park and a lawn in it, each with a verdict.
ReviewedPark parkAndLawn(Verdict park, Verdict lawn) {
    ReviewedPark reviewed("Elm Park");
    reviewed.places.push_back({"Elm Lawn", PlaceKind::plaza, {boxFootprint(-15, 0, 15, 15)}, "test"});
    NoProgress progress;
    reviewed.study = runReview(reviewed.study.rule, reviewed.before, reviewed.after, reviewed.places,
                               reviewed.study.settings, AutoEngine(), progress, {})
                         .value();
    reviewed.study.places[0].verdict = park;
    reviewed.study.places[1].verdict = lawn;
    return reviewed;
}

TEST(ReviewBook, TheFirstPageShowsTheMostShadowOnAPlaceThatFails) {
    const auto first = [](const ReviewedPark& park) { return textOfPage(park.book({}), 0); };
    const QString ofLawn = first(parkAndLawn(Verdict::pass, Verdict::fail));
    EXPECT_TRUE(ofLawn.contains(QStringLiteral("Elm Lawn (figures only) at one moment")))
        << ofLawn.toStdString();
    const QString ofPark = first(parkAndLawn(Verdict::fail, Verdict::fail));
    EXPECT_TRUE(ofPark.contains(QStringLiteral("Elm Park (figures only) at one moment")))
        << "more of it is shaded: " << ofPark.toStdString();
}

TEST(ReviewBook, NamesTheLeastSureFigures) {
    ReviewedPark park("Elm Park");
    park.study.rule = RuleLibrary::load({}).value().find("ceqr", {}).value();
    const QString text = textOfPage(park.book({}), 0);
    EXPECT_TRUE(text.contains(QStringLiteral("the hours (U: "))) << text.toStdString();
}

TEST(ReviewBook, OfManyPlacesLaysNoTextOverAnother) {
    const ReviewedPark park = reviewOfMany("ceqr", 56);
    for (const bool landscape : {false, true}) {
        const Book book = park.book({{Paper::a4, landscape}, {}, {}});
        for (std::size_t i = 0; i < book.pages.size(); ++i)
            EXPECT_THAT(listMeetings(textsOfPage(book, i)), testing::IsEmpty()) << "page " << i;
    }
}

/// The texts of all pages but the last chapter, which quotes the rule and the command.
QString textBeforeMethod(const Book& book) {
    QString all;
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
        if (book.pages[i].title == QStringLiteral("Method and sources")) break;
        all += textOfPage(book, i) + u' ';
    }
    return all;
}

TEST(ReviewBook, SaysFiguresOnlyOfARuleWithoutALimit) {
    const ReviewedPark park("Elm Park");
    EXPECT_EQ(nameVerdict(park.study.places.front()), "figures only");
    const QString text = textBeforeMethod(park.book({}));
    EXPECT_TRUE(text.contains(QStringLiteral("place: figures only"))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("not applicable"))) << text.toStdString();
}

TEST(ReviewBook, WritesDatesAndAreasAsPeopleDo) {
    for (const char* rule : {"four-days", "ceqr", "bre-209-amenity"}) {
        const QString text = textBeforeMethod(reviewOfMany(rule, 4).book({}));
        EXPECT_FALSE(text.contains(QRegularExpression(QStringLiteral("[0-9]{4}-[0-9]{2}-[0-9]{2}"))))
            << rule << ": " << text.toStdString();
        EXPECT_FALSE(text.contains(QRegularExpression(QStringLiteral("\\b(m|ft)2\\b"))))
            << rule << ": " << text.toStdString();
    }
}

TEST(ReviewBook, SaysThatItsCityIsTheRules) {
    const ReviewedPark park("Elm Park");
    const Book book = park.book({});
    const QString where = QString::fromStdString(park.study.rule.where);
    EXPECT_TRUE(book.pages.front().subtitle.contains(QStringLiteral("Rule used in: ") + where))
        << book.pages.front().subtitle.toStdString();
}

/// Whether a box lies inside another.
bool holds(const Box2& all, const Box2& box) {
    return all.low.x <= box.low.x && all.low.y <= box.low.y && all.high.x >= box.high.x &&
           all.high.y >= box.high.y;
}

/// The ground of each diagram of a book, which must outlive them.
std::vector<std::pair<const Diagram*, Box2>> groundsOf(const Book& book) {
    std::vector<std::pair<const Diagram*, Box2>> grounds;
    const double scale = textScale(book.setup);
    for (const BookPage& page : book.pages)
        for (const PageItem& item : page.items)
            if (const auto* diagram = std::get_if<Diagram>(&item.content))
                grounds.emplace_back(diagram,
                                     groundOf(diagram->centre, diagram->scale, mapAreaOf(item.area, scale)));
    return grounds;
}

Box2 boxOf(const std::vector<Footprint>& polygons) {
    Box2 box;
    for (const Footprint& polygon : polygons) box.add(bounds(polygon));
    return box;
}

Box2 grownBy(const Box2& box, float by) { return {box.low - by, box.high + by}; }

/// The park of ReviewedPark as long as asked for, from -50 m east on, with diagrams from 8 h on.
ReviewedPark parkOfLength(float east) {
    ReviewedPark park("Elm Park");
    park.places.front().polygons = {boxFootprint(-50, 0, east, 60)};
    park.study.rule.deliverables.diagrams->timesMin = {480, 600, 840, 960};
    NoProgress progress;
    park.study = runReview(park.study.rule, park.before, park.after, park.places, park.study.settings,
                           AutoEngine(), progress, {})
                     .value();
    return park;
}

TEST(ReviewBook, FramesOfDiagramsHoldTheAddedShadowAndThePlacesThatItReaches) {
    const ReviewedPark park = parkOfLength(110);
    const Box2 place = boxOf(park.places.front().polygons);
    for (const bool landscape : {false, true}) {
        const Book book = park.book({{Paper::a4, landscape}, {}, {}});
        const auto grounds = groundsOf(book);
        ASSERT_GE(grounds.size(), 9U);
        for (const auto& [diagram, ground] : grounds) {
            const std::string of = diagram->caption.first.toStdString() + (landscape ? ", landscape" : "");
            EXPECT_TRUE(holds(ground, place)) << of;
            // What is cut ends at the frame.
            const Box2 inside = grownBy(ground, -1);
            EXPECT_TRUE(holds(inside, boxOf(diagram->shadows.incremental))) << of;
            for (const FanShadow& shadow : diagram->fan)
                EXPECT_TRUE(holds(inside, boxOf(shadow.polygons))) << of << ", " << shadow.time.toStdString();
        }
    }
}

TEST(ReviewBook, AParkMuchLargerThanTheShadowDoesNotMakeItSmall) {
    const ReviewedPark park = parkOfLength(4000);
    const Book book = park.book({});
    const auto grounds = groundsOf(book);
    ASSERT_FALSE(grounds.empty());
    for (const auto& [diagram, ground] : grounds) {
        EXPECT_LE(diagram->scale, 7500) << diagram->caption.first.toStdString();
        EXPECT_TRUE(holds(grownBy(ground, -1), boxOf(diagram->shadows.incremental)))
            << diagram->caption.first.toStdString();
    }
}

/// Share of the page's height that its items leave empty at the bottom.
double emptyShare(const Book& book, const BookPage& page) {
    const QRectF all = contentArea(book.setup);
    double bottom = all.top();
    for (const PageItem& item : page.items) bottom = std::max(bottom, item.area.bottom());
    return (all.bottom() - bottom) / all.height();
}

TEST(ReviewBook, FewRowsHaveNoPageOfTheirOwn) {
    const ReviewedPark park("Elm Park");
    const Book book = park.book({});
    EXPECT_TRUE(textOfPage(book, 0).contains(QStringLiteral("Table of the rule")));
    EXPECT_EQ(std::ranges::count(book.pages, QStringLiteral("Tables"), &BookPage::title), 0);
    EXPECT_LT(emptyShare(book, book.pages.front()), 0.25);
    EXPECT_EQ(std::ranges::count(book.pages, QStringLiteral("Views from the sun"), &BookPage::title), 1)
        << "two days of two hours";
}

TEST(ReviewBook, OfManyDaysListsTheWorstOfEachMonth) {
    ReviewedPark park("Elm Park");
    ReviewRow row = park.study.places.front().rows.front();
    auto& rows = park.study.places.front().rows;
    rows.clear();
    for (unsigned day = 0; day < 61; ++day) {
        row.day = CivilDate(std::chrono::sys_days{std::chrono::year{2026} / 3 / 1} + std::chrono::days(day));
        row.durationMin = 60;
        row.incrementalM2h = day == 10 || day == 40 ? 900 : 100 + day;
        rows.push_back(row);
    }
    const QString text = textBeforeMethod(park.book({}));
    EXPECT_TRUE(text.contains(QStringLiteral("11 March 2026"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("10 April 2026")));
    EXPECT_FALSE(text.contains(QStringLiteral("12 March 2026")));
    EXPECT_TRUE(text.contains(QStringLiteral("59 further days")));
    BookSettings all;
    all.allPages = true;
    EXPECT_TRUE(textBeforeMethod(park.book(all)).contains(QStringLiteral("12 March 2026")));
}

TEST(ReviewBook, RepeatsHowMuchItHolds) {
    BookSettings settings;
    settings.allPages = true;
    settings.minPlaceM2 = 250;
    const auto options = makeRepeatOptions(settings);
    const auto find = [&](std::string_view flag) {
        return std::ranges::find(options, flag, &CommandOption::name);
    };
    ASSERT_NE(find("--all-pages"), options.end());
    ASSERT_NE(find("--least-place"), options.end());
    EXPECT_THAT(find("--least-place")->values, testing::ElementsAre("250"));
}

TEST(ReviewBook, IsRepeatedWithTheDateThatItPrints) {
    for (const char* date : {"", "1 May 2026"}) {
        BookSettings settings;
        settings.titleBlock.date = date;
        const auto options = makeRepeatOptions(settings);
        const auto stated = std::ranges::find(options, "--date", &CommandOption::name);
        ASSERT_NE(stated, options.end()) << date;
        EXPECT_EQ(QString::fromStdString(stated->values.front()),
                  *date == 0 ? describeToday() : QString::fromUtf8(date));
    }
}

TEST(ReviewBook, ShowsOnRequestWhereTheHeightsComeFrom) {
    const ReviewedPark park("Elm Park");
    const auto find = [](const Book& book) {
        return std::ranges::find(book.pages, QStringLiteral("Where the heights come from"), &BookPage::title);
    };
    const Book plain = park.book({});
    EXPECT_EQ(find(plain), plain.pages.end());
    BookSettings settings;
    settings.heightMap = true;
    const Book book = park.book(settings);
    ASSERT_NE(find(book), book.pages.end());
    const auto index = std::size_t(find(book) - book.pages.begin());
    const QString text = textOfPage(book, index);
    EXPECT_TRUE(text.contains(QStringLiteral("measured: 3"))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("assumed"))) << text.toStdString();
    EXPECT_THAT(listMeetings(textsOfPage(book, index)), testing::IsEmpty());
}

}  // namespace
}  // namespace noonmark
