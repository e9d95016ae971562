#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFocusEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>

#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/export/table_text.h"
#include "app/gui/docks/study_form/element_form.h"
#include "app/gui/docks/study_form/line_form.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/session/project/view_state.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/tools/editing/building_editing.h"
#include "core/study/elements/element_tables.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The window with a study at points of facades.
struct ElementsWindow : test::AnswersWindow {
    void choose(const ElementSettings& elements) {
        workbench().document().change(workbench().document().settings(), elements, QStringLiteral("points"));
    }
    void measure() {
        const auto before = workbench().answerAs<ElementAnswer>();
        workbench().run();
        ASSERT_TRUE(waitFor([&] {
            return workbench().answerAs<ElementAnswer>() && workbench().answerAs<ElementAnswer>() != before;
        })) << window->panel().messages().text().toStdString();
    }
    ElementsDock& dock() { return *window->findChild<ElementsDock*>(); }
    QAbstractItemModel& rows() { return *table().model(); }
    QTableView& table() { return *dock().findChild<QTableView*>(QStringLiteral("elementTable")); }
    ElementTiles& tiles() { return window->panel().view().tiles(); }
    template <class Field>
    Field& field(const char* name) {
        const QString wanted = QString::fromLatin1(name);  // the review dock has some of the same
        auto* ofStudy = window->findChild<StudyDock*>()->findChild<Field*>(wanted);
        return ofStudy != nullptr ? *ofStudy : *window->findChild<Field*>(wanted);
    }
    void choosePlaces(int entry) {
        auto& list = field<QComboBox>("places");
        list.setCurrentIndex(entry);
        Q_EMIT list.activated(entry);
    }
};

TEST_F(ElementsWindow, TheFormChoosesPointsAndForecastsTheirNumber) {
    choosePlaces(3);
    ASSERT_TRUE(workbench().document().elements());
    EXPECT_EQ(workbench().document().elements()->places, ElementPlaces::facades);
    EXPECT_TRUE(field<QLineEdit>("facadesOf").isVisibleTo(window->findChild<StudyDock*>()));
    EXPECT_FALSE(field<QLineEdit>("windowsFile").isVisibleTo(window->findChild<StudyDock*>()));
    field<QDoubleSpinBox>("storey").setValue(5);
    EXPECT_EQ(workbench().document().elements()->facades.storeyM, 5);
    const RunForecast& forecast = window->findChild<StudyDock*>()->forecast();
    ASSERT_TRUE(waitFor([&] { return forecast.estimate().has_value(); }));
    EXPECT_TRUE(forecast.estimate()->points);
    const double all = forecast.estimate()->receivers;
    window->tools().building().select(0);
    EXPECT_EQ(field<QPushButton>("facadesOfSelected").text(), QStringLiteral("Add selected"));
    field<QPushButton>("facadesOfSelected").click();
    EXPECT_EQ(workbench().document().elements()->buildings.size(), 1U);
    ASSERT_TRUE(waitFor([&] { return forecast.estimate().has_value(); }));
    EXPECT_LT(forecast.estimate()->receivers, all);
    choosePlaces(5);
    EXPECT_GT(workbench().document().elements()->planeHeightM, 0) << "a plane on the ground is a study of it";
    choosePlaces(0);
    EXPECT_FALSE(workbench().document().elements());
    workbench().document().undoStack().undo();
    EXPECT_TRUE(workbench().document().elements());
}

