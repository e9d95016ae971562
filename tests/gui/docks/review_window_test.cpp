#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QUndoStack>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/export/export_dialog.h"
#include "app/gui/docks/review/chart_panels.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/review_form.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/gui/docks/sheets/book_view.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/report/files/answer_files.h"
#include "core/engines/auto_engine.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::newTower;
using test::square;
using test::waitFor;

std::vector<std::string> namesOf(const std::vector<Place>& places) {
    std::vector<std::string> names;
    for (const Place& place : places) names.push_back(place.name);
    return names;
}

/// The small project with a park north of the new tower, which stands at (20, 20) and is 70 m high, and a
/// park that no shadow reaches.
struct ReviewWindow : test::ProjectWindow {
    void SetUp() override {
        ProjectWindow::SetUp();
        StudySettings study = workbench().document().settings();
        study.period.zone = "America/New_York";
        workbench().document().change(study, QStringLiteral("zone"));
    }
    void addPlaces() {
        Project next = session().project();
        next.places.push_back({"Park", PlaceKind::park, {square({10, 60}, 40)}, "drawn"});
        next.places.push_back({"Far park", PlaceKind::park, {square({3000, -3000}, 30)}, "drawn"});
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("places")));
    }
    ReviewSession& review() { return window->review(); }
    ReviewDock& dock() { return *window->findChild<ReviewDock*>(); }
    ReviewForm& form() { return *window->findChild<ReviewForm*>(); }
    void showDock() {
        for (QDockWidget* one : window->findChildren<QDockWidget*>())
            if (one->isAncestorOf(&dock()) || one->isAncestorOf(&form())) one->show(), one->raise();
        ASSERT_TRUE(waitFor([this] { return dock().isVisible() && form().isVisible(); }));
    }
    void choose(const std::string& rule) {
        ReviewChoice choice = review().choice();
        choice.rule = rule;
        review().choose(choice);
    }
    void run() {
        review().run();
        ASSERT_TRUE(waitFor([this] { return !review().running().busy(); }));
    }
    QString state() { return dock().findChild<QLabel*>(QStringLiteral("reviewState"))->text(); }
};

TEST_F(ReviewWindow, TheEmptyDockSaysWhatToDoNext) {
    showDock();
    EXPECT_TRUE(state().contains(QStringLiteral("no places yet"))) << state().toStdString();
    addPlaces();
    EXPECT_TRUE(state().contains(QStringLiteral("as the city stands"))) << state().toStdString();
    build();
    EXPECT_TRUE(state().contains(QStringLiteral("Press Run review"))) << state().toStdString();
}

// The far park has sun all day: it passes a rule about the sun that is left; nothing is compared.
TEST_F(ReviewWindow, APlaceIsDrawnFromItsPanelWithAKindOfTheRule) {
    choose("ceqr");
    showDock();
    auto& kind = *form().findChild<QComboBox*>(QStringLiteral("drawnKind"));
    const int plaza = kind.findData(int(PlaceKind::plaza));
    ASSERT_GE(plaza, 0);
    EXPECT_EQ(kind.findData(int(PlaceKind::street)), -1) << "the rule is not about streets";
    kind.setCurrentIndex(plaza);
    form().findChild<QPushButton*>(QStringLiteral("drawReviewPlace"))->click();
    PolygonTool& tool = window->panel().placeTool();
    ASSERT_TRUE(tool.active());
    for (const glm::dvec3 corner : {glm::dvec3(0, 100, 0), {40, 100, 0}, {40, 140, 0}}) tool.addPoint(corner);
    tool.finish();
    ASSERT_EQ(session().project().places.size(), 1U);
    EXPECT_EQ(session().project().places[0].kind, PlaceKind::plaza);
    auto& list = *form().findChild<QListWidget*>(QStringLiteral("reviewPlaces"));
    ASSERT_EQ(list.count(), 1);
    list.item(0)->setText(QStringLiteral("Market"));  // typed in its row
    EXPECT_EQ(session().project().places[0].name, "Market");
    EXPECT_EQ(list.item(0)->checkState(), Qt::Checked);
    list.item(0)->setText(QString());
    EXPECT_EQ(list.item(0)->text(), QStringLiteral("Market")) << "a place has a name";
}

