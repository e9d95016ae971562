#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QTreeView>
#include <QUndoStack>
#include <algorithm>

#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/project/project_model.h"
#include "core/receivers/place_names.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;

struct PlacesWindow : test::ProjectWindow {
    ProjectDock& tree() { return *window->findChild<ProjectDock*>(); }
    [[nodiscard]] const std::vector<Place>& places() { return session().project().places; }
    QUndoStack& undo() { return workbench().document().undoStack(); }

    // Two squares of about 80 m beside the small city, the first named and with a kind.
    QString polygonFile(const char* firstName = "Green") {
        const QString name = folder.filePath(QStringLiteral("parks.geojson"));
        QFile file(name);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        const auto ring = [](double west) {
            return QStringLiteral("[[[%1,40.7605],[%2,40.7605],[%2,40.7612],[%1,40.7612],[%1,40.7605]]]")
                .arg(west, 0, 'f', 4)
                .arg(west + 0.001, 0, 'f', 4);
        };
        const auto feature = [&](double west, const QString& properties) {
            return QStringLiteral(
                       R"({"type":"Feature","properties":{%1},"geometry":{"type":"Polygon","coordinates":%2}})")
                .arg(properties, ring(west));
        };
        file.write(
            QStringLiteral(R"({"type":"FeatureCollection","features":[%1,%2]})")
                .arg(feature(-73.9805,
                             QStringLiteral(R"("name":"%1","kind":"plaza")").arg(QLatin1String(firstName))),
                     feature(-73.9795, QStringLiteral(R"("name":"Court","kind":"playground")")))
                .toUtf8());
        return name;
    }
    void add(const QString& name) {
        window->places().addFiles({name});
        ASSERT_TRUE(waitFor([this] { return !window->places().reading().busy(); }));
    }
    void read(const QString& name) {
        window->places().read({name});
        ASSERT_TRUE(waitFor([this] { return !window->places().reading().busy(); }));
    }
};

TEST_F(PlacesWindow, AFileOfPolygonsBecomesPlacesInTheTreeAndOneUndoRemovesThem) {
    read(polygonFile());
    ASSERT_EQ(places().size(), 2U) << message().toStdString();
    EXPECT_EQ(places()[0].kind, PlaceKind::plaza);
    EXPECT_TRUE(message().startsWith(QStringLiteral("2 places were read")));
    const QModelIndex green = tree().model().indexOf(ProjectPart::place, "Green");
    ASSERT_TRUE(green.isValid());
    EXPECT_TRUE(green.data().toString().contains(QStringLiteral("plaza, ")));
    undo().undo();
    EXPECT_TRUE(places().empty());
}

TEST_F(PlacesWindow, AnEntryStaysSelectedUnderItsNewName) {
    read(polygonFile());
    auto& view = *tree().findChild<QTreeView*>(QStringLiteral("projectTree"));
    tree().select(ProjectPart::place, "Green");
    ASSERT_TRUE(tree().model().setData(view.currentIndex(), QStringLiteral("Our green")));
    const ProjectNode* node = tree().model().nodeAt(view.currentIndex());
    ASSERT_TRUE(node);
    EXPECT_EQ(node->name, "Our green");
}

TEST_F(PlacesWindow, AFileReadAgainReplacesItsPlacesAndKeepsNamesGivenByTheUser) {
    read(polygonFile());
    ASSERT_TRUE(session().rename(ProjectPart::place, "Green", "Our green"));
    read(polygonFile("Grass"));
    ASSERT_EQ(places().size(), 2U);
    EXPECT_EQ(places()[0].name, "Our green");
    EXPECT_TRUE(message().contains(QStringLiteral("2 replace earlier ones")));
}

TEST_F(PlacesWindow, AFileAddedToTheCityReplacesNoPlace) {
    read(polygonFile());
    tree().setKind("Green", PlaceKind::cemetery);
    const int steps = undo().count();
    add(polygonFile("Grass"));
    ASSERT_EQ(places().size(), 2U);
    EXPECT_EQ(places()[0].name, "Green");
    EXPECT_EQ(places()[0].kind, PlaceKind::cemetery);
    EXPECT_EQ(undo().count(), steps) << "nothing changed";
    EXPECT_TRUE(message().contains(QStringLiteral("2 places were there before"))) << message().toStdString();
}