TEST_F(ElementsWindow, FacadesAreNarrowedDownByWhatTheyFace) {
    choose({});
    measure();
    const std::size_t all = workbench().answerAs<ElementAnswer>()->map.elements.size();
    auto& direction = field<QComboBox>("facingDirection");
    direction.setCurrentIndex(3);
    Q_EMIT direction.activated(3);
    ASSERT_TRUE(workbench().document().elements()->faces.facing);
    EXPECT_EQ(*workbench().document().elements()->faces.facing, (AzimuthRange{135, 225}));
    measure();
    EXPECT_LT(workbench().answerAs<ElementAnswer>()->map.elements.size(), all / 3);
    for (const MeasuredElement& element : workbench().answerAs<ElementAnswer>()->map.elements)
        EXPECT_NEAR(element.azimuthDeg, 180, 45.1);
    field<QDoubleSpinBox>("facingFrom").setValue(100);
    EXPECT_EQ(workbench().document().elements()->faces.facing->fromDeg, 100);
    EXPECT_EQ(direction.currentIndex(), 5) << "another range than those of the list";
    workbench().document().undoStack().undo();
    EXPECT_EQ(direction.currentIndex(), 3);
}

TEST_F(ElementsWindow, AClickOnAWallPicksItsFace) {
    choose({});
    measure();
    Q_EMIT dock().goToRequested(20);
    const CityView& view = window->panel().view();
    const MeasuredElement middle = workbench().answerAs<ElementAnswer>()->map.elements[20];
    window->show();
    field<QPushButton>("pickFace").setChecked(true);
    const auto pixel = pixelOf(view.pose(), view.lens(), glm::dvec3(middle.position));
    ASSERT_TRUE(pixel);
    Q_EMIT window->panel().navigator().clicked(QPointF(pixel->x, pixel->y));
    const std::vector<std::string> faces = workbench().document().elements()->faces.faces;
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_TRUE(middle.id.starts_with(faces[0] + " floor ")) << faces[0] << " of " << middle.id;
    field<QPushButton>("pickFace").setChecked(false);
    measure();
    for (const MeasuredElement& element : workbench().answerAs<ElementAnswer>()->map.elements)
        EXPECT_TRUE(element.id.starts_with(faces[0] + " floor "));
}

TEST_F(ElementsWindow, ProposedBuildingsAreThoseOfTheScenario) {
    choose({.proposed = true});
    session().goTo("Tower");
    ASSERT_TRUE(waitFor([&] { return workbench().city()->city().buildings.size() == 4; }));
    EXPECT_TRUE(field<QCheckBox>("proposedOnly").isChecked());
    measure();
    for (const MeasuredElement& element : workbench().answerAs<ElementAnswer>()->map.elements)
        EXPECT_EQ(element.building, "New");
}

TEST_F(ElementsWindow, LinesRunAroundALotOfTheProject) {
    choosePlaces(6);
    auto& parcel = field<QComboBox>("parcel");
    EXPECT_EQ(parcel.findText(QStringLiteral("Yard")), 0);
    parcel.setCurrentIndex(0);
    Q_EMIT parcel.activated(0);
    EXPECT_EQ(workbench().document().elements()->parcel, "Yard");
    auto& offsets = field<QLineEdit>("lineOffsets");
    offsets.setText(QStringLiteral("7 ; 2.5"));
    Q_EMIT offsets.editingFinished();
    EXPECT_EQ(workbench().document().elements()->lines.offsetsM, (std::vector<double>{7, 2.5}));
    offsets.setText(QStringLiteral("far"));
    Q_EMIT offsets.editingFinished();
    EXPECT_EQ(offsets.text(), QStringLiteral("7 m, 2.5 m")) << "the last distances";
    measure();
    EXPECT_TRUE(workbench().answerAs<ElementAnswer>()->map.elements.front().id.starts_with("7 m, "));
}