// Places that are found in reach, or added, move the rows while a name is being typed.
TEST_F(ReviewWindow, ANameThatIsBeingTypedStaysWithItsPlace) {
    choose("ceqr");
    showDock();
    Project next = session().project();
    next.places.push_back({"Near park", PlaceKind::park, {square({10, 60}, 40)}, "drawn"});
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("place")));
    form().takeDrawn("Near park");
    auto& list = *form().findChild<QListWidget*>(QStringLiteral("reviewPlaces"));
    const auto typing = [&] { return qobject_cast<QLineEdit*>(list.indexWidget(list.currentIndex())); };
    ASSERT_NE(typing(), nullptr);
    typing()->setText(QStringLiteral("Mark"));
    addPlaces();  // "Far park" comes before it
    ASSERT_EQ(list.count(), 3);
    ASSERT_NE(typing(), nullptr);
    EXPECT_EQ(typing()->text(), QStringLiteral("Mark"));
    EXPECT_EQ(list.currentItem()->text(), QStringLiteral("Near park"));
    Q_EMIT list.itemDelegate()->commitData(typing());
    EXPECT_EQ(namesOf(session().project().places), (std::vector<std::string>{"Mark", "Park", "Far park"}));
}

TEST_F(ReviewWindow, TheExistingCityIsReviewedAsItStands) {
    showDock();
    addPlaces();
    choose("bre-209-amenity");
    run();
    const auto shown = review().shown();
    ASSERT_TRUE(shown) << message().toStdString();
    EXPECT_EQ(shown->question.from, shown->question.to);
    ASSERT_EQ(shown->study.places.size(), 2U);
    EXPECT_EQ(shown->study.places[1].verdict, Verdict::pass);
    EXPECT_EQ(shown->study.places[0].totals.incrementalM2h, 0);
    EXPECT_TRUE(state().contains(QStringLiteral("as it stands"))) << state().toStdString();
    review().screen();
    EXPECT_TRUE(message().contains(QStringLiteral("Baseline and scenario are the same")));
    EXPECT_EQ(review().question()->places.size(), 2U) << "no place is unticked";
}

TEST_F(ReviewWindow, VerdictsAndNumbersAreThoseOfTheReview) {
    showDock();
    addPlaces();
    build();
    choose("ceqr");
    run();
    const auto shown = review().shown();
    ASSERT_TRUE(shown) << message().toStdString();
    ASSERT_EQ(shown->study.places.size(), 2U);
    NoProgress progress;
    const auto question = review().question();
    ASSERT_TRUE(question);
    const auto expected =
        runReview(question->rule, *session().cityOf(existingCity).value(), *session().city(),
                  session().project().places, question->settings, AutoEngine(), progress, {});
    ASSERT_TRUE(expected);
    VerdictTable& table = dock().table();
    ASSERT_EQ(table.topLevelItemCount(), 2);
    for (int i = 0; i < 2; ++i) {
        const PlaceReview& place = expected->places[std::size_t(i)];
        EXPECT_EQ(shown->study.places[std::size_t(i)].verdict, place.verdict);
        EXPECT_TRUE(table.topLevelItem(i)->text(1).endsWith(QString::fromUtf8(nameOf(place.verdict).data())));
        EXPECT_EQ(table.topLevelItem(i)->childCount(), 4);  // the rule's days
    }
    EXPECT_EQ(table.topLevelItem(0)->text(0), QStringLiteral("Park"));  // has the incremental shadow
    const QTreeWidgetItem* day = table.topLevelItem(0)->child(0);
    EXPECT_EQ(day->text(0), QLocale().toString(dateOf(expected->places[0].rows[0].day), dayOfYear()));
    const QRegularExpression isoDate(QStringLiteral("[0-9]{4}-[0-9]{2}-[0-9]{2}"));
    EXPECT_FALSE(table.topLevelItem(0)->toolTip(0).contains(isoDate));
    EXPECT_GT(expected->places[0].totals.incrementalM2h, 0);  // at noon the shadow falls on the park
    EXPECT_EQ(expected->places[1].totals.incrementalM2h, 0);
    dock().copyTable();
    const QString copied = QGuiApplication::clipboard()->text();
    EXPECT_EQ(copied.count(u'\n'), 1 + 2 * 4);
    EXPECT_TRUE(copied.contains(QString::fromStdString(expected->places[0].rows[0].entersText)));
}