TEST_F(PlacesWindow, AnotherFileOfTheSameNameIsAddedBesideTheFirst) {
    read(polygonFile());
    QFile file(polygonFile());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray moved = file.readAll().replace("40.7612", "40.7610");
    QDir(folder.path()).mkdir(QStringLiteral("other"));
    QFile other(folder.filePath(QStringLiteral("other/parks.geojson")));
    ASSERT_TRUE(other.open(QIODevice::WriteOnly));
    other.write(moved);
    other.close();
    add(other.fileName());
    ASSERT_EQ(places().size(), 4U) << message().toStdString();
    EXPECT_NE(places()[2].name, places()[0].name);
}

TEST_F(PlacesWindow, TheSampleHasItsParkAndStreetsOnRequest) {
    open(QStringLiteral("sample:central-park-south"));
    ASSERT_EQ(places().size(), 1U);
    EXPECT_EQ(places()[0].name, "Central Park");
    window->places().readStreets();
    ASSERT_TRUE(waitFor([this] { return !window->places().reading().busy(); }));
    EXPECT_GT(std::ranges::count(places(), PlaceKind::street, &Place::kind), 300);
    EXPECT_EQ(std::ranges::count(places(), PlaceKind::park, &Place::kind), 1);
}

TEST_F(PlacesWindow, KindNameAndRemovalAreUndone) {
    read(polygonFile());
    tree().setKind("Green", PlaceKind::cemetery);
    EXPECT_EQ(places()[0].kind, PlaceKind::cemetery);
    undo().undo();
    EXPECT_EQ(places()[0].kind, PlaceKind::plaza);
    tree().remove(tree().model().indexOf(ProjectPart::place, "Green"));
    EXPECT_EQ(places().size(), 1U);
    undo().undo();
    EXPECT_EQ(places()[0].name, "Green");
}

TEST_F(PlacesWindow, PlacesAreNamedInTheViewAndOneIsZoomedTo) {
    read(polygonFile());
    PlaceMarks& marks = window->panel().view().places();
    tree().use(tree().model().indexOf(ProjectPart::place, "Court"));
    const CameraPose pose = window->panel().view().pose();
    const Box2 box = bounds(places()[1]);
    EXPECT_GT(pose.target.x, double(box.low.x));
    EXPECT_LT(pose.target.x, double(box.high.x));
    // The names of the view before may still stand there.
    ASSERT_TRUE(waitFor([&] { return !marks.named().empty() && marks.named().front() == 1U; }));
    marks.setShown(false);
    ASSERT_TRUE(waitFor([&] { return marks.named().size() == 1; }));  // the chosen one stays
}

TEST_F(PlacesWindow, OnlyChosenPlacesAndThatUnderTheCursorHaveOutlines) {
    read(polygonFile());
    PlaceMarks& marks = window->panel().view().places();
    EXPECT_EQ(marks.outlined(), places().size()) << "they were just read";
    window->places().outlinesAction()->setChecked(false);
    EXPECT_EQ(marks.outlined(), 0U);
    marks.hover(0);
    EXPECT_EQ(marks.outlined(), 1U);
    tree().use(tree().model().indexOf(ProjectPart::place, "Court"));
    EXPECT_EQ(marks.outlined(), 2U);
    marks.hover(std::nullopt);
    EXPECT_EQ(marks.outlined(), 1U) << "the chosen one stays";
    window->places().outlinesAction()->setChecked(true);
    EXPECT_EQ(marks.outlined(), places().size());
}

TEST_F(PlacesWindow, ANameStandsAboveAPlaceThatIsSmallerOnTheScreen) {
    read(polygonFile());
    PlaceMarks& marks = window->panel().view().places();
    const CityView& view = window->panel().view();
    window->panel().navigator().show(bounds(places()[1]));
    ASSERT_TRUE(waitFor([&] { return !marks.named().empty(); }));
    marks.highlight(1);
    CameraPose pose = view.pose();
    marks.layNames(pose, view.lens());
    ASSERT_EQ(marks.named().front(), 1U);
    EXPECT_EQ(marks.labels().shown().front().raisedPx, 0) << "within its place";
    pose.distanceM *= 20;
    marks.layNames(pose, view.lens());
    ASSERT_EQ(marks.named().front(), 1U);
    EXPECT_GE(marks.labels().shown().front().raisedPx,
              NameLabels::sizeOf(QStringLiteral("Court")).height() / 2);
}

