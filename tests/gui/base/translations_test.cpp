#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QDockWidget>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QTranslator>
#include <clocale>
#include <map>
#include <nlohmann/json.hpp>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/study/region_text.h"
#include "app/input/all_engines.h"
#include "app/language/language.h"
#include "app/report/maps/answer_legends.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/roof_receivers.h"
#include "core/review/library/rule_library.h"
#include "core/study/review_figures.h"
#include "scenarios/weights/score_text.h"
#include "tests/gui/answers_window.h"
#include "tests/gui/translation_messages.h"

namespace noonmark {
namespace {

using test::AnswersWindow;
using test::codeOf;
using test::expectSameParts;
using test::Languages;
using test::Message;
using test::readMessages;
using test::translatedLanguages;
using test::waitFor;
using testing::HasSubstr;
using testing::Not;

constexpr double minFinishedPct = 99;

TEST_F(Languages, TranslationsAreCompleteAndKeepWhatIsFilledIn) {
    for (const Language language : translatedLanguages) {
        const std::vector<Message> messages = readMessages(language);
        ASSERT_GT(messages.size(), 1000U) << codeOf(language);
        int finished = 0;
        for (const Message& message : messages) {
            if (!message.finished) continue;
            ++finished;
            for (const QString& text : message.texts) expectSameParts(text, message, codeOf(language));
        }
        EXPECT_GE(100.0 * finished / double(messages.size()), minFinishedPct) << codeOf(language);
    }
}

TEST_F(Languages, KeysOfActionsAreTheSameInEveryLanguage) {
    static const QRegularExpression keys(QStringLiteral("^((Ctrl|Shift|Alt)\\+)+\\S+$"));
    for (const Language language : translatedLanguages)
        for (const Message& message : readMessages(language))
            if (keys.match(message.source).hasMatch()) {
                EXPECT_EQ(message.texts, QStringList{message.source});
            }
}

TEST_F(Languages, TheFirstLanguageOfTheSystemThatThereIsCounts) {
    const QStringList austrian{QStringLiteral("de-AT"), QStringLiteral("en-US")};
    EXPECT_EQ(findTranslation(Language::system, austrian), QStringLiteral("de"));
    EXPECT_EQ(findTranslation(Language::japanese, austrian), QStringLiteral("ja"));
    EXPECT_EQ(findTranslation(Language::system, {QStringLiteral("fr-FR"), QStringLiteral("es")}),
              QStringLiteral("es"));
    EXPECT_EQ(findTranslation(Language::system, {QStringLiteral("en-GB"), QStringLiteral("de")}),
              QStringLiteral("en"))
        << "an Englishman who also reads German";
    EXPECT_EQ(findTranslation(Language::system, {QStringLiteral("C")}), QStringLiteral("en"));
    EXPECT_EQ(chooseLocale(QStringLiteral("de"), QLocale(QStringLiteral("de_CH"))).name(),
              QStringLiteral("de_CH"));
    EXPECT_EQ(chooseLocale(QStringLiteral("es"), QLocale(QStringLiteral("de_CH"))).language(),
              QLocale::Spanish);
}

TEST_F(Languages, TheChoiceOutlivesTheWindow) {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
    EXPECT_EQ(readLanguage(settings), Language::system);
    for (const LanguageEntry& entry : languages) {
        saveLanguage(entry.language, settings);
        EXPECT_EQ(readLanguage(settings), entry.language);
    }
    settings.setValue(QStringLiteral("language"), QStringLiteral("tlh"));
    EXPECT_EQ(readLanguage(settings), Language::system);
}

TEST_F(Languages, NumbersAreWrittenAsTheLanguageWritesThem) {
    use(Language::english);
    EXPECT_EQ(groupDigits(1234.5, 1), QStringLiteral("1,234.5"));
    EXPECT_EQ(formatAmount(61234.50, 2), QStringLiteral("61,234.5"));
    EXPECT_EQ(groupDigits(-0.04, 1), QStringLiteral("0.0"));
    EXPECT_EQ(withPlus(0.04, groupDigits(0.04, 1)), QStringLiteral("0.0"));
    EXPECT_EQ(withPlus(0.06, groupDigits(0.06, 1)), QStringLiteral("+0.1"));
    EXPECT_EQ(withPlus(-3, groupDigits(-3, 1)), QStringLiteral("-3.0"));
    EXPECT_EQ(signedAreaNumber(0.2), QStringLiteral("0"));
    const QString texts[] = {QStringLiteral("1,204 m² (0.25 %)"), QStringLiteral("2026-06-21 14:30"),
                             QStringLiteral("12.5 ha")};
    for (const QString& text : texts) EXPECT_EQ(localiseNumbers(text), text);
    use(Language::german);
    EXPECT_EQ(groupDigits(1234.5, 1), QStringLiteral("1.234,5"));
    EXPECT_EQ(formatAmount(61234.50, 2), QStringLiteral("61.234,5"));
    EXPECT_EQ(formatCount(1234567), QStringLiteral("1.234.567"));
    EXPECT_EQ(localiseNumbers(texts[0]), QStringLiteral("1.204 m² (0,25 %)"));
    EXPECT_EQ(localiseNumbers(texts[1]), texts[1]) << "dates and times stay";
    EXPECT_EQ(localiseNumbers(texts[2]), QStringLiteral("12,5 ha"));
    EXPECT_STREQ(std::localeconv()->decimal_point, ".") << "of C functions, which read and write files";
}

TEST_F(Languages, EnginesAndTheirOptionsHaveWordsInEveryLanguage) {
    for (const Language language : translatedLanguages) {
        QStringList words;
        for (const Message& message : readMessages(language)) words << message.source;
        const auto expectWord = [&](std::string_view english) {
            EXPECT_TRUE(words.contains(QString::fromStdString(std::string(english))))
                << codeOf(language) << ": " << english;
        };
        for (const EngineEntry& engine : allEngines()) {
            expectWord(engine.info.name);
            expectWord(engine.info.about);
            for (const Field& option : engine.info.options) {
                expectWord(option.label);
                expectWord(option.help);
                if (!option.whenEmpty.empty()) expectWord(option.whenEmpty);
            }
        }
    }
}

TEST_F(Languages, ChoicesOfCoreAreTranslated) {
    use(Language::german);
    for (const auto& choice : receiverPlaceChoices)
        EXPECT_NE(noonmark::translated(choice.label), QString::fromUtf8(choice.label.data())) << choice.label;
}

// Texts of the marks NM_TEXT("...") and sheetText("...") in a source, without quotes within them.
QStringList markedTexts(const QString& source) {
    static const QRegularExpression mark(
        QStringLiteral(R"re((?:NM_TEXT|sheetText)\(\s*((?:"[^"\\]*"\s*)+)\))re")),
        part(QStringLiteral(R"re("([^"\\]*)")re"));
    QStringList texts;
    for (auto at = mark.globalMatch(source); at.hasNext();) {
        QString text;
        for (auto one = part.globalMatch(at.next().captured(1)); one.hasNext();)
            text += one.next().captured(1);
        texts << text;
    }
    return texts;
}

TEST_F(Languages, WhatCoreMarksIsAmongTheMessages) {
    QSet<QString> known;
    for (const Message& message : readMessages(Language::german)) known.insert(message.source);
    int marks = 0;
    for (const char* folder : {"core", "scenarios", "render", "app/gui", "app/report", "app/questions"})
        for (QDirIterator files(QString::fromStdString(tests::sourceFile(folder).string()),
                                {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                                QDirIterator::Subdirectories);
             files.hasNext();) {
            QFile file(files.next());
            ASSERT_TRUE(file.open(QIODevice::ReadOnly));
            for (const QString& text : markedTexts(QString::fromUtf8(file.readAll()))) {
                ++marks;
                EXPECT_TRUE(known.contains(text))
                    << file.fileName().toStdString() << ": " << text.toStdString();
            }
        }
    EXPECT_GT(marks, 1000);
}

TEST_F(Languages, MarksWithinClassesAreFound) {
    use(Language::german);
    EXPECT_EQ(noonmark::translated("Shadow by place"), QStringLiteral("Schatten nach Ort"));
    EXPECT_EQ(noonmark::translated("tracing rays through trees"),
              QStringLiteral("verfolgt Strahlen durch Bäume"));
    EXPECT_EQ(noonmark::translated("a.osm.pbf"), QStringLiteral("a.osm.pbf"));
}

TEST_F(Languages, NamesThatTheProgramGivesAreTranslatedAndThoseOfUsersStay) {
    use(Language::german);
    EXPECT_EQ(scenarioName("Existing"), QStringLiteral("Bestand"));
    EXPECT_EQ(scenarioName("Study of Existing"), QStringLiteral("Study of Existing"));
    EXPECT_EQ(placeName("Rue Grimaldi, Rue Baron to Place d'Armes, sidewalks (2)"),
              QStringLiteral("Rue Grimaldi, Rue Baron bis Place d'Armes, Gehwege (2)"));
    EXPECT_EQ(placeName("Main Street, north of 2nd Avenue"),
              QStringLiteral("Main Street, nördlich von 2nd Avenue"));
    EXPECT_EQ(placeName("street (OSM way 12 and 3 more)"),
              QStringLiteral("Straße (OSM way 12 und 3 weitere)"));
    EXPECT_EQ(placeName("Lurie Garden"), QStringLiteral("Lurie Garden"));
    EXPECT_EQ(ruleName("Four days, three hours"), QStringLiteral("4 Tage, 3 Uhrzeiten"));
    EXPECT_EQ(ruleName("Rule of our town"), QStringLiteral("Rule of our town"));
    const auto headline = [](const std::string& rule) {
        return sentenceText(makeReviewPage({.pass = 2}, rule, "Proposal A", {}).headline);
    };
    EXPECT_EQ(headline("Four days, three hours"),
              QStringLiteral("Alle 2 beurteilten Orte erfüllen 4 Tage, 3 Uhrzeiten in Proposal A"));
    EXPECT_EQ(headline("Rule of our town"),
              QStringLiteral("Alle 2 beurteilten Orte erfüllen Rule of our town in Proposal A"));
}

/// What a person reads of a rule.
std::vector<std::string> textsOfRule(const Rule& rule) {
    std::vector<std::string> texts{rule.name, rule.where, rule.summary};
    const auto add = [&](const std::vector<std::string>& more) {
        texts.insert(texts.end(), more.begin(), more.end());
    };
    for (const Criterion& criterion : rule.criteria) texts.push_back(criterion.name);
    for (const RuleColumn& column : rule.deliverables.columns) texts.push_back(column.title);
    for (const StatedFigure& figure : rule.figures) texts.push_back(figure.text);
    for (const UnitShare& share : rule.shares) texts.push_back(share.name);
    for (const RuleDay& day : rule.days.fixed) texts.push_back(day.label);
    for (const auto& [choice, options] : rule.choices) {
        texts.push_back(choice);
        add(options);
    }
    add(rule.readings);
    add(rule.notChecked);
    std::erase(texts, std::string());
    return texts;
}

QSet<QString> sourcesIn(const QString& context) {
    QSet<QString> sources;
    for (const Message& message : readMessages(Language::german))
        if (context.isEmpty() || message.context == context) sources.insert(message.source);
    return sources;
}

TEST_F(Languages, AllThatAPersonReadsOfRulesIsOfferedForTranslation) {
    const QSet<QString> known = sourcesIn(QStringLiteral("Rule"));
    const RuleLibrary library = RuleLibrary::load().value();
    int texts = 0;
    for (const RuleGroup& group : groupByCountry(library.rules(), {})) {
        if (group.name != anyCountry) {
            EXPECT_TRUE(known.contains(QString::fromStdString(group.name))) << group.name;
        }
        for (const Rule* rule : group.rules)
            for (const std::string& text : textsOfRule(*rule)) {
                ++texts;
                EXPECT_TRUE(known.contains(QString::fromStdString(text))) << rule->key << ": " << text;
            }
    }
    EXPECT_GT(texts, 300);
}

TEST_F(Languages, FiguresLegendsAndVerdictsAreOfferedForTranslation) {
    const QSet<QString> known = sourcesIn({});
    const auto expectKnown = [&](const QString& text) {
        EXPECT_TRUE(text.isEmpty() || known.contains(text)) << text.toStdString();
    };
    for (const auto& figures : {shadowFigures().rows(), scoreFigures().rows(), scoreMonthFigures().rows()})
        for (const Figure& figure : figures) {
            expectKnown(QString::fromUtf8(figure.label.data(), qsizetype(figure.label.size())));
            expectKnown(QString::fromUtf8(figure.definition.data(), qsizetype(figure.definition.size())));
        }
    for (const ShadowMeasure measure : {ShadowMeasure::gross, ShadowMeasure::continuous})
        for (const ShownAs show : {ShownAs::shadow, ShownAs::sun, ShownAs::share}) {
            const Legend legend = makeLegend(measure, {.show = show}, 600, 600, {});
            expectKnown(legend.title);
            expectKnown(legend.unit);
        }
    for (const HeightSourceColour& source : heightSourceColours())
        expectKnown(QString::fromStdString(std::string(source.label)));
    for (const PlaceKind kind : placeKinds) expectKnown(QString::fromStdString(std::string(nameOf(kind))));
    for (const Verdict verdict :
         {Verdict::pass, Verdict::borderline, Verdict::fail, Verdict::notApplicable, Verdict::notChecked})
        expectKnown(QString::fromStdString(std::string(nameOf(verdict))));
}

TEST_F(Languages, PeriodsAreStatedInTheLanguageAlsoWhereTheyWereSaved) {
    use(Language::german);
    const auto saved = [](const char* json) {
        return periodText(readStatedPeriod(nlohmann::ordered_json::parse(json)));
    };
    EXPECT_EQ(saved(R"({"text": "words", "start": "2026-06-21", "days": 1, "window": null, "from": "09:00",
                        "hours": 6.0, "step_min": 1.0, "zone": "Europe/Berlin", "refraction": true})"),
              QStringLiteral("21. Juni 2026, 09:00 bis 15:00, alle 1 min, Europe/Berlin"));
    EXPECT_EQ(saved(R"({"text": "words", "start": "2026-06-21", "days": 1, "from": null, "hours": null,
                        "window": {"after_sunrise_min": 0, "before_sunset_min": 0,
                                   "sunrise_altitude_deg": -0.8333},
                        "step_min": 0.5, "zone": "UTC", "refraction": false})"),
              QStringLiteral(
                  "21. Juni 2026, Sonnenaufgang bis Sonnenuntergang, alle 0,5 min, UTC, ohne Refraktion"));
    EXPECT_EQ(saved(R"({"text": "of another version"})"), QStringLiteral("of another version"));
    const Period moment{.hours = 0};
    EXPECT_EQ(periodText(statePeriod(moment)), periodText(moment));
}

TEST_F(Languages, NamesThatTheProgramGaveAreShownInTheLanguage) {
    use(Language::german);
    EXPECT_EQ(weightName("January"), QStringLiteral("Januar"));
    EXPECT_EQ(weightName("lunch in March"), QStringLiteral("lunch in March")) << "the user's";
}

TEST_F(Languages, ButtonsOfQtSpeakTheLanguageWithoutItsOwnTranslations) {
    use(Language::german);
    EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "&Yes"), QStringLiteral("&Ja"));
    EXPECT_EQ(QCoreApplication::translate("QUndoStack", "Undo %1"), QStringLiteral("Rückgängig: %1"));
}

TEST_F(Languages, ErrorsOfTheWindowAreTranslatedAndThoseOfCoreStay) {
    const Error own{"No city is open", {}, "Open a file or a sample first"};
    const Error core{"The file holds no polygons", "a.shp", "Export the building footprints as polygons"};
    EXPECT_EQ(describeError(own), QStringLiteral("No city is open. Open a file or a sample first"));
    use(Language::german);
    EXPECT_EQ(describeError(own),
              QStringLiteral("Keine Stadt ist geöffnet. Zuerst eine Datei oder ein Beispiel öffnen"));
    EXPECT_EQ(describeError(core), QString::fromStdString(core.text()));
}

/// A language of capitals for what core marks by NM_TEXT.
class Capitals final : public QTranslator {
public:
    [[nodiscard]] QString translate(const char* context, const char* source, const char*,
                                    int) const override {
        return QLatin1String(context) == QLatin1String("noonmark") ? QString::fromUtf8(source).toUpper()
                                                                   : QString();
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

TEST(ErrorWords, WhatCoreMarksIsTranslatedAndNamesStay) {
    Capitals capitals;
    QCoreApplication::installTranslator(&capitals);
    noteLanguageChange();
    EXPECT_EQ(describeError({"The region has no area", "Lot 7", "Draw a polygon with an interior"}),
              QStringLiteral("Lot 7: THE REGION HAS NO AREA. DRAW A POLYGON WITH AN INTERIOR"));
    const WarningGroup group{WarningKind::leftOut, "lies underground", {"way 3", "way 7", "way 9", "way 11"}};
    EXPECT_EQ(describeWarning(group), QStringLiteral("4 LEFT OUT: LIES UNDERGROUND"));
    EXPECT_EQ(describeWarningWithPlaces(group),
              QStringLiteral("4 LEFT OUT: LIES UNDERGROUND (way 3, way 7, way 9, ...)"));
    QCoreApplication::removeTranslator(&capitals);
    noteLanguageChange();
    EXPECT_EQ(describeWarningWithPlaces(group, 4).toStdString(), lineOf(group, 4)) << "as core says it";
}

std::map<QChar, QStringList> mnemonicsOf(const QList<QAction*>& actions) {
    std::map<QChar, QStringList> found;
    static const QRegularExpression mnemonic(QStringLiteral("&([^&\\s])"));
    for (const QAction* action : actions) {
        if (action->isSeparator()) continue;
        const auto match = mnemonic.match(QString(action->text()).remove(QStringLiteral("&&")));
        if (match.hasMatch()) found[match.captured(1).at(0).toUpper()] << action->text();
    }
    return found;
}

void expectDistinct(const QList<QAction*>& actions, const std::string& language) {
    for (const auto& [key, texts] : mnemonicsOf(actions))
        EXPECT_EQ(texts.size(), 1) << language << ": " << texts.join(QStringLiteral(", ")).toStdString();
}

struct TranslatedWindow : AnswersWindow {
    void reopen(Language language) {
        applyLanguage(language, *qApp);
        window = std::make_unique<MainWindow>(settings);
    }
    void TearDown() override { applyLanguage(Language::english, *qApp); }

    QByteArray exported(const char* name) {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
        return file.readAll();
    }
};

TEST_F(TranslatedWindow, LettersOfMenusDoNotClashInAnyLanguage) {
    for (const LanguageEntry& entry : languages) {
        if (entry.ownName == nullptr) continue;
        reopen(entry.language);
        expectDistinct(window->menuBar()->actions(), entry.code);
        for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>())
            expectDistinct(menu->actions(), entry.code);
    }
}

QStringList textsOf(const MainWindow& window) {
    QStringList texts;
    for (const QMenu* menu : window.menuBar()->findChildren<QMenu*>()) {
        texts << menu->title();
        for (const QAction* action : menu->actions())
            if (!action->isSeparator()) texts << action->text() << action->toolTip();
    }
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) texts << dock->windowTitle();
    texts.removeDuplicates();
    texts.removeAll(QString());
    return texts;
}

TEST_F(TranslatedWindow, MenusToolsAndDocksSpeakTheLanguage) {
    reopen(Language::english);
    const QStringList english = textsOf(*window);
    ASSERT_GT(english.size(), 80);
    for (const Language language : translatedLanguages) {
        reopen(language);
        int same = 0;
        for (const QString& text : textsOf(*window)) same += english.contains(text) ? 1 : 0;
        EXPECT_LE(same, 6) << codeOf(language) << " (names such as Central Park South stay)";
    }
}

// Without how long each file took to write, which no second run repeats.
std::string withoutTimes(const QByteArray& json) {
    QString text = QString::fromUtf8(json);
    static const QRegularExpression times(QStringLiteral("\"[a-z]+\\.[a-z]+\": [0-9.e-]+,?"));
    return text.remove(times).toStdString();
}

TEST_F(TranslatedWindow, FilesAreTheSameInEveryLanguage) {
    study();
    const auto write = [&](const char* name, Language language) {
        applyLanguage(language, *qApp);
        ExportChoice choice;
        choice.cells = true;
        workbench().exportShown(folder.filePath(QLatin1String(name)).toStdString(), choice);
        ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
    };
    write("english", Language::english);
    write("german", Language::german);
    const QDir english(folder.filePath(QStringLiteral("english")));
    int compared = 0;
    for (const QString& name : english.entryList({QStringLiteral("*.csv"), QStringLiteral("*.json")})) {
        const QByteArray first = exported(("english/" + name).toUtf8()),
                         second = exported(("german/" + name).toUtf8());
        EXPECT_EQ(withoutTimes(first), withoutTimes(second)) << name.toStdString();
        EXPECT_TRUE(first.contains('.')) << name.toStdString() << ": decimal points";
        ++compared;
    }
    EXPECT_GE(compared, 2);
}

}  // namespace
}  // namespace noonmark