TEST_F(ReviewWindow, PlacesHaveTheColoursOfTheirVerdictsInTheModeReview) {
    addPlaces();
    build();
    choose("ceqr");
    run();
    ResultLayer& layer = window->panel().results();
    EXPECT_FALSE(layer.showsVerdicts()) << "Now shows no verdicts";
    window->mode().setMode(ViewMode::review);
    EXPECT_TRUE(dock().isVisible()) << "the mode opens its panel";
    ASSERT_TRUE(layer.showsVerdicts());
    ASSERT_TRUE(window->panel().legend().legend());
    EXPECT_EQ(window->panel().legend().legend()->title, QStringLiteral("Verdicts on places"));
    const QString told = layer.minutesAt(Pick{.position = {20, 70, 0}});
    EXPECT_TRUE(told.startsWith(QStringLiteral("Park "))) << told.toStdString();
    window->mode().setMode(ViewMode::analysis);
    EXPECT_FALSE(layer.showsVerdicts());
}

TEST_F(ReviewWindow, ARowShowsTheTimelineOfItsDayWithTheSameFigures) {
    showDock();
    addPlaces();
    build();
    choose("ceqr");
    run();
    ASSERT_TRUE(review().shown());
    const PlaceReview& park = review().shown()->study.places[0];
    QTreeWidgetItem* place = dock().table().topLevelItem(0);
    for (int i = 0; i < place->childCount(); ++i) {
        dock().table().setCurrentItem(place->child(i));
        ASSERT_TRUE(waitFor([this] { return !dock().day().working().busy(); }));
        double largest = 0;
        for (const auto& sample : dock().day().chart().samples)
            largest = std::max(largest, sample.incrementalM2);
        EXPECT_DOUBLE_EQ(largest, park.rows[std::size_t(i)].maxAreaM2) << i;
        EXPECT_EQ(dock().day().chart().areaM2, park.areaM2);
    }
}

TEST_F(ReviewWindow, ScreeningTicksThePlacesInReachOnly) {
    showDock();
    addPlaces();
    build();
    choose("ceqr");
    review().screen();
    ASSERT_TRUE(waitFor([this] { return !review().running().busy(); }));
    ASSERT_TRUE(review().reach());
    EXPECT_EQ(namesOf(review().reach()->kept->places), std::vector<std::string>{"Park"});
    EXPECT_FALSE(review().reach()->reasons.at("Far park").empty());
    run();
    EXPECT_EQ(review().shown()->study.places.size(), 1U);
    EXPECT_TRUE(review().whyOutdated().isEmpty());
}

// A lower tower whose shadow ends before the park: which places are in reach is found anew.
TEST_F(ReviewWindow, PlacesInReachAreThoseOfTheProposalThatIsReviewed) {
    showDock();
    addPlaces();
    build();
    choose("ceqr");
    review().screen();
    run();
    ASSERT_TRUE(review().shown()) << message().toStdString();
    EXPECT_EQ(namesOf(review().shown()->question.places), std::vector<std::string>{"Park"});
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 2}}, QStringLiteral("height")));
    EXPECT_FALSE(review().reach()) << "another proposal";
    EXPECT_TRUE(review().whyOutdated().contains(QStringLiteral("buildings")));
    run();
    EXPECT_TRUE(message().contains(QStringLiteral("reaches no place"))) << message().toStdString();
}

// More places than anyone reads: those in reach are found first, without being asked, and the files say how.
TEST_F(ReviewWindow, OfManyPlacesThoseInReachAreReviewed) {
    showDock();
    addPlaces();
    Project next = session().project();
    for (int i = 0; i < 60; ++i)
        next.places.push_back({"Field " + std::to_string(i),
                               PlaceKind::park,
                               {square({4000 + 50 * float(i), -3000}, 30)},
                               "drawn"});
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("places")));
    build();
    choose("ceqr");
    run();
    ASSERT_TRUE(review().shown()) << message().toStdString();
    const ReviewQuestion& asked = review().shown()->question;
    EXPECT_EQ(namesOf(asked.places), std::vector<std::string>{"Park"});
    EXPECT_EQ(asked.named, std::vector<std::string>{"all"});
    EXPECT_TRUE(asked.inReach);
    ASSERT_EQ(asked.warnings.size(), 61U);
    EXPECT_EQ(asked.warnings[0].where, "Far park");
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 2}}, QStringLiteral("height")));
    run();
    EXPECT_EQ(review().shown()->question.places.size(), 62U) << "its shadow reaches none: all are stated";
    workbench().document().undoStack().undo();
    form().findChild<QPushButton*>(QStringLiteral("allPlacesToReview"))->click();
    EXPECT_FALSE(review().whyOutdated().isEmpty());
    EXPECT_EQ(review().question()->places.size(), 62U);
}

