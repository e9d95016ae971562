#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>

#include "app/window/editing/building_editing.h"
#include "app/window/elements/elements_dock.h"
#include "app/window/export/table_text.h"
#include "app/window/study_form/run_forecast.h"
#include "app/window/study_form/study_dock.h"
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
        const auto before = workbench().elements();
        workbench().run();
        ASSERT_TRUE(waitFor([&] { return workbench().elements() && workbench().elements() != before; }))
            << window->panel().messages().text().toStdString();
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

TEST_F(ElementsWindow, ARunPaintsTilesAndFillsTheTable) {
    choose({});
    measure();
    const ElementMap& map = workbench().elements()->map;
    ASSERT_GT(map.elements.size(), 100U);
    EXPECT_EQ(workbench().shown(), Workbench::Shown::elements);
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
    const ElementMap& map = workbench().elements()->map;
    table().sortByColumn(ElementModel::sun, Qt::DescendingOrder);
    const double most =
        std::ranges::max_element(map.elements, {}, &MeasuredElement::sunlitMin)->sunlitMin / 60;
    EXPECT_EQ(rows().index(0, ElementModel::sun).data(ElementModel::valueRole).toDouble(), most);
    table().selectRow(0);
    ASSERT_EQ(tiles().highlighted().size(), 1U);
    EXPECT_EQ(map.elements[tiles().highlighted()[0]].sunlitMin / 60, most);
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
    Q_EMIT dock().wanted(20);
    const CityView& view = window->panel().view();
    const auto middle = workbench().elements()->map.elements[20];
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
    EXPECT_EQ(workbench().elements(), nullptr);
    EXPECT_TRUE(tiles().tiles().empty());
    EXPECT_EQ(rows().rowCount(), 0);
}

TEST_F(ElementsWindow, TheFacadesOfATowerThatIsBuiltAreMeasured) {
    choose({});
    session().goTo("Tower");
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    measure();
    const auto& elements = workbench().elements()->map.elements;
    const auto ofTower = std::ranges::count(elements, "New", &MeasuredElement::building);
    EXPECT_GT(ofTower, 20);
    const auto before = workbench().elements();
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    ASSERT_TRUE(waitFor([&] { return workbench().elements() && workbench().elements() != before; }))
        << "a quick result is computed again";
    EXPECT_LT(std::ranges::count(workbench().elements()->map.elements, "New", &MeasuredElement::building),
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
    EXPECT_EQ(workbench().elements(), nullptr);
}

TEST_F(ElementsWindow, APlaneIsMeasuredAboveTheGround) {
    choose({.places = ElementPlaces::plane, .planeHeightM = 4});
    measure();
    const ElementMap& map = workbench().elements()->map;
    EXPECT_NEAR(map.elements[0].position.z, workbench().elements()->study.planeM, 1e-4);
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
    ASSERT_TRUE(waitFor([&] { return workbench().elements() != nullptr; }))
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