TEST_F(PlacesWindow, ANameThatSomethingHidesIsLeftOut) {
    read(polygonFile());
    PlaceMarks& marks = window->panel().view().places();
    const CityView& view = window->panel().view();
    window->panel().navigator().show(bounds(places()[1]));
    ASSERT_TRUE(waitFor([&] { return !marks.named().empty(); }));
    marks.hideNamesWhere([](const glm::dvec3&) { return true; });
    marks.layNames(view.pose(), view.lens());
    EXPECT_TRUE(marks.named().empty());
}

TEST_F(PlacesWindow, NamesLeaveTogetherWithTheirCity) {
    read(polygonFile());
    PlaceMarks& marks = window->panel().view().places();
    window->panel().navigator().show(bounds(places()[1]));
    ASSERT_TRUE(waitFor([&] { return marks.named() == std::vector<std::size_t>{1}; }));
    window->panel().showPlaces({places()[1]});
    EXPECT_EQ(marks.named(), std::vector<std::size_t>{0}) << "a name whose place is still there stays";
    std::optional<std::size_t> named;
    QObject::connect(&workbench(), &Workbench::cityShown, window.get(),
                     [&] { named = marks.named().size(); });
    workbench().open({QStringLiteral("sample:grid")});
    ASSERT_TRUE(waitFor([&] { return named.has_value(); }));
    EXPECT_EQ(*named, 0U) << "before the camera rests";
}

TEST_F(PlacesWindow, TheRegionListTakesAPlaceByItsNameAndSuggestsOneForAMistypedName) {
    read(polygonFile());
    auto* list = window->findChild<QComboBox*>(QStringLiteral("regionList"));
    EXPECT_EQ(list->count(), 3);  // Square, Court, Green
    list->lineEdit()->setText(QStringLiteral("court"));
    Q_EMIT list->lineEdit()->returnPressed();
    const Region& region = workbench().document().settings().region;
    EXPECT_EQ(region.name, "Court");
    EXPECT_EQ(region.polygons, places()[1].polygons);
    list->lineEdit()->setText(QStringLiteral("Courd"));
    Q_EMIT list->lineEdit()->returnPressed();
    EXPECT_EQ(workbench().document().settings().region.name, "Court");
    EXPECT_TRUE(message().contains(QStringLiteral("Court"))) << message().toStdString();
}

TEST_F(PlacesWindow, AnOutlineAndADrawingBecomePlacesWithNamesOfTheirOwn) {
    const auto& buildings = workbench().city()->city().buildings;
    window->tools().building().select(1);
    window->places().makeFromBuilding();
    ASSERT_EQ(places().size(), 1U);
    EXPECT_EQ(places()[0].name, buildings[1]->name);
    EXPECT_NEAR(area(places()[0]), 900, 0.1);
    PolygonTool& tool = window->panel().placeTool();
    for (int i = 0; i < 2; ++i) {
        window->places().draw();
        for (const glm::dvec3 corner : {glm::dvec3(0, 100, 0), {40, 100, 0}, {40, 140, 0}})
            tool.addPoint(corner);
        tool.finish();
    }
    ASSERT_EQ(places().size(), 3U);
    EXPECT_EQ(places()[1].name, "Place");
    EXPECT_EQ(places()[2].name, "Place (2)");
    EXPECT_NEAR(area(places()[2]), 800, 0.1);
}

TEST_F(PlacesWindow, DroppedPolygonsAreReadOrOpenedAsTheUserChooses) {
    const QString file = polygonFile();
    window->places().setDropQuestion([] { return PlaceActions::Dropped::nothing; });
    window->places().takeDropped({file});
    EXPECT_FALSE(window->places().reading().busy());
    window->places().setDropQuestion([] { return PlaceActions::Dropped::readPlaces; });
    window->places().takeDropped({file});
    ASSERT_TRUE(waitFor([this] { return places().size() == 2; }));
    EXPECT_EQ(workbench().city()->city().buildings.size(), 3U);
}

