#include <gmock/gmock.h>

#include <QRegularExpression>

#include "app/language/translated_text.h"
#include "app/report/book/page_text.h"
#include "app/report/sheets/study_text.h"
#include "scenarios/scenario.h"
#include "tests/report/book/book_texts.h"
#include "tests/report/book/review_scene.h"

namespace noonmark {
namespace {

using namespace tests;
using namespace std::chrono;
using testing::IsEmpty;

/// What the program writes on the pages before the method, whose sources and commands are those of files.
std::vector<std::string> textsBeforeTheMethod(const Book& book) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i + 1 < book.pages.size(); ++i)
        for (const PaintedText& text : textsOfPage(book, i)) texts.push_back(text.text.toStdString());
    return texts;
}

std::vector<std::string> matching(const std::vector<std::string>& texts, const QString& pattern) {
    const QRegularExpression wanted(pattern);
    std::vector<std::string> found;
    for (const std::string& text : texts)
        if (wanted.match(QString::fromStdString(text)).hasMatch()) found.push_back(text);
    return found;
}

/// Numbers with a point before their last digits; not the program's version and the times of grouped digits.
const QString decimalPoint = QStringLiteral("(?<![\\d.A-Za-z])(?<!Noonmark )\\d+\\.\\d{1,2}(?![\\d.])");
const QString englishWords = QStringLiteral(
    "\\b(Summary|Place|Area|Verdict|Reason|Criterion|Measured|Timelines?|Clock|Baseline|Sheet|Project|Title|"
    "Client|Author|Date|Program|Month|March|June|December|minutes|places|incremental|existing|proposal|North "
    "is up|"
    "Least certain|wanted|not checked|figures only|Sun: azimuth|continued)\\b");

TEST(SheetLanguage, AGermanBookHasNeitherDecimalPointsNorEnglishWords) {
    const ReviewedPark park;
    BookSettings settings;
    settings.titleBlock.project = "P";
    const auto english = textsBeforeTheMethod(park.book(settings));
    EXPECT_THAT(matching(english, decimalPoint), testing::Not(IsEmpty())) << "they are found where they are";
    EXPECT_THAT(matching(english, englishWords), testing::Not(IsEmpty()));
    settings.language = Language::german;
    const auto german = textsBeforeTheMethod(park.book(settings));
    EXPECT_THAT(matching(german, decimalPoint), IsEmpty());
    EXPECT_THAT(matching(german, englishWords), IsEmpty());
}

TEST(SheetLanguage, TheRecordOfABookIsTheSameInEveryLanguage) {
    const ReviewedPark park;
    BookSettings settings;
    const std::string english = park.book(settings).record.json;
    settings.language = Language::german;
    EXPECT_EQ(park.book(settings).record.json, english);
}

TEST(SheetLanguage, NumbersAndDatesFollowTheScope) {
    const CivilDate day = 2026y / December / 21;
    const QString english = describeDates(day);
    EXPECT_EQ(describeAmount(61234.5), QStringLiteral("61,234.5"));
    {
        const WordingScope words(wordingOf(Language::german));
        EXPECT_EQ(describeAmount(61234.5), QStringLiteral("61.234,5"));
        EXPECT_EQ(describeCount(1204, "place"), QStringLiteral("1.204 Orte"));
        EXPECT_EQ(describeDates(day), QStringLiteral("21. Dez. 2026"));
        EXPECT_EQ(formatArea(1204, UnitSystem::metric), "1.204 m²");
        EXPECT_EQ(inEnglish([] { return formatLength(12.5, UnitSystem::metric); }), "12.5 m");
    }
    EXPECT_EQ(describeDates(day), english);
    EXPECT_EQ(formatLength(12.5, UnitSystem::metric), "12.5 m");
}

TEST(SheetLanguage, NamesOfTheProgramAreTranslatedAndThoseOfTheUserAreNot) {
    EXPECT_EQ(scenarioText("Existing"), QStringLiteral("Existing"));
    EXPECT_EQ(regionText("the whole city"), QStringLiteral("the whole city"));
    EXPECT_EQ(weightText("March"), QStringLiteral("March"));
    const WordingScope words(wordingOf(Language::german));
    EXPECT_EQ(scenarioText("Existing"), QStringLiteral("Bestand"));
    EXPECT_EQ(scenarioText("Height"), QStringLiteral("Height")) << "a word of the program, but the user's";
    EXPECT_EQ(regionText("the whole city"), QStringLiteral("die ganze Stadt"));
    EXPECT_EQ(regionText("Bryant Park"), QStringLiteral("Bryant Park"));
    EXPECT_EQ(weightText("March"), QStringLiteral("März"));
    EXPECT_EQ(weightText("Height"), QStringLiteral("Height"));
    EXPECT_EQ(describeEngineUsed("Projected shadows (chosen: exact)"),
              QStringLiteral("Projizierte Schatten"));
}

TEST(SheetLanguage, CommandsStateALanguageThatIsNotTheirDefault) {
    EXPECT_EQ(statedLanguage(Language::system), Language::system) << "the tests' window is English";
    EXPECT_EQ(statedLanguage(Language::english), Language::system);
    EXPECT_EQ(statedLanguage(Language::japanese), Language::japanese);
}

}  // namespace
}  // namespace noonmark