TEST_F(ReviewWindow, InANarrowWindowItsVerdictsBelowAreTheAnswer) {
    window->resize(1366, 768);
    addPlaces();
    build();
    choose("ceqr");
    window->mode().setMode(ViewMode::review);
    ASSERT_TRUE(waitFor([this] { return dock().isVisible() && form().isVisible(); }));
    const int asked = form().width();
    run();
    ASSERT_TRUE(review().shown()) << message().toStdString();
    QCoreApplication::processEvents();
    EXPECT_TRUE(window->findChild<QDockWidget*>(QStringLiteral("resultsDock"))->isHidden());
    EXPECT_EQ(form().width(), asked);
}

TEST_F(ReviewWindow, VerdictsFollowTheBuildingThatIsShapedUntilItIsBuilt) {
    showDock();
    addPlaces();
    choose("ceqr");
    EditPreview& preview = window->tools().context().preview;
    for (const float height : {30.F, 50.F, 90.F}) ASSERT_TRUE(preview.show({newTower("New", height)}));
    ASSERT_TRUE(waitFor([this] { return review().isLive() && !review().following().busy(); }));
    NoProgress progress;
    const auto& live = *review().shown();
    const auto expected =
        runReview(live.question.rule, *session().city(), *live.question.after, session().project().places,
                  live.question.settings, AutoEngine(), progress, {});
    ASSERT_TRUE(expected);
    EXPECT_EQ(live.question.after->buildings.back()->parts[0].topM, 90);  // the newest shape
    EXPECT_EQ(live.study.places[0].totals.incrementalM2h, expected->places[0].totals.incrementalM2h);
    EXPECT_GT(live.study.places[0].totals.incrementalM2h, 0);
    EXPECT_TRUE(state().contains(QStringLiteral("Follows the building")));
    preview.clear();
    EXPECT_FALSE(review().isLive());
}

TEST_F(ReviewWindow, ARuleOfAYearDoesNotFollowAndIsMarkedAsNotUpToDate) {
    showDock();
    addPlaces();
    build();
    ReviewChoice choice = review().choice();
    choice.rule = "san-francisco-295";
    choice.reviewed = ReviewedPlaces::chosen;
    choice.places = {"Park"};
    review().choose(choice);
    run();
    ASSERT_TRUE(review().shown()) << message().toStdString();
    EXPECT_TRUE(review().whyOutdated().isEmpty());
    EditPreview& preview = window->tools().context().preview;
    ASSERT_TRUE(preview.show({newTower("Other", 50)}) || preview.show({ChangeHeight{"New", 50}}));
    EXPECT_FALSE(review().isLive());
    EXPECT_FALSE(review().following().busy());
    EXPECT_TRUE(state().contains(QStringLiteral("Not up to date"))) << state().toStdString();
    preview.clear();
    EXPECT_TRUE(review().whyOutdated().isEmpty());
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 50}}, QStringLiteral("height")));
    EXPECT_TRUE(review().whyOutdated().contains(QStringLiteral("buildings")));
}

TEST_F(ReviewWindow, ARangeOfDaysHasACarpet) {
    showDock();
    addPlaces();
    build();
    choose("vancouver");
    ASSERT_TRUE(review().rule());
    run();
    ASSERT_TRUE(review().shown());
    dock().table().setCurrentItem(dock().table().topLevelItem(0));
    ASSERT_FALSE(hasFewDays(review().shown()->question.rule));
    dock().findChild<QTabWidget*>()->setCurrentWidget(&dock().range());
    ASSERT_TRUE(waitFor([this] { return dock().range().carpet().rows > 0; }));
    EXPECT_GT(dock().range().carpet().days.size(), 20U);
}