TEST_F(ElementsWindow, SinglePointsAreTypedOrClicked) {
    choosePlaces(7);
    const LonLat at = workbench().city()->city().frame.lonLatFromLocal({0, 0});
    auto& list = field<QPlainTextEdit>("pointList");
    list.setPlainText(QStringLiteral("%1,%2,30").arg(at.lonDeg, 0, 'f', 7).arg(at.latDeg, 0, 'f', 7));
    QFocusEvent left(QEvent::FocusOut);
    QCoreApplication::sendEvent(&list, &left);
    ASSERT_EQ(workbench().document().elements()->points.size(), 1U);
    EXPECT_EQ(workbench().document().elements()->points[0].heightM, 30.0);
    window->findChild<StudyDock*>()->elements().list().add({{}, at, {}, {}});
    ASSERT_EQ(workbench().document().elements()->points.size(), 2U);
    EXPECT_EQ(workbench().document().elements()->points[1].id, "point 2");
    measure();
    EXPECT_EQ(workbench().answerAs<ElementAnswer>()->map.elements.size(), 2U);
    list.setPlainText(QStringLiteral("somewhere"));
    QCoreApplication::sendEvent(&list, &left);
    EXPECT_EQ(workbench().document().elements()->points.size(), 2U) << "what is wrong is not taken";
    EXPECT_EQ(list.toPlainText(), QStringLiteral("somewhere")) << "and can be mended";
}

TEST(ElementSettingsJson, IsReadAsItIsWritten) {
    ElementSettings elements{.places = ElementPlaces::lines, .buildings = {"a"}, .proposed = true};
    elements.faces = {{"a wall 2"}, AzimuthRange{315, 45}, "Park", 250};
    elements.parcel = "Yard";
    elements.lines = {{2.5, 7}, 0.5};
    elements.points = {{"p", {-73.98, 40.75}, 4.5, 180.0}};
    const auto json = elementSettingsJson(elements);
    EXPECT_EQ(elementSettingsFrom(json), elements);
    auto earlier = json;
    for (const char* key : {"proposed", "faces", "facing_deg", "facing_place", "within_m", "parcel",
                            "offsets_m", "spacing_m", "points"})
        earlier.erase(key);
    ASSERT_TRUE(elementSettingsFrom(earlier)) << "of a project of an earlier version";
    EXPECT_TRUE(elementSettingsFrom(earlier)->faces.takesAll());
    auto wrong = json;
    wrong["spacing_m"] = 0;
    EXPECT_FALSE(elementSettingsFrom(wrong));
}

TEST_F(ElementsWindow, ARunPaintsTilesAndFillsTheTable) {
    choose({});
    measure();
    const ElementMap& map = workbench().answerAs<ElementAnswer>()->map;
    ASSERT_GT(map.elements.size(), 100U);
    EXPECT_NE(workbench().answerAs<ElementAnswer>(), nullptr);
    EXPECT_EQ(window->mode().mode(), ViewMode::analysis);
    EXPECT_EQ(tiles().tiles().size(), map.elements.size());
    EXPECT_EQ(std::size_t(rows().rowCount()), map.elements.size());
    ASSERT_TRUE(window->panel().legend().legend());
    EXPECT_GE(window->panel().legend().legend()->scale.top, map.possibleMin);
    EXPECT_TRUE(figures().contains(QStringLiteral("Mean sun")));
    for (const ElementTiles::Tile& tile : {tiles().tiles().front(), tiles().tiles().back()})
        EXPECT_LE(glm::distance(tile.corners[0], tile.corners[2]), 4 * 1.5F) << "a bay of a storey";
}

TEST_F(ElementsWindow, TheTableSortsFiltersCopiesAndPointsAtTheView) {
    choose({});
    measure();
    const ElementMap& map = workbench().answerAs<ElementAnswer>()->map;
    table().sortByColumn(ElementModel::sun, Qt::DescendingOrder);
    const double maximum =
        std::ranges::max_element(map.elements, {}, &MeasuredElement::sunlitMin)->sunlitMin / 60;
    EXPECT_EQ(rows().index(0, ElementModel::sun).data(ElementModel::valueRole).toDouble(), maximum);
    table().selectRow(0);
    ASSERT_EQ(tiles().highlighted().size(), 1U);
    EXPECT_EQ(map.elements[tiles().highlighted()[0]].sunlitMin / 60, maximum);
    field<QDoubleSpinBox>("elementBelow").setValue(0.5);
    const auto dark = std::ranges::count_if(map.elements, [](const auto& e) { return e.sunlitMin < 30; });
    EXPECT_EQ(rows().rowCount(), dark);
    EXPECT_EQ(makeTableText(rows()).count(QLatin1Char('\n')), dark + 1) << "what is copied";
    field<QLineEdit>("elementFilter").setText(QStringLiteral("no such building"));
    EXPECT_EQ(rows().rowCount(), 0);
    dock().select(7);
    EXPECT_EQ(dock().selected(), std::vector<std::size_t>{7}) << "a filter that hides it is emptied";
    EXPECT_EQ(tiles().highlighted(), std::vector<std::size_t>{7});
}

