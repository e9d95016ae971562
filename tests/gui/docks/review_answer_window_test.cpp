#include <gmock/gmock.h>

#include <QComboBox>

#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/review/review_session.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/report/files/answer_files.h"
#include "app/report/files/element_files.h"
#include "app/report/files/read_report.h"
#include "tests/gui/answers_window.h"
#include "tests/gui/glazing_review_window.h"

// A review is an answer as all others: shown with its headline, listed, saved, exported and marked.
namespace noonmark {
namespace {

using test::newTower;
using test::square;
using test::waitFor;
using ::testing::HasSubstr;

struct ReviewAnswerWindow : test::AnswersWindow {
    void SetUp() override {
        AnswersWindow::SetUp();
        StudySettings study = workbench().document().settings();
        study.period.zone = "America/New_York";
        workbench().document().change(study, QStringLiteral("zone"));
        Project next = session().project();
        next.places.push_back({"Park", PlaceKind::park, {square({10, 60}, 40)}, "drawn"});
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("places")));
        ReviewChoice choice = window->review().choice();
        choice.rule = "ceqr";
        choice.to = "Tower";
        window->review().choose(choice);
    }
    void review() {
        window->review().run();
        ASSERT_TRUE(waitFor([this] { return !window->review().running().busy(); }));
        ASSERT_TRUE(workbench().answerAs<ReviewAnswer>());
    }
    QString headline() { return QString::fromStdString(formatText(workbench().answer()->page({}).headline)); }
    QComboBox& list() { return *window->findChild<QComboBox*>(QStringLiteral("answers")); }
};

TEST_F(ReviewAnswerWindow, IsInFrontWithAHeadlineAndItsCounts) {
    study();
    review();
    const auto shown = workbench().answerAs<ReviewAnswer>();
    EXPECT_EQ(shown, window->review().shown()) << "the dock shows the same one";
    EXPECT_TRUE(headline().contains(QString::fromStdString(shown->study.rule.name)))
        << headline().toStdString();
    EXPECT_TRUE(headline().contains(QStringLiteral("Tower")));
    EXPECT_TRUE(figures().contains(QStringLiteral("Places that pass")));
    EXPECT_TRUE(list().currentText().startsWith(QString::fromStdString(shown->study.rule.name)))
        << list().currentText().toStdString();
    EXPECT_TRUE(workbench().canShowStudyAgain());
    workbench().showStudyAgain();
    EXPECT_TRUE(workbench().answerAs<Study>());
    const int at = list().findText(QString::fromStdString(shown->study.rule.name), Qt::MatchStartsWith);
    ASSERT_GE(at, 0);
    Q_EMIT list().activated(at);
    EXPECT_EQ(workbench().answerAs<ReviewAnswer>(), shown);
}

TEST_F(ReviewAnswerWindow, ComesBackFromTheProjectWithTheSameSentences) {
    review();
    const AnswerPage before = workbench().answer()->page({});
    const auto counts = workbench().answer()->figures();
    keep("Verdicts");
    EXPECT_EQ(session().project().results[0]->kind, "review");
    showSaved("Verdicts");
    const AnswerPage after = workbench().answer()->page({});
    EXPECT_EQ(formatText(after.headline), formatText(before.headline));
    ASSERT_EQ(after.findings.size(), before.findings.size());
    for (std::size_t i = 0; i < after.findings.size(); ++i)
        EXPECT_EQ(formatText(after.findings[i]), formatText(before.findings[i]));
    const auto read = workbench().answer()->figures();
    ASSERT_EQ(read.size(), counts.size());
    for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i].value, counts[i].value);
    EXPECT_TRUE(figures().contains(QStringLiteral("Places that pass")));
}

// Without being saved by name: a quick review is there with its places, and counts as the same answer.
TEST_F(ReviewAnswerWindow, IsThereAgainTomorrow) {
    review();
    const auto counts = workbench().answer()->figures();
    saveAndOpenAgain();
    ASSERT_TRUE(waitFor([this] { return !window->review().running().busy(); }));
    const auto again = window->review().shown();
    ASSERT_TRUE(again);
    EXPECT_EQ(again->study.places.size(), 1U);
    EXPECT_EQ(workbench().answerAs<ReviewAnswer>(), again) << "it was displayed";
    EXPECT_EQ(workbench().answer()->figures().front().value, counts.front().value);
    EXPECT_EQ(workbench().measured().size(), 1U) << "in place of what the file holds";
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ReviewAnswerWindow, OfAnotherRuleIsNotComputedUnasked) {
    review();
    ReviewChoice choice = window->review().choice();
    choice.rule = "four-days";
    window->review().choose(choice);
    saveAndOpenAgain();
    EXPECT_FALSE(window->review().running().busy());
    EXPECT_FALSE(window->review().shown());
    EXPECT_EQ(workbench().measured().size(), 1U);
}