TEST_F(ReviewWindow, UnitsOfTheProjectAreShownAtOnce) {
    showDock();
    addPlaces();
    build();
    choose("boston-midtown");
    run();
    ASSERT_TRUE(review().shown()) << message().toStdString();
    VerdictTable& table = dock().table();
    const auto titleOf = [&](const QString& unit) {
        for (int i = 0; i < table.columnCount(); ++i)
            if (table.headerItem()->text(i).simplified() == QStringLiteral("Largest area, ") + unit) return i;
        return -1;
    };
    const auto setUnits = [&](UnitSystem units) {
        Project next = session().project();
        next.sheets.units = units;
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("units")));
    };
    const auto* reading = dock().findChild<QLabel*>(QStringLiteral("timelineReading"));
    ASSERT_TRUE(waitFor([&] { return !dock().day().working().busy() && !reading->text().isEmpty(); }));
    const int metric = titleOf(QStringLiteral("m²")), columns = table.columnCount();
    ASSERT_GE(metric, 0);
    setUnits(UnitSystem::imperial);
    EXPECT_EQ(titleOf(QStringLiteral("m²")), -1);
    EXPECT_EQ(titleOf(QStringLiteral("sq ft")), metric);
    EXPECT_EQ(table.columnCount(), columns);
    EXPECT_EQ(dock().day().chart().units, UnitSystem::imperial);
    EXPECT_FALSE(reading->text().contains(QStringLiteral("m²"))) << reading->text().toStdString();
    setUnits(UnitSystem::both);
    EXPECT_EQ(titleOf(QStringLiteral("sq ft")), titleOf(QStringLiteral("m²")) + 1);
    EXPECT_EQ(table.columnCount(), columns + 1);
    setUnits(UnitSystem::metric);
    EXPECT_EQ(titleOf(QStringLiteral("m²")), metric);
}

TEST_F(ReviewWindow, TheChoiceIsSavedWithTheProjectAndFollowsRenaming) {
    addPlaces();
    build();
    ReviewChoice choice{.rule = "japan",
                        .options = {},
                        .from = existingCity,
                        .to = session().scenario(),
                        .reviewed = ReviewedPlaces::chosen,
                        .places = {"Park"}};
    review().choose(choice);
    ASSERT_TRUE(session().rename(ProjectPart::place, "Park", "Green"));
    ASSERT_TRUE(session().rename(ProjectPart::scenario, session().scenario(), "Slim"));
    choice.places = {"Green"};
    choice.to = "Slim";
    EXPECT_EQ(review().choice(), choice);
    save();
    makeWindow();
    open(file);
    EXPECT_EQ(review().choice(), choice);
    EXPECT_EQ(parseReviewChoice("{\"rule\": 3}"), ReviewChoice{});
    EXPECT_EQ(parseReviewChoice(R"({"rule": "ceqr", "options": {}, "from": "Existing", "to": "",
                                    "all_places": true, "places": []})")
                  .reviewed,
              ReviewedPlaces::all)
        << "of a project of an earlier version";
    EXPECT_EQ(parseReviewChoice(formatText(choice)), choice);
}

struct SheetsWindow : ReviewWindow {
    void SetUp() override {
        ReviewWindow::SetUp();
        showDock();
        addPlaces();
        build();
        choose("ceqr");
    }
    QPushButton& exportButton() { return *dock().findChild<QPushButton*>(QStringLiteral("exportReview")); }
    QUndoStack& undo() { return workbench().document().undoStack(); }
    ExportDialog& showSheets() {
        run();
        exportButton().click();
        auto& sheets = *window->findChild<ExportDialog*>();
        EXPECT_TRUE(waitFor([&] { return !sheets.busy() && !sheets.pages().picture().isNull(); }));
        return sheets;
    }
    void edit(ExportDialog& sheets, const char* field, const QString& text) {
        auto* line = sheets.findChild<QLineEdit*>(QString::fromLatin1(field));
        line->setText(text);
        Q_EMIT line->editingFinished();
        EXPECT_TRUE(waitFor([&] { return !sheets.busy() && !sheets.pages().busy(); }));
    }
};

TEST_F(SheetsWindow, AReviewThatWasNotRunHasNone) {
    ASSERT_TRUE(QMetaObject::invokeMethod(&dock(), "exportRequested"));
    EXPECT_TRUE(message().contains(QStringLiteral("no review to export"))) << message().toStdString();
    EXPECT_EQ(window->findChild<ExportDialog*>(), nullptr);
}