TEST_F(ElementsWindow, AClickOnATileFindsItsRow) {
    choose({});
    measure();
    Q_EMIT dock().goToRequested(20);
    const CityView& view = window->panel().view();
    const auto middle = workbench().answerAs<ElementAnswer>()->map.elements[20];
    const auto pixel = pixelOf(view.pose(), view.lens(), glm::dvec3(middle.position));
    ASSERT_TRUE(pixel);
    Q_EMIT window->panel().navigator().clicked(QPointF(pixel->x, pixel->y));
    EXPECT_EQ(dock().selected(), std::vector<std::size_t>{20});
    const auto pick = window->panel().navigator().pickAt(QPointF(pixel->x, pixel->y));
    ASSERT_TRUE(pick);
    const QString hover = window->panel().results().minutesAt(*pick);
    EXPECT_TRUE(hover.contains(QStringLiteral("h of sun a day"))) << hover.toStdString();
}

TEST_F(ElementsWindow, AnotherResultReplacesTheTiles) {
    choose({});
    measure();
    window->mode().setMode(ViewMode::exploration);
    EXPECT_TRUE(tiles().tiles().empty()) << "exploration shows its own colours";
    window->mode().setMode(ViewMode::analysis);
    EXPECT_FALSE(tiles().tiles().empty());
    workbench().document().change(workbench().document().settings(), std::nullopt, QStringLiteral("cells"));
    EXPECT_TRUE(note().contains(QStringLiteral("settings have changed"))) << note().toStdString();
    study();
    EXPECT_EQ(workbench().answerAs<ElementAnswer>(), nullptr);
    EXPECT_TRUE(tiles().tiles().empty());
    EXPECT_EQ(rows().rowCount(), 0);
}

TEST_F(ElementsWindow, TheFacadesOfATowerThatIsBuiltAreMeasured) {
    choose({});
    session().goTo("Tower");
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    measure();
    const auto& elements = workbench().answerAs<ElementAnswer>()->map.elements;
    const auto ofTower = std::ranges::count(elements, "New", &MeasuredElement::building);
    EXPECT_GT(ofTower, 20);
    const auto before = workbench().answerAs<ElementAnswer>();
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    ASSERT_TRUE(waitFor([&] {
        return workbench().answerAs<ElementAnswer>() && workbench().answerAs<ElementAnswer>() != before;
    })) << "a quick result is computed again";
    EXPECT_LT(std::ranges::count(workbench().answerAs<ElementAnswer>()->map.elements, "New",
                                 &MeasuredElement::building),
              ofTower / 2);
}

