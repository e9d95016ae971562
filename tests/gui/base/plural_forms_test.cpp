#include <gtest/gtest.h>

#include <set>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/tools/massing/massing_text.h"
#include "tests/gui/translation_messages.h"

namespace noonmark {
namespace {

using test::codeOf;
using test::expectSameParts;
using test::Languages;
using test::Message;
using test::readMessages;
using test::translatedLanguages;

/// Contexts and sources of the plural texts of a .ts file.
std::set<QString> pluralTextsOf(Language language) {
    std::set<QString> found;
    for (const Message& message : readMessages(language))
        if (message.plural) found.insert(message.context + u'\n' + message.source);
    return found;
}

TEST_F(Languages, EnglishHasBothFormsOfEveryPluralText) {
    const std::vector<Message> messages = readMessages(Language::english);
    ASSERT_GE(messages.size(), 25U);
    for (const Message& message : messages) {
        EXPECT_TRUE(message.plural && message.finished) << message.source.toStdString();
        EXPECT_EQ(message.texts.size(), 2) << message.source.toStdString();
        for (const QString& text : message.texts) {
            expectSameParts(text, message, "en");
            EXPECT_NE(text, message.source) << "the choice of endings is left in the text";
        }
    }
    for (const Language language : translatedLanguages)
        EXPECT_EQ(pluralTextsOf(language), pluralTextsOf(Language::english)) << codeOf(language);
}

TEST_F(Languages, CountsChooseThePluralForm) {
    const auto expectStoreys = [this](Language language, const QStringList& expected) {
        use(language);
        EXPECT_EQ((QStringList{describeStoreys(0), describeStoreys(1), describeStoreys(2)}), expected)
            << codeOf(language);
    };
    expectStoreys(Language::english,
                  {QStringLiteral("0 storeys"), QStringLiteral("1 storey"), QStringLiteral("2 storeys")});
    expectStoreys(Language::german, {QStringLiteral("0 Geschosse"), QStringLiteral("1 Geschoss"),
                                     QStringLiteral("2 Geschosse")});
    expectStoreys(Language::spanish,
                  {QStringLiteral("0 plantas"), QStringLiteral("1 planta"), QStringLiteral("2 plantas")});
    expectStoreys(Language::japanese,
                  {QStringLiteral("0 階"), QStringLiteral("1 階"), QStringLiteral("2 階")});
}

TEST_F(Languages, EachCountOfASentenceHasItsOwnForm) {
    use(Language::english);
    EXPECT_EQ(describePlacesRead(1, {.replaced = 1}, {}),
              QStringLiteral("1 place was read; 1 replaces an earlier one."));
    EXPECT_EQ(describePlacesRead(1234, {}, {}), QStringLiteral("1,234 places were read."));
    EXPECT_TRUE(describe(RunEstimate{.receivers = 1, .steps = 540})
                    .startsWith(QStringLiteral("1 cell, 540 positions of the sun. ")));
    use(Language::german);
    EXPECT_TRUE(describe(RunEstimate{.receivers = 2000, .points = true, .steps = 1})
                    .startsWith(QStringLiteral("2.000 Punkte, 1 Sonnenstand. ")));
}

TEST_F(Languages, CountsLargerThanAnIntAreNeverTheSingular) {
    EXPECT_EQ(pluralNumber(1), 1);
    EXPECT_EQ(pluralNumber(1'000'000), 1'000'000);
    EXPECT_EQ(pluralNumber((1ULL << 32U) + 1) % 100, 97) << "4,294,967,297";
    EXPECT_GT(pluralNumber(5'000'000'001), 1);
}

}  // namespace
}  // namespace noonmark
