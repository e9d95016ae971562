#include "app/gui/frame/window_menus.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "app/gui/base/looks/theme.h"
#include "app/gui/docks/export/movie_actions.h"
#include "app/gui/docks/project/saved_views.h"
#include "app/gui/frame/actions/edit_actions.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/frame/actions/region_actions.h"
#include "app/gui/frame/actions/result_actions.h"
#include "app/gui/frame/actions/saving_actions.h"
#include "app/gui/frame/actions/scenario_actions.h"
#include "app/gui/frame/actions/search_actions.h"
#include "app/gui/frame/actions/study_actions.h"
#include "app/gui/frame/actions/view_actions.h"
#include "app/gui/frame/help/help_actions.h"
#include "app/gui/frame/preferences/preferences_dialog.h"
#include "app/gui/frame/tour/tour.h"
#include "app/gui/tools/photograph/photograph_actions.h"
#include "app/gui/view/panel/view_presets.h"

namespace noonmark {

namespace {

// A tool button states its key; menus do so by themselves.
void addTool(QToolBar& bar, QAction* action) {
    const QString tip = action->toolTip().isEmpty() ? action->iconText() : action->toolTip();
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    if (!keys.isEmpty() && !tip.contains(keys)) action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, keys));
    bar.addAction(action);
}

}  // namespace

void fillToolBar(QToolBar& bar, const WindowActions& actions) {
    bar.setToolButtonStyle(Qt::ToolButtonIconOnly);
    const QList<QList<QAction*>> groups{
        {actions.opening.openAction(), actions.saving.actions().first()},
        actions.edits.undoActions(),
        {actions.study.runActions().first(), actions.region.actions().first(),
         actions.edits.toolActions().first()},
        {actions.view.cameraActions().first(), actions.results.fileActions().last()}};
    for (const QList<QAction*>& group : groups) {
        if (!bar.actions().isEmpty()) bar.addSeparator();
        for (QAction* action : group) addTool(bar, action);
    }
}

namespace {

QAction* fillFileMenu(QMenu& menu, const WindowActions& actions) {
    menu.addActions(actions.opening.actions());
    menu.addAction(actions.places.addAction());
    menu.addAction(actions.photograph.fileAction());
    menu.addSeparator();
    menu.addActions(actions.saving.actions());
    menu.addSeparator();
    menu.addActions(actions.results.fileActions());
    menu.addAction(actions.movies.action());
    menu.addSeparator();
    QAction* quit = menu.addAction(makeIcon(QStringLiteral("quit")), QObject::tr("&Quit"));
    quit->setShortcut(QKeySequence::Quit);
    return quit;
}

void fillEditMenu(QMenu& menu, const WindowActions& actions) {
    menu.addActions(actions.edits.undoActions());
    menu.addSeparator();
    menu.addActions(actions.copying.actions());
    menu.addSeparator();
    menu.addActions(actions.edits.toolActions());
    menu.addSeparator();
    menu.addAction(actions.search.action());
    menu.addSeparator();
    menu.addAction(actions.preferences.action());
}

void fillStudyMenu(QMenu& menu, const WindowActions& actions) {
    menu.addActions(actions.study.runActions());
    menu.addActions(actions.region.actions());
    menu.addAction(actions.results.saveResult());
    menu.addSeparator();
    menu.addActions(actions.places.actions());
    menu.addActions(actions.review.actions());
    actions.study.listQuestions(*menu.addMenu(QObject::tr("As&k")));
    menu.addSeparator();
    menu.addActions(actions.study.measureActions());
}

void fillViewMenu(QMenu& menu, const WindowActions& actions) {
    menu.addActions(actions.view.cameraActions());
    menu.addAction(actions.presets.parallel());
    menu.addMenu(QObject::tr("Plan, elevat&ions, from the sun"))->addActions(actions.presets.actions());
    menu.addMenu(actions.savedViews.menu());
    menu.addAction(actions.view.measure());
    menu.addAction(actions.view.sectionBox());
    menu.addSeparator();
    menu.addActions(actions.comparing);
    menu.addSeparator();
    menu.addAction(actions.view.solidBuildings());
    menu.addAction(actions.view.heightColours().action());
    menu.addAction(actions.view.mapOnGround());
    menu.addAction(actions.view.trees());
    menu.addAction(actions.photograph.showAction());
    menu.addAction(actions.towers.storeyLines());
    menu.addAction(actions.towers.aboveDatum());
    menu.addAction(actions.places.showAction());
    menu.addAction(actions.places.outlinesAction());
    menu.addAction(actions.sunDome);
    menu.addMenu(QObject::tr("S&un"))->addActions(actions.sun);
    menu.addMenu(QObject::tr("Mo&de"))->addActions(actions.modes);
    menu.addAction(actions.view.exploreByMaps());
    menu.addMenu(QObject::tr("&Panels"))->addActions(actions.docks);
    menu.addMenu(actions.themes);
}

}  // namespace

QAction* fillMenus(QMenuBar& bar, const WindowActions& actions) {
    QAction* quit = fillFileMenu(*bar.addMenu(QObject::tr("&File")), actions);
    fillEditMenu(*bar.addMenu(QObject::tr("&Edit")), actions);
    bar.addMenu(QObject::tr("S&cenario"))->addActions(actions.scenarios.actions());
    fillStudyMenu(*bar.addMenu(QObject::tr("&Study")), actions);
    fillViewMenu(*bar.addMenu(QObject::tr("&View")), actions);
    QMenu* help = bar.addMenu(QObject::tr("&Help"));
    help->addActions(
        {actions.help.guide(), actions.help.whatsThis(), actions.help.keys(), actions.help.start()});
    help->addMenu(QObject::tr("Guided &tours"))->addActions(actions.tours.actions());
    help->addSeparator();
    help->addAction(actions.help.about());
    return quit;
}

}  // namespace noonmark