TEST_F(ElementsWindow, TheExportHasTheNumbersOfTheCommandLine) {
    choose({.buildings = {}, .facades = {.bayM = 8, .storeyM = 10, .aboveFloorM = 1}});
    measure();
    const QString out = folder.filePath(QStringLiteral("out"));
    EXPECT_EQ(workbench().filesOf({}).front(), QStringLiteral("elements.csv"));
    workbench().exportShown(out.toStdString(), {});
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
    ASSERT_TRUE(QFile::exists(out + QStringLiteral("/elements.gpkg")));
    ASSERT_TRUE(QFile::exists(out + QStringLiteral("/study.json")));
    NoProgress progress;
    auto alone = runElementStudy(*session().city(), workbench().document().settings(),
                                 *workbench().document().elements(), progress, {});
    ASSERT_TRUE(alone);
    QFile file(out + QStringLiteral("/elements.csv"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> written = file.readAll().trimmed().split('\n');
    const QList<QByteArray> expected =
        QByteArray::fromStdString(toCsv(makeElementTable(*alone))).trimmed().split('\n');
    ASSERT_EQ(written.size(), expected.size());
    for (qsizetype row = 0; row < written.size(); ++row)
        EXPECT_EQ(written[row].split(',').first(15), expected[row].split(',').first(15))
            << "all but where it comes from, which only the window's project states";
}

TEST_F(ElementsWindow, AFileOfWindowsThatIsMissingIsReported) {
    choose({.places = ElementPlaces::windows});
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !window->panel().messages().text().isEmpty(); }));
    EXPECT_EQ(workbench().answerAs<ElementAnswer>(), nullptr);
}

TEST_F(ElementsWindow, APlaneIsMeasuredAboveTheGround) {
    choose({.places = ElementPlaces::plane, .planeHeightM = 4});
    measure();
    const ElementMap& map = workbench().answerAs<ElementAnswer>()->map;
    EXPECT_NEAR(map.elements[0].position.z, workbench().answerAs<ElementAnswer>()->study.planeM, 1e-4);
    EXPECT_EQ(map.elements[0].pane.widthM(), 4) << "a cell";
    EXPECT_EQ(rows().index(0, ElementModel::facing).data().toString(), QString());
}

QList<QByteArray> linesOf(const QString& file) {
    QFile text(file);
    EXPECT_TRUE(text.open(QIODevice::ReadOnly)) << file.toStdString();
    return text.readAll().trimmed().split('\n');
}

TEST_F(ElementsWindow, ASavedStudyIsReadAgainWithItsTableAndFiles) {
    choose({.buildings = {}, .facades = {.storeyM = 4}});
    measure();
    const QString first = folder.filePath(QStringLiteral("first")),
                  again = folder.filePath(QStringLiteral("again"));
    keep("Facades");
    EXPECT_EQ(session().project().results.at(0)->kind, "elements");
    window->saving().save();
    ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    workbench().exportShown(first.toStdString(), {});
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
    const std::size_t points = tiles().tiles().size();
    const auto city = workbench().city();
    window->open({QString::fromStdString(session().file()->path().string())});
    ASSERT_TRUE(waitFor([&] { return workbench().city() != city; }));
    ASSERT_TRUE(waitFor([&] { return workbench().answerAs<ElementAnswer>() != nullptr; }))
        << "it was quick, and is repeated";
    ASSERT_TRUE(workbench().document().elements());
    EXPECT_EQ(workbench().document().elements()->facades.storeyM, 4) << "the form is as it was saved";
    showSaved("Facades");
    EXPECT_EQ(tiles().tiles().size(), points);
    EXPECT_EQ(std::size_t(rows().rowCount()), points);
    EXPECT_TRUE(figures().contains(QStringLiteral("Least sun")));
    EXPECT_TRUE(note().contains(QStringLiteral("Its inputs have not changed"))) << note().toStdString();
    EXPECT_TRUE(workbench().filesOf({}).contains(QStringLiteral("result.json")));
    workbench().exportShown(again.toStdString(), {});
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
    const auto before = linesOf(first + QStringLiteral("/elements.csv")),
               after = linesOf(again + QStringLiteral("/elements.csv"));
    ASSERT_EQ(before.size(), after.size());
    for (qsizetype row = 0; row < before.size(); ++row)
        EXPECT_EQ(before[row].split(',').first(16), after[row].split(',').first(16)) << "every number";
}

}  // namespace
}  // namespace noonmark
