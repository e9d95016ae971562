#include "app/gui/frame/actions/region_actions.h"

#include <QUndoStack>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "core/io/read_region.h"
#include "core/receivers/made_names.h"
#include "core/receivers/place_names.h"

namespace noonmark {

RegionActions::RegionActions(Workbench& workbench, ViewPanel& panel, StudyDock& study, ProjectDock& tree,
                             QWidget& window)
    : workbench_(workbench),
      panel_(panel),
      study_(study),
      window_(window),
      draw_(makeAction(this, tr("&Draw region"), QKeySequence(tr("Ctrl+D")),
                       tr("Click corners on the ground; Enter finishes, Esc cancels"), "region")),
      fromFile_(makeAction(this, tr("Region from &file..."), QKeySequence(),
                           tr("Polygons from a file, in any coordinate system"))) {
    PolygonTool& tool = panel_.regionTool();
    connect(draw_, &QAction::triggered, this, [this] { draw(true); });
    connect(fromFile_, &QAction::triggered, this, &RegionActions::readFile);
    connect(&tool, &PolygonTool::activeChanged, &study_, &StudyDock::setDrawing);
    connect(&tool, &PolygonTool::finished, this, &RegionActions::takeDrawn);
    connectDocks(tree);
}

void RegionActions::connectDocks(ProjectDock& tree) {
    connect(&study_, &StudyDock::drawRequested, this, &RegionActions::draw);
    connect(&study_, &StudyDock::viewRegionRequested, this, [this] { change(panel_.visibleGround()); });
    connect(&study_, &StudyDock::wholeCityRequested, this, &RegionActions::takeWholeCity);
    connect(&study_, &StudyDock::regionNamed, this,
            [this](const QString& name) { takeNamed(name.toStdString()); });
    connect(&workbench_.session(), &ProjectSession::changed, this, &RegionActions::listNames);
    connect(&tree, &ProjectDock::useAsRegionRequested, this, &RegionActions::takeNamed);
    connect(&tree, &ProjectDock::regionChosen, this, &RegionActions::change);
    connect(&tree, &ProjectDock::useAsRegionRequested, this, &RegionActions::taken);
    connect(&tree, &ProjectDock::regionChosen, this, &RegionActions::taken);
    connect(&tree, &ProjectDock::saveRegionRequested, this, &RegionActions::saveInProject);
}

void RegionActions::draw(bool on) {
    PolygonTool& tool = panel_.regionTool();
    if (on && workbench_.city())
        tool.begin();
    else
        tool.cancel();
    study_.setDrawing(tool.active());
    panel_.view().requestActivate();  // the view receives the keys that finish or cancel the polygon
}

void RegionActions::change(const Region& region) {
    if (region.polygons.empty())
        return panel_.messages().showError({QT_TRANSLATE_NOOP("Error", "No ground of the city is visible"),
                                            {},
                                            QT_TRANSLATE_NOOP("Error", "Move the view to the city first")});
    StudySettings settings = workbench_.document().settings();
    settings.region = region;
    workbench_.document().change(settings, tr("region"));
}

// A drawn region is user work, so it is added to the project under its own name, in one undo step together
// with the change of the study.
void RegionActions::takeDrawn(const std::vector<Footprint>& pieces) {
    Project next = workbench_.session().project();
    const Region region{freeName(next, ProjectPart::region, "Region"), pieces};
    next.regions.push_back(region);
    const QString what = tr("draw %1").arg(QString::fromStdString(region.name));
    QUndoStack& undo = workbench_.document().undoStack();
    undo.beginMacro(what);
    if (workbench_.session().change(std::move(next), what)) change(region);
    undo.endMacro();
    Q_EMIT taken();
}

void RegionActions::takeWholeCity() {
    if (!workbench_.city()) return;
    Region all = makeRegionFromLocalBox(panel_.view().viewBounds().box);
    all.name = madeNames::wholeCity;
    change(all);
}

void RegionActions::takeSurroundings(std::uint32_t building) {
    const City& city = workbench_.city()->city();
    if (building >= city.buildings.size()) return;
    const Building& middle = *city.buildings[building];
    const Box2 box = bounds(middle);
    const double ground = groundAt(city, glm::dvec2(box.low + box.high) / 2.0);
    const auto reach = float(std::max(50.0, 4 * (double(topM(middle)) - ground)));
    Region around = makeRegionFromLocalBox({box.low - glm::vec2(reach), box.high + glm::vec2(reach)});
    around.name = middle.name.empty() ? std::string(madeNames::aroundBuilding)
                                      : makeName(madeNames::around, {middle.name});
    change(around);
}

// A region of the project, or a place; the error suggests names that are spelled alike.
void RegionActions::takeNamed(const std::string& name) {
    const Project& project = workbench_.session().project();
    if (name == workbench_.document().settings().region.name) return;
    if (const auto region = findRegion(project, name)) return change(*region);
    const auto place = findPlace(project, name);
    if (place) return change(regionOf(*place));
    Error error = place.error();
    error.what = QT_TRANSLATE_NOOP("Error", "There is no region or place of this name");
    if (error.advice.find("noonmark-cli") != std::string::npos)
        error.advice = QT_TRANSLATE_NOOP("Error", "Choose one from the list");
    panel_.messages().showError(error);
}

void RegionActions::listNames() {
    const Project& project = workbench_.session().project();
    QStringList names;
    for (const Region& region : project.regions) names << QString::fromStdString(region.name);
    QStringList places;
    for (const Place& place : project.places) places << QString::fromStdString(place.name);
    places.sort(Qt::CaseInsensitive);
    study_.setRegions(names + places);
}

void RegionActions::readFile() {
    const QString file = workbench_.city() ? askForRegion(&window_) : QString();
    if (file.isEmpty()) return;
    const auto region = readRegion(file.toStdString(), workbench_.city()->city().frame);
    if (!region) return panel_.messages().showError(region.error());
    change(*region);
    Q_EMIT taken();
}

void RegionActions::saveInProject() {
    Project next = workbench_.session().project();
    Region region = workbench_.document().settings().region;
    region.name = freeName(next, ProjectPart::region, region.name.empty() ? "Region" : region.name);
    const QString what = tr("save region %1").arg(QString::fromStdString(region.name));
    next.regions.push_back(std::move(region));
    workbench_.session().change(std::move(next), what);
}

}  // namespace noonmark
