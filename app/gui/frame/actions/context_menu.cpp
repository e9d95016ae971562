#include "app/gui/frame/actions/context_menu.h"

#include <QClipboard>
#include <QCursor>
#include <QGuiApplication>
#include <algorithm>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/frame/actions/region_actions.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/report/sheets/study_text.h"

namespace noonmark {

namespace {

QString nameOfBuilding(const Building& building) {
    QString name = QString::fromStdString(building.name.empty() ? building.sourceId : building.name);
    return name.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

// Places may lie inside each other; the menu names those that the cursor is in.
bool isIn(const Place& place, glm::dvec2 point) {
    return std::ranges::any_of(place.polygons,
                               [&](const Footprint& polygon) { return contains(polygon, point); });
}

}  // namespace

ContextMenu::ContextMenu(Workbench& workbench, EditTools& tools, RegionActions& region, PlaceActions& places,
                         PointInspector& points, ViewPanel& panel)
    : workbench_(workbench), tools_(tools), region_(region), places_(places), points_(points), panel_(panel) {
    connect(&panel_, &ViewPanel::menuRequested, this, &ContextMenu::popUp);
}

void ContextMenu::popUp(QPointF pixel) {
    if (panel_.drawing() || tools_.tower().active() || tools_.mesh().active()) return;
    std::unique_ptr<QMenu> menu = makeMenu(pixel);
    if (menu->isEmpty()) return;
    QMenu* shown = menu.release();
    shown->setAttribute(Qt::WA_DeleteOnClose);
    shown->popup(QCursor::pos());
}

std::unique_ptr<QMenu> ContextMenu::makeMenu(QPointF pixel) {
    auto menu = std::make_unique<QMenu>();
    if (!workbench_.city()) return menu;
    const auto pick = panel_.navigator().pickAt(pixel);
    if (!pick) return menu;
    const glm::dvec2 at{pick->position.x, pick->position.y};
    if (pick->building)
        addBuilding(*menu, *pick->building);
    else
        addPlaces(*menu, at);
    addLots(*menu, at);
    addGround(*menu, *pick);
    return menu;
}

void ContextMenu::addBuilding(QMenu& menu, std::uint32_t building) {
    menu.addSection(nameOfBuilding(*workbench_.city()->city().buildings[building]));
    const auto add = [&](const QString& icon, const QString& text, const std::function<void()>& done) {
        menu.addAction(makeIcon(icon), text, this, [this, building, done] {
            tools_.building().select(building);
            done();
        });
    };
    add(QStringLiteral("find"), tr("Select"), [] {});
    add(QStringLiteral("tower"), tr("Replace by tower"), [this] { tools_.replace(); });
    add(QStringLiteral("slanted-view"), tr("Move"), [this] { tools_.building().setMoving(true); });
    const auto& all = tools_.building().all();
    if (all.size() > 1 && std::ranges::find(all, building) != all.end())
        menu.addAction(makeIcon(QStringLiteral("delete")),
                       tr("Demolish the %1 selected").arg(formatCount(all.size())), &tools_.building(),
                       &BuildingEditing::demolish);
    else
        add(QStringLiteral("delete"), tr("Demolish"), [this] { tools_.building().demolish(); });
    add(QStringLiteral("region"), tr("Study its surroundings"),
        [this, building] { region_.takeSurroundings(building); });
    add(QStringLiteral("place"), tr("Make its outline a place"), [this] { places_.makeFromBuilding(); });
}

void ContextMenu::addPlaces(QMenu& menu, glm::dvec2 at) {
    for (const Place& place : workbench_.session().project().places) {
        if (!isIn(place, at)) continue;
        QString title = placeName(place.name);
        menu.addSection(title.replace(QLatin1Char('&'), QStringLiteral("&&")));
        menu.addAction(makeIcon(QStringLiteral("region")), tr("Study this place"), this,
                       [this, name = place.name] { region_.takeNamed(name); });
        menu.addAction(makeIcon(QStringLiteral("whole-city")), tr("Zoom to it"), this,
                       [this, name = place.name] { places_.zoomTo(name); });
    }
}

void ContextMenu::addLots(QMenu& menu, glm::dvec2 at) {
    for (const NamedLot& lot : workbench_.session().project().lots) {
        if (!contains(lot.outline, at)) continue;
        QString title = QString::fromStdString(lot.name);
        menu.addSection(title.replace(QLatin1Char('&'), QStringLiteral("&&")));
        menu.addAction(makeIcon(QStringLiteral("lot")), tr("Edit lot"), this,
                       [this, lot] { tools_.editLot(lot); });
    }
}

void ContextMenu::addGround(QMenu& menu, const Pick& pick) {
    const glm::dvec2 at(pick.position);
    menu.addSection(tr("Here"));
    menu.addAction(makeIcon(QStringLiteral("sun")), tr("Sun and sky here"), &points_,
                   [this, pick] { points_.inspect(pick); });
    menu.addAction(makeIcon(QStringLiteral("lot")), tr("Draw lot"), &tools_, &EditTools::drawLot);
    menu.addAction(makeIcon(QStringLiteral("place")), tr("Draw place"), &places_, [this] { places_.draw(); });
    menu.addAction(makeIcon(QStringLiteral("region")), tr("Draw region"), region_.actions().first(),
                   &QAction::trigger);
    menu.addAction(tr("Measure from here"), this, [this, pick] {
        panel_.setUnits(workbench_.session().project().sheets.units);
        panel_.measureTool().begin();
        panel_.measureTool().addPoint(pick.position);
    });
    const QString position = describeLatLon(workbench_.city()->city().frame.lonLatFromLocal(at));
    menu.addAction(makeIcon(QStringLiteral("copy")), tr("Copy position: %1").arg(position), this,
                   [position] { QGuiApplication::clipboard()->setText(position); });
}

}  // namespace noonmark