TEST_F(SheetsWindow, PagesAreShownAndTheFilesAreThoseOfTheCommandLine) {
    ExportDialog& sheets = showSheets();
    const QImage first = sheets.pages().picture();
    sheets.pages().showPage(1);
    ASSERT_TRUE(waitFor([&] { return !sheets.pages().picture().isNull(); }));
    EXPECT_NE(sheets.pages().picture(), first);
    sheets.findChild<QLineEdit*>(QStringLiteral("exportFolder"))
        ->setText(folder.filePath(QStringLiteral("out")));
    sheets.findChild<QPushButton*>(QStringLiteral("exportWrite"))->click();
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
    for (const std::string& name : reviewFileNames())
        EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("out/") + QString::fromStdString(name))))
            << name;
    const QByteArray record = test::bytesOf(folder.filePath(QStringLiteral("out/review.json")));
    EXPECT_TRUE(record.contains("\"rule\": \"ceqr\""));
}

/// Whether the dialog moved or changed its size once its sheets were there.
struct MovesWithSheets final : QObject {
    ExportDialog& dialog;
    bool moved = false;
    explicit MovesWithSheets(ExportDialog& watched) : dialog(watched) { watched.installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
        const bool moves = event->type() == QEvent::Resize || event->type() == QEvent::Move;
        moved |= moves && dialog.pages().hasPages();
        return false;
    }
};

TEST_F(SheetsWindow, TheDialogHasItsSizeBeforeTheSheetsCome) {
    run();
    exportButton().click();
    auto& sheets = *window->findChild<ExportDialog*>();
    const MovesWithSheets moves(sheets);
    ASSERT_TRUE(waitFor([&] { return !sheets.busy() && !sheets.pages().picture().isNull(); }));
    EXPECT_TRUE(sheets.pages().isVisible());
    EXPECT_FALSE(moves.moved) << "a field moves away from the cursor";
}

TEST_F(SheetsWindow, TheTitleBlockIsSavedInTheProjectAndCanBeUndone) {
    ExportDialog& sheets = showSheets();
    const QImage before = sheets.pages().picture();
    edit(sheets, "client", QStringLiteral("City of Rotterdam"));
    EXPECT_EQ(session().project().sheets.titleBlock.client, "City of Rotterdam");
    EXPECT_NE(sheets.pages().picture(), before);
    undo().undo();
    ASSERT_TRUE(waitFor([&] { return !sheets.busy() && !sheets.pages().busy(); }));
    EXPECT_EQ(session().project().sheets.titleBlock.client, "");
    EXPECT_EQ(sheets.pages().picture(), before);
    EXPECT_EQ(sheets.findChild<QLineEdit*>(QStringLiteral("client"))->text(), QString());
}

TEST_F(SheetsWindow, PaperAndScaleAreThoseChosen) {
    ExportDialog& sheets = showSheets();
    BookSettings settings = sheets.form().settings();
    settings.setup = {Paper::a3, true};
    settings.scale = 1250;
    sheets.form().show(settings);
    EXPECT_EQ(sheets.form().settings().setup, settings.setup);
    EXPECT_EQ(sheets.form().settings().scale, 1250);
    Q_EMIT sheets.form().edited();
    ASSERT_TRUE(waitFor([&] { return !sheets.busy() && !sheets.pages().picture().isNull(); }));
    EXPECT_GT(sheets.pages().picture().width(), sheets.pages().picture().height());
    EXPECT_FALSE(sheets.form().takeLogo(folder.filePath(QStringLiteral("missing.png"))));
}

TEST_F(SheetsWindow, HowMuchTheyHoldIsThatChosen) {
    ExportDialog& sheets = showSheets();
    EXPECT_FALSE(sheets.form().settings().allPages);
    BookSettings settings = sheets.form().settings();
    settings.allPages = true;
    settings.minPlaceM2 = 250;
    sheets.form().show(settings);
    EXPECT_TRUE(sheets.findChild<QWidget*>(QStringLiteral("allPages"))->isVisible());
    EXPECT_TRUE(sheets.form().settings().allPages);
    EXPECT_EQ(sheets.form().settings().minPlaceM2, 250);
}

}  // namespace
}  // namespace noonmark