TEST_F(ReviewAnswerWindow, WritesTheFilesOfAReviewAndThoseOfASavedOne) {
    review();
    const QString out = folder.filePath(QStringLiteral("out"));
    const auto write = [&] {
        workbench().exportShown(out.toStdString(), {});
        ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
    };
    write();
    for (const std::string& name : reviewFileNames())
        EXPECT_TRUE(QFile::exists(out + u'/' + QString::fromStdString(name))) << name;
    keep("Verdicts");
    showSaved("Verdicts");
    write();
    const auto words = readPrintedWords((out + QStringLiteral("/result.pdf")).toStdString());
    ASSERT_TRUE(words) << words.error().text();
    EXPECT_THAT(*words, HasSubstr("Places that pass"));
}

TEST_F(ReviewAnswerWindow, AgesWithTheBuildingsThatItCompares) {
    review();
    session().goTo("Tower");
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    const MeasuredAnswers measured = workbench().measured();
    ASSERT_EQ(measured.size(), 1U);
    EXPECT_FALSE(workbench().isOutdated(*measured[0]));
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    EXPECT_TRUE(workbench().isOutdated(*measured[0]));
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    EXPECT_FALSE(workbench().answerAs<ReviewAnswer>());
}

TEST_F(ReviewAnswerWindow, IsReplacedByOneOfTheSameRuleAndPlaces) {
    review();
    review();
    EXPECT_EQ(workbench().measured().size(), 1U);
    ReviewChoice choice = window->review().choice();
    choice.rule = "four-days";
    window->review().choose(choice);
    review();
    EXPECT_EQ(workbench().measured().size(), 2U);
}

TEST_F(ReviewAnswerWindow, OfAllScenariosIsListedBehindTheStudy) {
    study();
    window->review().runAll();
    ASSERT_TRUE(waitFor([this] { return !window->review().runningAll().busy(); }));
    EXPECT_TRUE(workbench().answerAs<Study>()) << "nobody asked to see one of them";
    EXPECT_EQ(workbench().measured().size(), 2U);
}

struct GlazingAnswerWindow : test::GlazingReviewWindow {};

TEST_F(GlazingAnswerWindow, OfWindowsIsShownSavedAndExportedTheSameWay) {
    build();
    run();
    const auto answer = workbench().answer();
    ASSERT_TRUE(workbench().answerAs<GlazingAnswer>()) << message().toStdString();
    EXPECT_THAT(formatText(answer->page({}).headline), HasSubstr("EN 17037"));
    workbench().saveAnswer(QStringLiteral("Windows"));
    ASSERT_TRUE(waitFor([this] { return session().project().results.size() == 1; }));
    const auto saved = readSaved(session().project().results[0], session().project());
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_EQ(formatText((*saved)->page({}).headline), formatText(answer->page({}).headline));
    ASSERT_EQ((*saved)->figures().size(), answer->figures().size());
    for (std::size_t i = 0; i < answer->figures().size(); ++i)
        EXPECT_EQ((*saved)->figures()[i].value, answer->figures()[i].value);
    const QString out = folder.filePath(QStringLiteral("out"));
    workbench().exportShown(out.toStdString(), {});
    ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
    for (const std::string& name : glazingFileNames())
        EXPECT_TRUE(QFile::exists(out + u'/' + QString::fromStdString(name))) << name;
}

// Whoever adds a question to the list cannot forget where it comes back.
TEST(AllQuestions, AreNamedComputedAndComeBackFromAProject) {
    for (const Question* question : allQuestions()) {
        EXPECT_FALSE(question->label.empty()) << question->key;
        EXPECT_TRUE(question->compute) << question->key;
        const bool isKnown =
            std::ranges::find(savedKinds(), question->key, &SavedKind::kind) != savedKinds().end();
        EXPECT_TRUE(isKnown ? question->saved.has_value() : !question->figures.empty())
            << question->key << " comes back as nothing";
        EXPECT_TRUE(question->help.empty() || !question->fileNames.empty()) << question->key;
    }
}

}  // namespace
}  // namespace noonmark