// A box of 10 m, 10 m high, in the metres and axes of OBJ files (y is up).
TEST_F(PlacesWindow, ADroppedMeshIsPlacedOnTheLotUnderTheCursor) {
    const QString name = folder.filePath(QStringLiteral("box.obj"));
    QFile box(name);
    ASSERT_TRUE(box.open(QIODevice::WriteOnly));
    box.write(
        "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    box.close();
    session().addLot({"Lot 1", test::square({-60, -60}, 40)});
    CityView& view = window->panel().view();
    view.setPose({{-50, -50, 0}, 300, 0, 90});
    const auto corner = pixelOf(view.pose(), view.lens(), {-57, -58, 0});
    window->places().takeDropped({name}, QPointF(corner->x, corner->y));
    ASSERT_TRUE(waitFor([this] { return window->tools().mesh().active(); }, 10000));
    ASSERT_TRUE(waitFor([this] { return window->tools().context().preview.shown(); }));
    window->tools().mesh().build();
    ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 4; }));
    const glm::dvec2 middle = findMiddle(*workbench().city()->city().buildings.back());
    EXPECT_NEAR(middle.x, -40, 0.01) << "the middle of the lot, not the cursor";
    EXPECT_NEAR(middle.y, -40, 0.01);
    workbench().document().undoStack().undo();
    ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 3; }));
    QFile bad(folder.filePath(QStringLiteral("bad.obj")));
    ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
    bad.write("v 0 0\n");
    bad.close();
    window->places().takeDropped({bad.fileName()}, QPointF(10, 10));
    EXPECT_TRUE(waitFor([this] { return message().contains(QStringLiteral("bad.obj")); }));
}

TEST_F(PlacesWindow, AFileWithoutPolygonsIsRefused) {
    QFile bad(folder.filePath(QStringLiteral("bad.geojson")));
    ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
    bad.write("{\"type\":");
    bad.close();
    read(bad.fileName());
    EXPECT_TRUE(places().empty());
    EXPECT_FALSE(message().isEmpty());
}

// Nobody but the user knows whether houses or lawns are the places.
TEST_F(PlacesWindow, OfSeveralLayersWithoutKindsOneIsAskedFor) {
    const auto folderOf = [](const char* name, double west) {
        return QStringLiteral(
                   "<Folder><name>%1</name><Placemark><name>%1 1</name><Polygon><outerBoundaryIs>"
                   "<LinearRing><coordinates>%2,40.7605 %3,40.7605 %3,40.7612 %2,40.7612 "
                   "%2,40.7605</coordinates></LinearRing></outerBoundaryIs></Polygon>"
                   "</Placemark></Folder>")
            .arg(QLatin1String(name))
            .arg(west, 0, 'f', 4)
            .arg(west + 0.001, 0, 'f', 4);
    };
    QFile file(folder.filePath(QStringLiteral("layers.kml")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QStringLiteral("<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>%1%2</Document></kml>")
                   .arg(folderOf("houses", -73.9805), folderOf("lawns", -73.9795))
                   .toUtf8());
    file.close();
    read(file.fileName());
    EXPECT_TRUE(places().empty()) << "houses are no parks";
    auto* layer = window->findChild<QComboBox*>(QStringLiteral("placeLayer"));
    auto* kind = window->findChild<QComboBox*>(QStringLiteral("placeKind"));
    ASSERT_TRUE(layer && kind);
    ASSERT_EQ(layer->count(), 2);
    layer->setCurrentIndex(1);
    kind->setCurrentIndex(kind->findData(int(PlaceKind::schoolyard)));
    qobject_cast<QDialog*>(layer->window())->findChild<QDialogButtonBox*>()->accepted();
    ASSERT_TRUE(waitFor([this] { return places().size() == 1; }));
    EXPECT_EQ(places()[0].name, "lawns 1");
    EXPECT_EQ(places()[0].kind, PlaceKind::schoolyard);
}

TEST_F(PlacesWindow, RoadsAlongALotAreAnUndoStep) {
    session().addLot({"Corner", {{{0, 0}, {20, 0}, {20, 30}, {0, 30}}, {}}, {{ParcelSide::east, 12}}});
    const auto roads = [&] { return findLot(session().project(), "Corner")->roads; };
    tree().askForRoads("Corner");
    auto* dialog = tree().findChild<LotRoadsDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->roads(), roads());
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("south"))->setValue(8);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("east"))->setValue(0);
    dialog->accept();
    EXPECT_EQ(roads(), (std::vector<RoadFront>{{ParcelSide::south, 8}}));
    workbench().document().undoStack().undo();
    EXPECT_EQ(roads(), (std::vector<RoadFront>{{ParcelSide::east, 12}}));
}

}  // namespace
}  // namespace noonmark
